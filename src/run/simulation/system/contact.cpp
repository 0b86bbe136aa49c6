// SPDX-License-Identifier: MIT
#include "run/simulation/system/contact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

double size_or_infinity(const Vec3<double>& force) {
  const double size = norm(force);
  return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

std::optional<std::size_t> body_with_largest_force(const System& system, const State& state) try {
  ForceField forces(system.topology, system.forces, state.box);
  Load load(state.size());
  forces(state, load);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < state.size(); ++i) sizes.push_back(size_or_infinity(load.f[i]));
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  if (std::isinf(*std::min_element(sizes.begin(), sizes.end()))) return std::nullopt;
  return static_cast<std::size_t>(largest - sizes.begin());
} catch (const Error&) {
  return std::nullopt;
} catch (const RunError&) {  // a position is not finite
  return std::nullopt;
}

struct PlacedSite {
  std::string name;
  Vec3<double> r;
};

std::vector<PlacedSite> placed_sites(const System& system, const State& state, std::size_t body) {
  std::vector<PlacedSite> sites;
  for (const Site& site : system.topology.parts[system.bodies.part[body]].molecule.sites)
    if (site.mass != 0 || site.has_short_range())
      sites.push_back({site.name, state.q[body] + to_lab(state.orientation[body], site.r)});
  return sites;
}

struct Contact {
  std::size_t body = 0;  // index of the second molecule
  double distance = std::numeric_limits<double>::infinity();
  std::string own_site, site;
};

Contact closest(const System& system, const State& state, std::size_t body) {
  const std::vector<PlacedSite> own = placed_sites(system, state, body);
  Contact found;
  for (std::size_t other = 0; other < state.size(); ++other) {
    if (other == body) continue;
    for (const PlacedSite& b : placed_sites(system, state, other))
      for (const PlacedSite& a : own)
        if (const double d = norm(state.box.minimum_image(a.r - b.r)); d < found.distance)
          found = {other, d, a.name, b.name};
  }
  return found;
}

}  // namespace

std::string strongest_contact(const System& system, const State& state) {
  if (state.size() < 2) return {};
  const auto body = body_with_largest_force(system, state);
  if (!body) return {};
  const Contact contact = closest(system, state, *body);
  const auto name = [&](std::size_t i) {
    return fmt::format("{} ({})", i + 1,
                       system.topology.parts[system.bodies.part[i]].molecule.name);
  };
  return fmt::format("molecules {} and {} are {:.4f} nm apart, between {} and {}", name(*body),
                     name(contact.body), contact.distance, contact.own_site, contact.site);
}

}  // namespace polhode
