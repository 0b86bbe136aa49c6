// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "forces/laws/short_range.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/prepare/preparation.hpp"

namespace polhode {
namespace {

constexpr double packing = 0.45;
constexpr double spacing = 0.01;  // spacing of the grid points that are counted [nm]

/// The diameter of a site: σ, or for a potential without it the distance below which two such sites
/// repel each other [nm]; 0 for a site without short-range potential.
double diameter_of(const Site& site) {
  constexpr double longest = 1.5, step = 0.001;  // [nm]
  if (!site.has_short_range()) return 0;
  if (site.sigma > 0) return site.sigma;
  const ShortRange<double> potential = short_range(site.sigma, site.epsilon, site.law);
  double r = longest;
  // A potential that is not defined at short distances is NaN there.
  while (r > step && potential(InversePowers<double>(r * r), r * r).u <= 0) r -= step;
  return r;
}

/// A site as a sphere.
struct Sphere {
  Vec3<double> r;
  double radius = 0;
};

std::vector<Sphere> spheres_of(const Molecule& molecule) {
  std::vector<Sphere> spheres;
  for (const Site& site : molecule.sites)
    if (const double diameter = diameter_of(site); diameter > 0)
      spheres.push_back({site.r, diameter / 2});
  return spheres;
}

/// The volume of the spheres of a molecule, without their overlap [nm³].
double volume_of(const Molecule& molecule) {
  const std::vector<Sphere> spheres = spheres_of(molecule);
  double reach = 0;
  for (const Sphere& sphere : spheres) reach = std::max(reach, norm(sphere.r) + sphere.radius);
  const auto n = static_cast<int>(std::ceil(reach / spacing));
  std::size_t covered = 0;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z) {
        const Vec3<double> r = spacing * Vec3<double>{double(x), double(y), double(z)};
        covered += std::ranges::any_of(spheres, [&](const Sphere& sphere) {
          return norm2(r - sphere.r) <= sphere.radius * sphere.radius;
        });
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
