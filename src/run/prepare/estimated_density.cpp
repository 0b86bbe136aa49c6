// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/run/prepare/preparation.hpp"

namespace polhode {
namespace {

constexpr double packing = 0.45;
constexpr double spacing = 0.01;  // spacing of the grid points that are counted [nm]

bool covers(const Site& site, const Vec3<double>& r) {
  return site.has_short_range() && norm2(r - site.r) <= site.sigma * site.sigma / 4;
}

/// The volume of the spheres of a molecule, without their overlap [nm³].
double volume_of(const Molecule& molecule) {
  double reach = 0;
  for (const Site& site : molecule.sites)
    if (site.has_short_range()) reach = std::max(reach, norm(site.r) + site.sigma / 2);
  const auto n = static_cast<int>(std::ceil(reach / spacing));
  std::size_t covered = 0;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z) {
        const Vec3<double> r = spacing * Vec3<double>{double(x), double(y), double(z)};
        covered += std::any_of(molecule.sites.begin(), molecule.sites.end(),
                               [&](const Site& site) { return covers(site, r); });
      }
  return static_cast<double>(covered) * spacing * spacing * spacing;
}

}  // namespace

double estimated_density(const Topology& topology) {
  double volume = 0;
  for (const auto& [molecule, count] : topology.parts)
    volume += static_cast<double>(count) * volume_of(molecule);
  if (!(volume > 0))
    throw Error(
        "the density cannot be estimated, since no site has a diameter (sigma); write for example "
        "density = \"1 g/cm3\" in [system]");
  return packing * topology.mass() / volume;
}

}  // namespace polhode
