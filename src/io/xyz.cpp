// SPDX-License-Identifier: MIT
#include "polhode/io/xyz.hpp"

#include <fmt/core.h>

#include <ostream>

#include "polhode/io/quantity.hpp"

namespace polhode {

void write_xyz(std::ostream& out, const Frame& frame) {
  const double angstrom = unit("A", Dimension::length);
  const Vec3<double> edge = frame.box.edge / angstrom;
  out << fmt::format(
      "{}\nLattice=\"{:.10g} 0 0 0 {:.10g} 0 0 0 {:.10g}\" Properties=species:S:1:pos:R:3{} "
      "Time={:.6f} pbc=\"T T T\"\n",
      frame.atoms.size(), edge.x, edge.y, edge.z, frame.has_velocities ? ":velo:R:3" : "",
      frame.time);
  for (const Atom& atom : frame.atoms) {
    const Vec3<double> r = atom.r / angstrom, v = atom.v / angstrom;
    out << fmt::format("{:<2} {:14.8f} {:14.8f} {:14.8f}",
                       atom.element.empty() ? "X" : atom.element, r.x, r.y, r.z);
    if (frame.has_velocities) out << fmt::format(" {:14.8f} {:14.8f} {:14.8f}", v.x, v.y, v.z);
    out << '\n';
  }
}

}  // namespace polhode
