// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/system/system.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/memory.hpp"
#include "base/version.hpp"
#include "forces/pairs/neighbours.hpp"
#include "forces/pairs/overlap.hpp"
#include "model/initial_state.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/centre_of_mass.hpp"
#include "run/simulation/files/checkpoint.hpp"
#include "run/simulation/report/warning_rules.hpp"
#include "run/simulation/system/relaxation.hpp"

namespace polhode {
namespace {

// Reads molecules and mixing from a topology file. The pairs of the run file are appended to the
// pairs of the topology.
void take_topology_file(const Config& config, const Frame& start, System& system) {
  RigidTopology read = read_topology(config.system.topology, &start);
  system.topology = std::move(read.topology);
  system.origins = std::move(read.origins);
  system.shapes = std::move(read.shapes);
  if (read.rule_matters && !config.gives("forces.mixing"))
    throw Error(
        "the file does not give the mixing rule for unlike sites; write for example mixing = "
        "\"geometric\" in [forces], the default of LAMMPS",
        config.system.topology.file);
  if (read.rule_is_open) read.mixing.rule = config.forces.mixing.rule;
  std::vector<PairOverride>& pairs = read.mixing.pairs;
  pairs.insert(pairs.end(), config.forces.mixing.pairs.begin(), config.forces.mixing.pairs.end());
  system.forces.mixing = std::move(read.mixing);
  at_place(config.source, [&] { check(system.forces.mixing, system.topology); });
}

// The mixing rule with which the models were parametrized, or else the default.
MixingRule rule_of_models(const Config& config, const Topology& topology) {
  std::optional<MixingRule> rule;
  for (const auto& [molecule, count] : topology.parts) {
    if (!molecule.mixing) continue;
    rule = *molecule.mixing;
    for (const auto& [other, number] : topology.parts)
      if (other.mixing != rule)
        throw Error(
            fmt::format("the files of the models '{}' and '{}' do not state the same mixing "
                        "rule; write mixing = \"geometric\" or \"lorentz-berthelot\" in "
                        "[forces] of a run file, or give 'measure' the option --mixing",
                        molecule.name, other.name),
            config.source + ", forces.mixing");
  }
  return rule.value_or(config.forces.mixing.rule);
}

// Checks the required memory; call it before anything is allocated per molecule.
void check_size(const Topology& topology) {
  check_count(topology);
  // Memory per body and per site for state, bodies, forces and the neighbour list (without its
  // partners).
  constexpr double each_body = 500, each_site = 24;  // memory [bytes]
  double bytes = 0, molecules = 0;
  for (const auto& [molecule, count] : topology.parts) {
    const auto n = static_cast<double>(count);
    molecules += n;
    bytes += n * (each_body + each_site * static_cast<double>(molecule.sites.size()));
  }
  require_memory(bytes, fmt::format("{:.0f} molecules", molecules), "use fewer of them");
}

State lattice_start(const Config& config, const Topology& topology) {
  const SystemSettings& s = config.system;
  if (!s.density && !s.box)
    throw Error(
        "there is no density, box or initial configuration; write for example density = \"1 "
        "g/cm3\"",
        config.source + ", system");
  const Box box = at_place(config.source, [&] {
    check_size(topology);
    const Box edges = s.box ? Box{*s.box} : cubic_box(topology, s.density.value());
    check_edges(edges);
    return edges;
  });
  return lattice(topology, box, s.seed);
}

double kinetic_temperature(const System& system) {
  return temperature(energies(system.state, system.bodies, Load{}).kinetic(),
                     degrees_of_freedom(system.topology).all());
}

// Removes the velocity of the centre of mass.
void bring_to_rest(System& system) {
  const Vec3<double> velocity = remove_total_momentum(system.state, system.bodies);
  system.removed_velocity = norm(velocity);
  system.removed_temperature = temperature(total_mass(system.bodies) * norm2(velocity) / 2,
                                           degrees_of_freedom(system.topology).all());
  system.file_temperature = kinetic_temperature(system);
}

// The momenta of a checkpoint are kept bit for bit, because the centre of mass of a checkpoint is
// already at rest.
void take_velocities(System& system, const SystemSettings& settings) {
  if (system.new_velocities)
    draw_momenta(system, settings.seed);
  else if (settings.checkpoint.empty())
    bring_to_rest(system);
  else
    system.file_temperature = kinetic_temperature(system);
}

constexpr double max_deviation = 0.002;  // maximum deviation [nm], which is twice the last digit of
                                         // most GRO files
constexpr auto remedy =
    "give the coordinate file that was written with the checkpoint, or leave the checkpoint out to "
    "start from the rounded coordinates of the file";

/// The largest distance between the positions of a site in two states, up to periodic images [nm].
double deviation(const Molecule& molecule, std::size_t i, const State& a, const State& b) {
  const Vec3<double> centre = a.box.minimum_image(a.q[i] - b.q[i]);
  double largest = norm(centre);
  for (const Site& site : molecule.sites)
    largest = std::max(largest, norm(centre + to_lab(a.orientation[i], site.r) -
                                     to_lab(b.orientation[i], site.r)));
  return largest;
}

void check_same(const System& system, const State& state) {
  const State& start = system.state;
  if (state.size() != start.size())
    throw Error(
        fmt::format("the checkpoint has {} molecules, but the initial configuration has {}; {}",
                    state.size(), start.size(), remedy));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(state.box.edge[k] - start.box.edge[k]) <= max_deviation))
      throw Error(
          fmt::format("the box of the checkpoint has an edge of {:.6g} nm, but the initial "
                      "configuration has {:.6g} nm; {}",
                      state.box.edge[k], start.box.edge[k], remedy));
  for (std::size_t i = 0; i < state.size(); ++i)
    if (const double d =
            deviation(system.topology.parts[system.bodies.part[i]].molecule, i, state, start);
        !(d <= max_deviation))
      throw Error(
          fmt::format("molecule {} of the checkpoint is {:.3g} nm from its position in the initial "
                      "configuration, more than {:g} nm; {}",
                      i + 1, d, max_deviation, remedy));
}

