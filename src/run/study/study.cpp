// SPDX-License-Identifier: MIT
#include "polhode/run/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "io/settings/output_units.hpp"
#include "io/settings/scheme_labels.hpp"
#include "math/prediction.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "study_tasks.hpp"

namespace polhode {
namespace {

// The default steps [fs]. The steps are close enough for interpolation, and range from about R =
// 0.1 % (0.001 % for fourth-order schemes) to the stability limit.
std::vector<double> default_steps(const NestedScheme& nested, bool coarse) {
  std::vector<double> fs;
  const Scheme& scheme = nested.outer;
  if (nested.inner)
    fs = coarse ? std::vector<double>{4, 6, 8, 10} : std::vector<double>{3, 4, 5, 6, 7, 8, 10, 12};
  else if (scheme.force_evaluations() == 1)
    fs = coarse ? std::vector<double>{1, 2, 3, 4, 6}
                : std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8};
  else if (scheme.order() == 2)
    fs = coarse ? std::vector<double>{3, 4, 5, 6, 7, 8}
                : std::vector<double>{2, 3, 4, 5, 6, 7, 8, 9};
  else
    fs = coarse ? std::vector<double>{3, 4, 5, 6, 7, 8} : std::vector<double>{3, 4, 5, 6, 7, 8, 9};
  // Schemes with more stages than in the paper use larger steps, so that the cost is the same.
  const double stretch = std::max(1.0, scheme.force_evaluations() / 3.0);
  for (double& h : fs) h *= stretch / units::fs_per_ps;
  return fs;
}

/// Assumed cost of near forces relative to all forces, used to distribute the work before this cost
/// is measured.
constexpr double typical_near_weight = 0.3;

StudyRun one_run(const System& start, std::size_t index, const StudyPoint& point,
                 const Config& config, double near_weight, const Callbacks& callbacks) {
  StudyRun run{.scheme = point.record_name(),
               .step = point.step,
               .start = static_cast<int>(index),
               .near_weight = near_weight};
  System system = start;
  ForceField forces(system.topology, system.forces, system.state.box);
  const Trajectory t =
      run_trajectory(system, forces,
                     {.scheme = point.scheme.outer,
                      .step = point.step,
                      .length = config.study.length,
                      .sample = max_sample_interval,
                      .lambda = config.integrator.lambda,
                      .inner = point.scheme.inner,
                      .configurational_sample = config.study.configurational_sample,
                      .seed = start_seed(config, index),
                      .processed = config.output.processed},
                     {nullptr, callbacks.stop});
  run.stable = t.failure.empty();
  if (!run.stable) return run;
  const EnergyStatistics& energies = t.statistics.energies;
  run.ratio = energies.ratio();
  run.drift = drift_rate(energies, point.step);
  run.total = energies.total_fluctuation();
  run.potential = energies.potential_fluctuation();
  run.parts = energies.temperatures(degrees_of_freedom(system.topology));
  run.temperature = run.parts->all;
  run.configurational = t.statistics.configurational.values();
  if (run.potential > 0)
    run.rounding = rounding_fluctuation(force_noise(start), point.scheme, config.integrator.lambda,
                                        point.step, config.study.length) /
                   run.potential;
  return run;
}

// Records identify runs by scheme and step, so each pair of scheme and step must be unique.
void add_point(std::vector<StudyPoint>& points, const StudyPoint& point) {
  for (const StudyPoint& other : points)
    if (other.name == point.name && other.record_name() != point.record_name())
      throw Error(
          fmt::format("the study has two schemes with the name '{}'; tables distinguish schemes by "
                      "name, so rename one of the two",
                      point.name));
    else if (other.name == point.name && same_step(other.step, point.step))
      throw Error(fmt::format(
          "the study contains {} with a step of {:g} fs twice; give each scheme and each step once",
          point.name, units::fs_per_ps * point.step));
  points.push_back(point);
}

/// Adds mean differences of temperatures over the runs in which both are known.
void add_excesses(EfficiencyPoint& point, const std::vector<StudyRun>& runs) {
  for (std::size_t k = 0; k < point.excess.size(); ++k)
    point.excess[k] = mean_of_runs(runs, [k](const StudyRun& run) -> std::optional<double> {
      if (!run.parts || !(run.parts->rotation[k] > 0 && run.parts->translation > 0)) return {};
      return run.parts->rotation[k] - run.parts->translation;
    });
  for (std::size_t k = 0; k < point.configurational_excess.size(); ++k)
    point.configurational_excess[k] =
        mean_of_runs(runs, [k](const StudyRun& run) -> std::optional<double> {
          if (!run.configurational || !run.parts || (*run.configurational)[k] == 0) return {};
          const Temperatures& T = *run.parts;
          return (*run.configurational)[k] - (k == 0 ? T.translation : T.rotation[k - 1]);
        });
}

/// Adds means over the runs that did not blow up.
void add_means(EfficiencyPoint& point, const std::vector<StudyRun>& runs) {
  const auto stable = [&](double StudyRun::*member) {
    std::vector<double> values;
    for (const StudyRun& run : runs)
      if (run.stable) values.push_back(run.*member);
    return values;
  };
  const std::vector<double> ratios = stable(&StudyRun::ratio);
  point.stable = ratios.size() == runs.size();
  if (ratios.empty()) return;
  point.ratio = mean(ratios);
  point.total = mean(stable(&StudyRun::total)).value;
  point.drift = drift_of_series(stable(&StudyRun::drift));
  point.temperature = mean(stable(&StudyRun::temperature)).value;
  point.rounding = mean(stable(&StudyRun::rounding)).value;
}

}  // namespace

