// SPDX-License-Identifier: MIT
#include "run/simulation/system/system_notes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/printable.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/simulation/report/warning_rules.hpp"

namespace polhode {

void note_molecules(const System& system, const Callbacks& callbacks) {
  for (std::size_t k = 0; k < system.origins.size(); ++k) {
    const auto& [molecule, count] = system.topology.parts[k];
    callbacks.note(fmt::format("{}: {} of {} sites, {}", molecule.name, count,
                               molecule.sites.size(), printable(system.origins[k])));
  }
  if (const auto warning = distant_sites(system)) callbacks.note(line_of(*warning));
  if (system.fit_deviation > 1e-4)
    callbacks.note(fmt::format(
        "note: atoms of the initial configuration deviate by up to {:.4f} nm from the rigid models",
        system.fit_deviation));
  if (system.massless_deviation > std::max(1e-3, 2 * system.fit_deviation))
    callbacks.note(
        fmt::format("note: massless sites of the initial configuration deviate by up to {:.4f} nm "
                    "from the models; the models determine the positions of these sites",
                    system.massless_deviation));
  if (system.removed_temperature > 1e-4)
    callbacks.note(
        fmt::format("note: the centre of mass of the initial configuration moves at {:.4g} nm/ps, "
                    "equivalent to {:.4g} K; the total momentum is removed",
                    system.removed_velocity, system.removed_temperature));
  if (degrees_of_freedom(system.topology).all() == 0)
    callbacks.note(
        "note: a single atom without total momentum has no degrees of freedom, so it has no "
        "temperature");
}

void note_velocities(const System& system, const Config& config, const Callbacks& callbacks) {
  const SystemSettings& s = config.system;
  const bool temperature = config.gives("system.temperature"), seed = config.gives("system.seed");
  if (system.new_velocities || !(temperature || seed)) return;
  if (!config.ensemble.constant_energy()) {
    // Hybrid Monte Carlo that refreshes all momenta begins with new momenta.
    if (const auto& hybrid = config.ensemble.hybrid_monte_carlo; hybrid && hybrid->refresh == 1)
      return;
    return callbacks.note(
        fmt::format("note: the run begins with the velocities of the initial configuration, {:.4g} "
                    "K, and relaxes to {:g} K",
                    system.file_temperature, s.temperature));
  }
  const std::string unused =
      !temperature ? "the seed is"
      : config.run.equilibrate > 0
          ? "the temperature is used only for the equilibration, and the seed is"
      : seed ? "temperature and seed are"
             : "the temperature is";
  callbacks.note(
      fmt::format("note: the velocities come from the initial configuration ({:.4g} K), so {} not "
                  "used; velocities = \"new\" in [system] draws new velocities",
                  system.file_temperature, unused));
}

namespace {

void note_edges(const TrajectorySettings& settings, const Callbacks& callbacks) {
  const auto& barostat = settings.ensemble.barostat;
  if (!barostat || barostat->edges.size() == 1) return;
  callbacks.note(
      fmt::format("note: edges of the box are scaled separately. In a fluid the shape of the box "
                  "drifts at random, because a fluid does not resist changes of shape; ratios of "
                  "edges can change by up to a factor of {:g}. For a fluid use edges = [\"xyz\"]",
                  max_shape_change));
}

/// Notes that hybrid Monte Carlo changes the requested interval between barostat moves.
void note_moves(const TrajectorySettings& settings, const Callbacks& callbacks) {
  const EnsembleSettings& e = settings.ensemble;
  if (!e.barostat || !e.hybrid_monte_carlo) return;
  const double interval = settings.move_interval(), asked = e.barostat->every;
  if (std::abs(interval - asked) < settings.step / 2) return;
  callbacks.note(
      fmt::format("note: the interval of {:g} fs between moves of the box is rounded to {:g} fs, a "
                  "multiple of the trajectory length of hybrid Monte Carlo ({} steps of {:g} fs)",
                  asked * units::fs_per_ps, interval * units::fs_per_ps,
                  e.hybrid_monte_carlo->steps, settings.step * units::fs_per_ps));
}

}  // namespace

void note_ensemble(const TrajectorySettings& settings, const Callbacks& callbacks) {
  if (settings.ensemble.constant_energy()) return;
  callbacks.note(fmt::format("ensemble: {}", description(settings.ensemble)));
  const std::size_t whole = settings.steps_per_trajectory();
  const auto asked = static_cast<std::size_t>(std::llround(settings.length / settings.step));
  if (settings.steps() != asked)
    callbacks.note(
        fmt::format("note: the length of {} steps is rounded up to {} steps, a whole number of "
                    "hybrid Monte Carlo trajectories of {} steps each",
                    asked, settings.steps(), whole));
  note_moves(settings, callbacks);
  note_edges(settings, callbacks);
}

void check_not_processed(const Config& config, std::string_view what) {
  if (config.output.processed)
    throw Error(fmt::format("output.processed is true, but {} uses the states of trajectories as "
                            "they are; leave output.processed out",
                            what),
                config.source);
}

void note_constant_energy(const Config& config, std::string_view what, const Callbacks& callbacks) {
  if (config.ensemble.constant_energy()) return;
  callbacks.note(fmt::format(
      "note: all runs of {} are at constant energy, because R is defined at constant energy; "
      "[thermostat], [barostat] and [hybrid_monte_carlo] of the run file are not used",
      what));
}

void note_forces(const System& system, const Callbacks& callbacks) {
  const ForceSettings& forces = system.forces;
  if (const std::string mixing = description(forces.mixing); !mixing.empty())
    callbacks.note(fmt::format("Lennard-Jones: {}", mixing));
  if (forces.mesh)
    callbacks.note(fmt::format(
        "PME: pairs of charges up to {:g} nm, grid {} x {} x {}, order {}, split exponent {}, for "
        "a "
        "relative force error of {:g}",
        forces.mesh->cutoff, forces.mesh->points[0], forces.mesh->points[1], forces.mesh->points[2],
        forces.mesh->order, forces.mesh->exponent, forces.pme_accuracy));
  double net = 0;
  for (const auto& part : system.topology.parts)
    net += static_cast<double>(part.count) * part.molecule.charge();
  if (std::abs(net) > 1e-6)
    callbacks.note(fmt::format("net charge {:+.6g} e{}", net,
                               forces.mesh ? ", neutralized by a uniform background" : ""));
}

}  // namespace polhode