/// Replaces the state of a system by the state in a checkpoint of the same molecules. The state
/// that is replaced was read from a coordinate file, which has fewer digits. The time of the system
/// does not change.
/// @param path  path of the checkpoint of a run or preparation
/// @throws Error  if the file is damaged or of another version, or if a box edge or a site differs
///   by more than the rounding in common formats, 0.002 nm
void take_checkpoint(System& system, const std::string& path) {
  State state = state_of_checkpoint(path, version());
  check_same(system, state);
  state.time = system.state.time;
  system.state = std::move(state);
}

/// Advice on the density at which the molecules of a lattice would not overlap.
std::string density_advice(const Config& config, const System& system) {
  if (!config.system.initial_configuration.empty()) return {};
  return fitting_density(system.topology, system.state.box, config.system.seed,
                         [&](const State& state) {
                           try {
                             check_overlap(system.topology, state);
                             return false;
                           } catch (const Error&) {
                             return true;
                           }
                         });
}

// Minimisation moves overlapping molecules apart, and so does an equilibration from a lattice.
void check_apart(const Config& config, const System& system) try {
  const bool is_lattice = config.system.initial_configuration.empty();
  if (!config.run.minimise && !(is_lattice && config.run.equilibrate > 0))
    check_overlap(system.topology, system.state);
} catch (const Error& e) {
  if (const auto warning = distant_sites(system))
    throw Error(fmt::format("{}; {}; {}", e.what(), warning->text, warning->remedy), config.source);
  throw Error(e.what() + density_advice(config, system), config.source);
}

}  // namespace

Topology build_topology(const SystemSettings& settings) {
  if (!settings.topology.file.empty()) {
    const Frame start = read_start(settings.initial_configuration);
    return read_topology(settings.topology, &start).topology;
  }
  Topology topology;
  for (const auto& component : settings.molecules)
    topology.parts.push_back({molecule_of(component), component.count});
  return topology;
}

System build_system(const Config& config) {
  const bool from_file = !config.system.topology.file.empty();
  System system{from_file ? Topology{} : build_topology(config.system),
                Bodies({}),
                {},
                config.forces,
                config.system.temperature};
  if (!from_file && !config.gives("forces.mixing"))
    system.forces.mixing.rule = rule_of_models(config, system.topology);
  if (config.system.initial_configuration.empty()) {
    system.state = lattice_start(config, system.topology);
  } else {
    const Frame frame = read_start(config.system.initial_configuration);
    if (from_file)
      take_topology_file(config, frame, system);
    else
      system.topology = complete_topology(std::move(system.topology), frame);
    FittedState fitted = fit_state(frame, system.topology);
    system.state = std::move(fitted.state);
    system.fit_deviation = fitted.deviation;
    system.massless_deviation = fitted.massless_deviation;
    const bool has_velocities = fitted.has_velocities || !config.system.checkpoint.empty();
    if (!has_velocities && config.system.new_velocities == false)
      throw Error(fmt::format("'{}' has no velocities, but velocities = \"from file\"; give a file "
                              "with velocities, or write \"new\"",
                              config.system.initial_configuration),
                  config.source + ", system.velocities");
    system.new_velocities = config.system.new_velocities.value_or(!has_velocities);
  }
  system.bodies = Bodies(system.topology);
  if (!config.system.checkpoint.empty())
    at_place(config.source + ", system.checkpoint",
             [&] { take_checkpoint(system, config.system.checkpoint); });
  at_place(config.source, [&] { check_edges(system.state.box); });
  check_apart(config, system);
  system.forces = at_place(config.place("forces.cutoff"), [&] {
    return ForceField(system.topology, system.forces, system.state.box).settings();
  });
  take_velocities(system, config.system);
  return system;
}

Energies energies_of(const System& system, const State& state, const Load& load, Workers& workers) {
  Energies e = energies(state, system.bodies, load, workers);
  if (system.forces.external)
    e.translation += energy_of_centre(state, system.bodies, TotalMomentum::free);
  return e;
}

void draw_momenta(System& system, std::uint64_t seed) {
  draw_momenta(system.state, system.topology, system.temperature, seed);
}

void rescale(State& state, const Topology& topology, const Bodies& bodies, double target) {
  remove_total_momentum(state, bodies);
  const Energies e = energies(state, bodies, Load{});
  const DegreesOfFreedom n = degrees_of_freedom(topology);
  const double now = temperature(e.translation, n.translation);
  const double turning = temperature(e.kinetic() - e.translation, n.all() - n.translation);
  if (now > 0) scale(state.p, std::sqrt(target / now));
  if (turning > 0) scale(state.ell, std::sqrt(target / turning));
}

}  // namespace polhode