double EfficiencyPoint::relative_drift() const {
  return total > 0 ? std::abs(drift.rate.value) * length / total : 0;
}

double EfficiencyPoint::relative_drift_bound() const {
  if (runs < 2) return std::numeric_limits<double>::infinity();
  const double error = total > 0 ? drift.rate.error * length / total : 0;
  return relative_drift() + t_quantile(0.975, runs - 1) * error;
}

bool EfficiencyPoint::drifts() const {
  return drift.p_value < significance && relative_drift() >= drift_bound;
}

std::vector<StudyPoint> study_points(const StudySettings& settings) {
  std::vector<StudyPoint> points;
  for (const NamedScheme& scheme : settings.schemes) {
    for (const double h :
         settings.steps.empty() ? default_steps(scheme, settings.coarse) : settings.steps)
      add_point(points, {label_of(scheme), scheme, h});
  }
  return points;
}

std::string StudyPoint::record_name() const {
  const bool own_name =
      scheme.outer.has_own_name() || (scheme.inner && scheme.inner->scheme.has_own_name());
  return own_name ? named_text_of(scheme) : name;
}

double StudyPoint::cost(double near_weight) const {
  return (scheme.outer.cost() + near_weight * scheme.near_cost()) / step;
}

std::uint64_t start_seed(const Config& config, std::size_t index) {
  return derived_seed(config.system.seed, index);
}

System prepare_start(const System& base, const Config& config, std::size_t index, double length,
                     const std::function<bool()>& stop) {
  System start = base;
  draw_momenta(start, start_seed(config, index));
  ForceField forces(start.topology, start.forces, start.state.box);
  equilibrate(start, forces, length, {nullptr, stop});
  return start;
}

void perform_study_runs(const Config& config, const std::vector<StudyRun>& known,
                        const std::function<void(const StudyRun&)>& finished,
                        const Callbacks& callbacks, Workers& workers) {
  const StudySettings& study = config.study;
  StudyTasks<StudyPoint> tasks(callbacks, workers);
  for (const StudyPoint& point : study_points(study))
    for (int start = 0; start < study.runs; ++start)
      tasks.add(point, point.record_name(), start, point.cost(typical_near_weight) * study.length,
                known);
  if (tasks.empty()) return;
  tasks.sort_by_work();
  const System base = build_system(config);
  constexpr double steps_per_ps = 1000;  // steps of an equilibration per ps
  tasks.prepare(base, study.runs, steps_per_ps * study.decorrelate, [&](std::size_t start) {
    return prepare_start(base, config, start, study.decorrelate, callbacks.stop);
  });
  if (callbacks.stopped()) return;
  std::map<std::string, double> near_weights;  // weights of near forces, measured while nothing
                                               // else runs
  for (const auto& task : tasks.all())
    if (!near_weights.contains(task.point.name))
      near_weights[task.point.name] = near_weight(base, task.point.scheme.inner);
  tasks.perform(finished, [&](const StudyPoint& point, const System& start, std::size_t index) {
    return one_run(start, index, point, config, near_weights.at(point.name), callbacks);
  });
}

std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs, double length) {
  std::vector<EfficiencyPoint> result;
  for (const StudyPoint& point : points) {
    const std::vector<StudyRun> own = runs_of(point.record_name(), point.step, runs);
    if (own.empty()) continue;
    EfficiencyPoint e;
    e.scheme = point.name;
    e.order = point.scheme.order();
    e.step = point.step;
    e.length = length;
    e.runs = static_cast<int>(own.size());
    std::vector<double> weights;
    for (const StudyRun& run : own) weights.push_back(run.near_weight);
    e.near_weight = mean(weights).value;
    e.cost = point.cost(e.near_weight);
    add_means(e, own);
    add_excesses(e, own);
    result.push_back(e);
  }
  return result;
}

}  // namespace polhode
