// SPDX-License-Identifier: MIT
#include "polhode/io/frame.hpp"

#include <fmt/core.h>

#include <cmath>

namespace polhode {
namespace {

// J⁻¹ L, where a vanishing moment holds no angular momentum.
double over(double L, double J) { return J > 0 ? L / J : 0.0; }

}  // namespace

Frame frame_of(const State& state, const Topology& topology, MasslessSites massless) {
  Frame frame;
  frame.title = fmt::format("polhode t= {:.6f}", state.time);  // GROMACS finds the time here
  frame.box = state.box;
  frame.time = state.time;
  frame.has_velocities = true;
  const Vec3<double> edge = state.box.edge;
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      const Vec3<double> q = state.q[i];
      const Vec3<double> home{q.x - edge.x * std::floor(q.x / edge.x),
                              q.y - edge.y * std::floor(q.y / edge.y),
                              q.z - edge.z * std::floor(q.z / edge.z)};
      const Vec3<double> L = to_body(state.attitude[i], state.ell[i]);
      const Vec3<double> J = molecule.J;
      const Vec3<double> omega =
          to_lab(state.attitude[i], {over(L.x, J.x), over(L.y, J.y), over(L.z, J.z)});
      for (const Site& site : molecule.sites) {
        if (massless == MasslessSites::left_out && site.mass == 0) continue;
        const Vec3<double> x = to_lab(state.attitude[i], site.r);
        frame.atoms.push_back({.residue = static_cast<int>(i % 100000) + 1,
                               .residue_name = molecule.name,
                               .name = site.name,
                               .element = site.element,
                               .r = home + x,
                               .v = state.p[i] / molecule.mass + cross(omega, x)});
      }
    }
  }
  return frame;
}

}  // namespace polhode
