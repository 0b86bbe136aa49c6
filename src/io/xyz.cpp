// SPDX-License-Identifier: MIT
#include "polhode/io/xyz.hpp"

#include "polhode/io/quantity.hpp"
#include "text_buffer.hpp"

namespace polhode {
namespace {

// Writes a frame line by line.
class XyzLines {
 public:
  XyzLines(std::ostream& out, const std::vector<AtomKind>& kinds, bool velocities)
      : text_(out), velocities_(velocities) {
    for (const AtomKind& kind : kinds)
      species_.push_back(fmt::format("{:<2}", kind.element.empty() ? "X" : kind.element));
  }

  void head(std::size_t atoms, const Box& box, double time) {
    const Vec3<double> edge = box.edge / angstrom_;
    text_.print(
        "{}\nLattice=\"{:.10g} 0 0 0 {:.10g} 0 0 0 {:.10g}\" Properties=species:S:1:pos:R:3{} "
        "Time={:.6f} pbc=\"T T T\"\n",
        atoms, edge.x, edge.y, edge.z, velocities_ ? ":velo:R:3" : "", time);
  }
  void atom(const Atom& atom) {
    text_.append(species_[atom.kind]);
    vector(atom.r / angstrom_);
    if (velocities_) vector(atom.v / angstrom_);
    text_.end_line();
  }

 private:
  void vector(const Vec3<double>& v) {
    for (std::size_t k = 0; k < 3; ++k) {
      text_.append(" ");
      text_.fixed(v[k], 14, 8);
    }
  }

  TextBuffer text_;
  std::vector<std::string> species_;  // of each kind
  bool velocities_;
  double angstrom_ = unit("A", Dimension::length);
};

}  // namespace

void write_xyz(std::ostream& out, const Frame& frame) {
  XyzLines lines(out, frame.kinds, frame.has_velocities);
  lines.head(frame.atoms.size(), frame.box, frame.time);
  for (const Atom& atom : frame.atoms) lines.atom(atom);
}

void write_xyz(std::ostream& out, const State& state, const Topology& topology) {
  XyzLines lines(out, atom_kinds(topology, MasslessSites::kept), true);
  lines.head(atom_count(topology), state.box, state.time);
  each_atom(state, topology, MasslessSites::kept, [&](const Atom& atom) { lines.atom(atom); });
}

}  // namespace polhode
