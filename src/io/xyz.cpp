// SPDX-License-Identifier: MIT
#include "polhode/io/xyz.hpp"

#include "polhode/io/quantity.hpp"
#include "text_buffer.hpp"

namespace polhode {
namespace {

// Writes a frame line by line.
class XyzLines {
 public:
  XyzLines(std::ostream& out, bool velocities) : text_(out), velocities_(velocities) {}

  void head(std::size_t atoms, const Box& box, double time) {
    const Vec3<double> edge = box.edge / angstrom_;
    text_.print(
        "{}\nLattice=\"{:.10g} 0 0 0 {:.10g} 0 0 0 {:.10g}\" Properties=species:S:1:pos:R:3{} "
        "Time={:.6f} pbc=\"T T T\"\n",
        atoms, edge.x, edge.y, edge.z, velocities_ ? ":velo:R:3" : "", time);
  }
  void atom(const Atom& atom) {
    text_.print("{:<2}", atom.element.empty() ? std::string_view("X") : atom.element);
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
  bool velocities_;
  double angstrom_ = unit("A", Dimension::length);
};

}  // namespace

void write_xyz(std::ostream& out, const Frame& frame) {
  XyzLines lines(out, frame.has_velocities);
  lines.head(frame.atoms.size(), frame.box, frame.time);
  for (const Atom& atom : frame.atoms) lines.atom(atom);
}

void write_xyz(std::ostream& out, const State& state, const Topology& topology) {
  XyzLines lines(out, true);
  lines.head(atom_count(topology), state.box, state.time);
  each_atom(state, topology, MasslessSites::kept, [&](const Atom& atom) { lines.atom(atom); });
}

}  // namespace polhode
