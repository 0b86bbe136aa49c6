// SPDX-License-Identifier: MIT
#include "run/simulation/system/relaxation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "io/settings/quantity.hpp"
#include "model/initial_state.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::size_t max_separation_steps = 2000;

/// The body-frame angular momentum L of each body.
Vec3Column angular_momenta_in_body_frame(const State& state) {
  Vec3Column L(state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    L.set(i, to_body(state.orientation[i], state.ell[i]));
  return L;
}

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

bool molecules_overlap(const System& system, const State& state) try {
  ForceField forces(system.topology, system.forces, state.box);
  Load load(state.size());
  forces(state, load);
  const auto within = [](const Vec3Column& all, double bound) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!(norm2(all[i]) <= bound * bound)) return false;
    return true;
  };
  return !within(load.f, max_initial_force) || !within(load.tau, max_initial_torque);
} catch (const RunError&) {  // a force is not finite
  return true;
}

std::string fitting_density(const Topology& topology, const Box& box, std::uint64_t seed,
                            const std::function<bool(const State&)>& overlaps) {
  constexpr double lower = 0.9, min_share = 0.05;
  const double density = topology.mass() / box.volume();
  for (double share = lower; share > min_share; share *= lower) {
    const Box larger{std::cbrt(1 / share) * box.edge};
    if (!overlaps(lattice(topology, larger, seed)))
      return fmt::format(
          ", or a density of {:.2g} g/cm3, at which molecules do not overlap on this lattice",
          share * density / unit("g/cm3", Dimension::density));
  }
  return {};
}

void check_lattice(const System& system, const Config& config) {
  if (!config.system.initial_configuration.empty() || config.run.minimise ||
      config.run.equilibrate > 0 || !molecules_overlap(system, system.state))
    return;
  const std::string contact = strongest_contact(system, system.state);
  const std::string fits =
      fitting_density(system.topology, system.state.box, config.system.seed,
                      [&](const State& state) { return molecules_overlap(system, state); });
  throw Error(fmt::format("molecules overlap on the lattice of {:.3g} g/cm3{}, so forces are too "
                          "large to begin a run; write minimise = true and equilibrate = \"20 ps\" "
                          "in [run], or use 'polhode prepare'{}",
                          system.topology.mass() / system.state.box.volume() /
                              unit("g/cm3", Dimension::density),
                          contact.empty() ? "" : ": " + contact, fits),
              config.source);
}

Minimisation minimise(System& system, const MinimisationSettings& settings,
                      const MinimisationWatch& watch, Workers& workers) try {
  ForceSettings force_settings = system.forces;
  force_settings.precision = Precision::double_precision;
  ForceField forces(system.topology, force_settings, system.state.box, workers);
  State& state = system.state;
  const Vec3Column p = state.p, L = angular_momenta_in_body_frame(state);
  const Minimisation result = minimise(
      state, system.topology, system.bodies, [&](const State& at, Load& load) { forces(at, load); },
      settings, watch, workers);
  state.p = p;
  for (std::size_t i = 0; i < state.size(); ++i)
    state.ell.set(i, to_lab(state.orientation[i], L[i]));
  return result;
} catch (const RunError& e) {
  const std::string contact = strongest_contact(system, system.state);
  throw RunError(fmt::format("{}{}; use a lower density, or another initial configuration",
                             e.what(), contact.empty() ? "" : ": " + contact));
}

MinimisationWatch watch_of(const Callbacks& callbacks) {
  return [callbacks](std::size_t, const Steepness& now) {
    callbacks.report({"minimising", {}, fmt::format("largest force {:.3g} kJ/mol/nm", now.force)});
    return callbacks.stopped();
  };
}

std::string description(const Minimisation& m) {
  const char* const end = m.end == MinimisationEnd::converged   ? "minimised in"
                          : m.end == MinimisationEnd::max_steps ? "minimisation not converged after"
                                                                : "minimisation interrupted after";
  return fmt::format("{} {} steps: largest force {:.4g} kJ/mol/nm, largest torque {:.4g} kJ/mol",
                     end, m.steps, m.after.force, m.after.torque);
}

std::size_t separate_molecules(System& system, const std::function<bool()>& stop,
                               Workers& workers) {
  const Minimisation result = minimise(
      system,
      {.force = max_initial_force, .torque = max_initial_torque, .max_steps = max_separation_steps},
      [&](std::size_t, const Steepness&) { return stop && stop(); }, workers);
  if (result.end == MinimisationEnd::max_steps) check_separated(system, result);
  return result.steps;
}

void check_separated(const System& system, const Minimisation& m) {
  if (m.after.force <= max_initial_force && m.after.torque <= max_initial_torque) return;
  throw RunError(
      fmt::format("molecules still overlap after they were moved apart in {} steps: {}; use a "
                  "lower density, or another initial configuration",
                  m.steps, strongest_contact(system, system.state)));
}

}  // namespace polhode
