// SPDX-License-Identifier: MIT
#include "polhode/run/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>

#include "polhode/base/error.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/run/simulation/near_forces.hpp"
#include "polhode/run/simulation/trajectory.hpp"

namespace polhode {
namespace {

// The default ladders of steps [fs]: fine enough to interpolate, from about R = 0.1 % (0.001 % for
// fourth-order schemes) to the stability limit.
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
  // Schemes with more stages than those of the paper use larger steps, at equal cost.
  const double stretch = std::max(1.0, scheme.force_evaluations() / 3.0);
  for (double& h : fs) h *= stretch / units::fs_per_ps;
  return fs;
}

/// Assumed weight of near forces, for distributing the work before anything is measured.
constexpr double typical_near_weight = 0.3;

bool same(double a, double b) { return std::abs(a - b) < 1e-12; }

StudyRun one_run(const System& start, std::size_t index, const StudyPoint& point,
                 const Config& config, double near_weight, const StudyProgress& progress) {
  StudyRun run{.scheme = point.name,
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
                      .seed = start_seed(config, index)},
                     {nullptr, progress.stop});
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

// Records identify runs by scheme and step, so each must be unique.
void add_point(std::vector<StudyPoint>& points, const StudyPoint& point) {
  for (const StudyPoint& other : points)
    if (other.name == point.name && same(other.step, point.step))
      throw Error(fmt::format(
          "the study has {} with a step of {:g} fs twice; give each scheme and each step once",
          point.name, units::fs_per_ps * point.step));
  points.push_back(point);
}

}  // namespace

std::vector<StudyPoint> study_points(const StudySettings& settings) {
  std::vector<StudyPoint> points;
  for (const std::string& text : settings.schemes) {
    const NestedScheme scheme = nested_scheme_of(text);
    for (const double h :
         settings.steps.empty() ? default_steps(scheme, settings.coarse) : settings.steps)
      add_point(points, {one_line(text), scheme, h});
  }
  return points;
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

void run_study(const Config& config, const std::vector<StudyRun>& known,
               const std::function<void(const StudyRun&)>& finished, const StudyProgress& progress,
               Workers& workers) {
  struct Job {
    StudyPoint point;
    int start;
    double work() const { return point.cost(typical_near_weight); }  // per ps
  };
  std::vector<Job> jobs;
  std::vector<bool> needed(static_cast<std::size_t>(config.study.runs), false);
  double work = 0;
  std::map<std::pair<std::string, int>, std::vector<double>> steps_done;  // of scheme and start
  for (const StudyRun& run : known) steps_done[{run.scheme, run.start}].push_back(run.step);
  for (const StudyPoint& point : study_points(config.study))
    for (int r = 0; r < config.study.runs; ++r) {
      const auto steps = steps_done.find({point.name, r});
      if (steps != steps_done.end() &&
          std::any_of(steps->second.begin(), steps->second.end(),
                      [&](double step) { return same(step, point.step); }))
        continue;
      jobs.push_back({point, r});
      needed[static_cast<std::size_t>(r)] = true;
      work += jobs.back().work() * config.study.length;
    }
  if (jobs.empty()) return;
  // The most expensive first, so that the last ones are short.
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const Job& a, const Job& b) { return a.work() > b.work(); });

  const double preparation =
      1000 * config.study.decorrelate *
      static_cast<double>(std::count(needed.begin(), needed.end(), true));  // 1 fs steps
  work += preparation;
  std::mutex guard;
  double done = 0;
  const auto advance = [&](double by, const std::string& what) {
    const std::lock_guard lock(guard);
    done += by;
    if (progress.report) progress.report(done / work, what);
  };

  const System base = build_system(config);
  std::vector<System> starts(needed.size(), base);
  const auto stopped = [&] { return progress.stop && progress.stop(); };
  workers.each(starts.size(), [&](std::size_t r) {
    if (!needed[r] || stopped()) return;
    starts[r] = prepare_start(base, config, r, config.study.decorrelate, progress.stop);
    advance(1000 * config.study.decorrelate, "preparing initial configurations");
  });
  if (stopped()) return;

  std::map<std::string, double> near_weights;  // measured while nothing else runs
  for (const Job& job : jobs)
    if (!near_weights.contains(job.point.name))
      near_weights[job.point.name] = near_weight(base, job.point.scheme.inner);

  workers.each(jobs.size(), [&](std::size_t k) {
    if (stopped()) return;
    const Job& job = jobs[k];
    const auto start = static_cast<std::size_t>(job.start);
    const StudyRun run =
        one_run(starts[start], start, job.point, config, near_weights.at(job.point.name), progress);
    if (stopped()) return;  // the run may be incomplete
    {
      const std::lock_guard lock(guard);
      finished(run);
    }
    advance(job.work() * config.study.length, run.scheme);
  });
}

std::vector<StudyRun> runs_of_starts(const std::vector<StudyRun>& runs, int starts) {
  std::vector<StudyRun> counted;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(counted),
               [&](const StudyRun& run) { return run.start < starts; });
  return counted;
}

std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs) {
  std::vector<EfficiencyPoint> result;
  for (const StudyPoint& point : points) {
    EfficiencyPoint e;
    e.scheme = point.name;
    e.step = point.step;
    std::vector<StudyRun> own;  // sorted by initial configuration: sums do not depend on which run
                                // ended first
    for (const StudyRun& run : runs)
      if (run.scheme == e.scheme && same(run.step, e.step)) own.push_back(run);
    std::sort(own.begin(), own.end(),
              [](const auto& a, const auto& b) { return a.start < b.start; });
    std::vector<double> ratios, drifts, temperatures, roundings, weights;
    for (const StudyRun& run : own) {
      ++e.runs;
      weights.push_back(run.near_weight);
      if (!run.stable) {
        e.stable = false;
        continue;
      }
      ratios.push_back(run.ratio);
      drifts.push_back(run.drift);
      temperatures.push_back(run.temperature);
      roundings.push_back(run.rounding);
    }
    if (e.runs == 0) continue;
    e.near_weight = mean(weights).value;
    e.cost = point.cost(e.near_weight);
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> excess;
      for (const StudyRun& run : own)
        if (run.stable && run.parts && run.parts->rotation[k] > 0 && run.parts->translation > 0)
          excess.push_back(run.parts->rotation[k] - run.parts->translation);
      if (excess.size() > 1) e.excess[k] = mean(excess);
    }
    for (std::size_t k = 0; k < e.configurational_excess.size(); ++k) {
      std::vector<double> excess;
      for (const StudyRun& run : own)
        if (run.stable && run.configurational && run.parts && (*run.configurational)[k] != 0)
          excess.push_back((*run.configurational)[k] -
                           (k == 0 ? run.parts->translation : run.parts->rotation[k - 1]));
      if (excess.size() > 1) e.configurational_excess[k] = mean(excess);
    }
    if (!ratios.empty()) {
      e.ratio = mean(ratios);
      e.drift = drift_of_series(drifts);
      e.temperature = mean(temperatures).value;
      e.rounding = mean(roundings).value;
    }
    result.push_back(e);
  }
  return result;
}

}  // namespace polhode
