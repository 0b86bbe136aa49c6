// SPDX-License-Identifier: MIT
#include "force_times.hpp"

#include <algorithm>

#include "forces/pairs/centre_ranges.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

// These times were measured on one core in mixed precision with AVX-512. The choice of the mesh
// depends only on ratios of the times. The ratios are similar in double precision and with other
// instruction sets.
constexpr double per_point = 1.3e-9;    // time per grid point for the transforms in both
                                        // directions
constexpr double per_charge = 9.5e-9;   // time per charge for the grid position and the weights
constexpr double per_tile = 1.05e-9;    // time per charge for each grid tile to which it is spread
constexpr double per_pair = 2.3e-9;     // time per pair of molecules for its records and sums
constexpr double per_charges = 0.4e-9;  // time per pair of charges
constexpr double per_short_range = 0.6e-9;  // time per pair of sites with a short-range potential

}  // namespace

double expected_mesh_seconds(const Topology& topology, const MeshSettings& mesh) {
  double charges = 0, points = 1;
  for (const auto& part : topology.parts)
    charges += static_cast<double>(part.count) *
               static_cast<double>(InteractionSites(part.molecule).charged);
  for (const std::size_t n : mesh.points) points *= static_cast<double>(n);
  // Along an edge, a narrow spline overlaps with two tiles, and a wide spline with more tiles.
  const double tiles = mesh.order <= 5 ? 2 : (mesh.order + 4) / 4.0;
  return charges * (per_charge + per_tile * mesh.order * tiles * tiles) + points * per_point;
}

double expected_pair_seconds(const Topology& topology, ForceSettings settings,
                             double coulomb_cutoff, const Box& box) {
  settings.mesh.reset();
  settings.coulomb_cutoff = coulomb_cutoff;
  double seconds = 0;
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) {
      const double range =
          centre_ranges(settings, a.molecule, b.molecule).largest() + settings.skin;
      const double sphere = 4 * units::pi / 3 * range * range * range;
      const double pairs = static_cast<double>(a.count) * static_cast<double>(b.count) / 2 *
                           std::min(1.0, sphere / box.volume());
      const InteractionSites one(a.molecule), other(b.molecule);
      seconds +=
          pairs * (per_pair + per_charges * static_cast<double>(one.charged * other.charged) +
                   per_short_range * static_cast<double>(one.dispersive * other.dispersive));
    }
  return seconds;
}

}  // namespace polhode
