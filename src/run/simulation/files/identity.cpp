// SPDX-License-Identifier: MIT
#include "run/simulation/files/identity.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <sstream>

#include "io/settings/settings.hpp"

namespace polhode {
namespace {

/// The contents of the table of a tabulated potential, as text; a file name would not suffice,
/// because the file may have changed. The text is empty for other potentials.
std::string table_identity(const ShortRangeLaw& law) {
  const auto* tabulated = std::get_if<TabulatedLaw>(&law);
  if (!tabulated) return {};
  const PotentialTable& table = *tabulated->table;
  const auto* coefficients = table.coefficients<double>();
  return fmt::format(" from {} nm by {} nm: {}", table.first(), table.spacing(),
                     fmt::join(std::span(coefficients, coefficients + 4 * table.intervals()), " "));
}

// The Lennard-Jones potential has no parameters besides σ and ε.
std::string law_identity(const Site& site) {
  if (std::holds_alternative<LennardJonesLaw>(site.law)) return {};
  return fmt::format("{} {}{} ", name(site.law), parameters(site.sigma, site.epsilon, site.law),
                     table_identity(site.law));
}

/// Settings that are not copied into the identity of a run, because it contains their values
/// elsewhere, or because callers add the values as numbers.
constexpr std::array<std::string_view, 28> stated = {
    "system.temperature",
    "system.seed",
    "forces.truncation",
    "forces.electrostatics",
    "forces.cutoff",
    "forces.switch",
    "forces.smoothness",
    "forces.skin",
    "forces.dielectric",
    "forces.damping",
    "forces.pme_accuracy",
    "forces.coulomb_cutoff",
    "forces.mixing",
    "forces.dispersion_correction",
    "forces.slab_dispersion",
    "forces.precision",
    "integrator.scheme",
    "integrator.step",
    "integrator.lambda",
    "run.minimise",
    "run.equilibrate",
    "run.sample",
    "run.shadow_sample",
    "output.velocities",
    "run.configurational_sample",
    "output.formats",
    "output.trajectory_every",
    "output.massless_sites",
};

/// The text of all settings that are not in `stated` and differ from their defaults.
std::string further_settings(const Config& config) {
  const auto defaults = recorded_settings(Config{});
  std::string text;
  for (const auto& one : recorded_settings(config))
    if (std::find(stated.begin(), stated.end(), one.first) == stated.end() &&
        std::find(defaults.begin(), defaults.end(), one) == defaults.end())
      text += fmt::format(" {} {}", one.first, one.second);
  return text;
}

/// The first line of an identity: a hash of everything on which a run depends.
std::string_view hash_of(std::string_view run_identity) {
  return run_identity.substr(0, run_identity.find('\n'));
}

/// The settings in the other lines of an identity, by key; checkpoints of older versions have no
/// such lines.
std::map<std::string, std::string> settings_of(const std::string& run_identity) {
  std::map<std::string, std::string> settings;
  std::istringstream lines(run_identity);
  for (std::string line; std::getline(lines, line);)
    if (const auto end = line.find(" = "); end != line.npos)
      settings[line.substr(0, end)] = line.substr(end + 3);
  return settings;
}

}  // namespace

std::string identity(const Config& config, const System& system,
                     const std::vector<double>& numbers) {
  std::ostringstream id;
  id.precision(17);
  for (const auto& [molecule, count] : system.topology.parts) {
    id << molecule.name << ' ' << count << ' ';
    for (const Site& s : molecule.sites)
      id << s.r.x << ' ' << s.r.y << ' ' << s.r.z << ' ' << s.mass << ' ' << s.charge << ' '
         << s.sigma << ' ' << s.epsilon << ' ' << law_identity(s);
  }
  for (std::size_t i = 0; i < system.state.size(); ++i) {
    const Vec3<double> q = system.state.q[i];
    id << fmt::format("{:.9f} {:.9f} {:.9f} ", q.x, q.y, q.z);
  }
  const Vec3<double> edge = system.state.box.edge;
  id << edge.x << ' ' << edge.y << ' ' << edge.z << ' ';
  id << config.system.temperature << ' ' << config.system.seed << ' ';
  const ForceSettings& f = config.forces;
  id << static_cast<int>(f.truncation) << ' ' << static_cast<int>(f.electrostatics) << ' '
     << static_cast<int>(f.precision) << ' ' << f.cutoff << ' ' << f.switch_from << ' '
     << f.smoothness << ' ' << f.dielectric << ' ' << config.integrator.lambda;
  for (const double x : numbers) id << ' ' << x;
  if (config.run.minimise) id << " minimise";
  if (f.electrostatics == Electrostatics::pme) id << " pme " << f.pme_accuracy;
  if (f.coulomb_cutoff) id << " coulomb_cutoff " << *f.coulomb_cutoff;
  if (f.electrostatics == Electrostatics::damped_shifted_force) id << " damping " << f.damping;
  if (f.dispersion_correction) id << " dispersion";
  if (f.slab_dispersion) id << " slab dispersion";
  if (f.external) id << " external " << f.external->name;
  if (const std::string mixing = description(system.forces.mixing); !mixing.empty())
    id << ' ' << mixing;
  for (const PairOverride& pair : system.forces.mixing.pairs) id << table_identity(pair.law);
  id << further_settings(config);
  return id.str();
}

std::string settings_text(const Config& config) {
  std::string text;
  for (const auto& [path, value] : recorded_settings(config))
    text += fmt::format("{} = {}\n", path, value);
  return text;
}

bool same_run(std::string_view one, std::string_view other) {
  return hash_of(one) == hash_of(other);
}

std::string differences(const std::string& then, const std::string& now) {
  const auto before = settings_of(then), after = settings_of(now);
  std::string text;
  const auto add = [&](const std::string& key, const std::string& was, const std::string& is) {
    if (was != is)
      text += fmt::format("{}{} was {} and is now {}", text.empty() ? "" : ", ", key, was, is);
  };
  const std::string none = "none";
  for (const auto& [key, value] : before)
    add(key, value, after.contains(key) ? after.at(key) : none);
  for (const auto& [key, value] : after)
    if (!before.contains(key)) add(key, none, value);
  return text;
}

}  // namespace polhode
