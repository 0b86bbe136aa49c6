// SPDX-License-Identifier: MIT
#include "polhode/run/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>

#include "io/settings/output_units.hpp"
#include "math/prediction.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/simulation/system/near_forces.hpp"

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
                      .seed = start_seed(config, index)},
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

// Records identify runs by scheme and step, so each must be unique.
void add_point(std::vector<StudyPoint>& points, const StudyPoint& point) {
  for (const StudyPoint& other : points)
    if (other.name == point.name && other.record_name() != point.record_name())
      throw Error(
          fmt::format("the study has two schemes with the name '{}'; tables distinguish schemes by "
                      "their names, so give one of them another name",
                      point.name));
    else if (other.name == point.name && same(other.step, point.step))
      throw Error(fmt::format(
          "the study has {} with a step of {:g} fs twice; give each scheme and each step once",
          point.name, units::fs_per_ps * point.step));
  points.push_back(point);
}

/// The runs of a study that are still to be done.
class StudyJobs {
 public:
  StudyJobs(const Config& config, const std::vector<StudyRun>& known,
            const std::function<void(const StudyRun&)>& finished, const Callbacks& callbacks,
            Workers& workers)
      : config_(config),
        finished_(finished),
        callbacks_(callbacks),
        workers_(workers),
        needed_(static_cast<std::size_t>(config.study.runs), false) {
    std::map<std::pair<std::string, int>, std::vector<double>> steps_done;  // by scheme and run
    for (const StudyRun& run : known) steps_done[{run.scheme, run.start}].push_back(run.step);
    for (const StudyPoint& point : study_points(config.study))
      for (int r = 0; r < config.study.runs; ++r)
        if (!contains(steps_done[{point.record_name(), r}], point.step)) add({point, r});
    // The most expensive first, so that the last ones are short.
    std::stable_sort(jobs_.begin(), jobs_.end(),
                     [](const Job& a, const Job& b) { return a.work() > b.work(); });
  }

  void perform() {
    if (jobs_.empty()) return;
    work_ += preparation() * static_cast<double>(std::count(needed_.begin(), needed_.end(), true));
    const System base = build_system(config_);
    prepare_starts(base);
    if (callbacks_.stopped()) return;
    for (const Job& job : jobs_)  // measured while nothing else runs
      if (!near_weights_.contains(job.point.name))
        near_weights_[job.point.name] = near_weight(base, job.point.scheme.inner);
    workers_.each(jobs_.size(), [&](std::size_t k) { perform(jobs_[k]); });
  }

 private:
  struct Job {
    StudyPoint point;
    int start;
    double work() const { return point.cost(typical_near_weight); }  // per ps
  };

  static bool contains(const std::vector<double>& steps, double step) {
    return std::any_of(steps.begin(), steps.end(), [&](double one) { return same(one, step); });
  }

  void add(const Job& job) {
    jobs_.push_back(job);
    needed_[static_cast<std::size_t>(job.start)] = true;
    work_ += job.work() * config_.study.length;
  }

  /// Force evaluations for an initial configuration, in steps of 1 fs.
  double preparation() const { return 1000 * config_.study.decorrelate; }

  void prepare_starts(const System& base) {
    starts_.assign(needed_.size(), base);
    workers_.each(starts_.size(), [&](std::size_t r) {
      if (!needed_[r] || callbacks_.stopped()) return;
      starts_[r] = prepare_start(base, config_, r, config_.study.decorrelate, callbacks_.stop);
      advance(preparation(), "preparing initial configurations");
    });
  }

  void perform(const Job& job) {
    if (callbacks_.stopped()) return;
    const auto start = static_cast<std::size_t>(job.start);
    const StudyRun run = one_run(starts_[start], start, job.point, config_,
                                 near_weights_.at(job.point.name), callbacks_);
    if (callbacks_.stopped()) return;  // the run may be incomplete
    {
      const std::lock_guard lock(guard_);
      finished_(run);
    }
    advance(job.work() * config_.study.length, job.point.name);
  }

  void advance(double by, const std::string& what) {
    const std::lock_guard lock(guard_);
    done_ += by;
    callbacks_.report({"study", done_ / work_, what});
  }

  const Config& config_;
  const std::function<void(const StudyRun&)>& finished_;
  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<bool> needed_;  // initial configurations
  std::vector<Job> jobs_;
  std::vector<System> starts_;
  std::map<std::string, double> near_weights_;  // of schemes
  std::mutex guard_;
  double work_ = 0, done_ = 0;  // in force evaluations
};

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
  StudyJobs(config, known, finished, callbacks, workers).perform();
}

namespace {

/// A difference of temperatures over the runs that have it; nothing if fewer than two do.
template <class Difference>
std::optional<Estimate> mean_difference(const std::vector<StudyRun>& runs,
                                        const Difference& difference) {
  std::vector<double> values;
  for (const StudyRun& run : runs)
    if (const std::optional<double> value = run.stable ? difference(run) : std::nullopt)
      values.push_back(*value);
  if (values.size() < 2) return std::nullopt;
  return mean(values);
}

void add_excesses(EfficiencyPoint& point, const std::vector<StudyRun>& runs) {
  for (std::size_t k = 0; k < point.excess.size(); ++k)
    point.excess[k] = mean_difference(runs, [k](const StudyRun& run) -> std::optional<double> {
      if (!run.parts || !(run.parts->rotation[k] > 0 && run.parts->translation > 0)) return {};
      return run.parts->rotation[k] - run.parts->translation;
    });
  for (std::size_t k = 0; k < point.configurational_excess.size(); ++k)
    point.configurational_excess[k] =
        mean_difference(runs, [k](const StudyRun& run) -> std::optional<double> {
          if (!run.configurational || !run.parts || (*run.configurational)[k] == 0) return {};
          const Temperatures& T = *run.parts;
          return (*run.configurational)[k] - (k == 0 ? T.translation : T.rotation[k - 1]);
        });
}

/// Means over the runs that did not blow up.
void add_means(EfficiencyPoint& point, const std::vector<StudyRun>& runs) {
  std::vector<double> ratios, totals, drifts, temperatures, roundings;
  for (const StudyRun& run : runs) {
    if (!run.stable) continue;
    ratios.push_back(run.ratio);
    totals.push_back(run.total);
    drifts.push_back(run.drift);
    temperatures.push_back(run.temperature);
    roundings.push_back(run.rounding);
  }
  point.stable = ratios.size() == runs.size();
  if (ratios.empty()) return;
  point.ratio = mean(ratios);
  point.total = mean(totals).value;
  point.drift = drift_of_series(drifts);
  point.temperature = mean(temperatures).value;
  point.rounding = mean(roundings).value;
}

/// The runs of a point, sorted by initial configuration: sums do not depend on which run ended
/// first.
std::vector<StudyRun> runs_of(const StudyPoint& point, const std::vector<StudyRun>& runs) {
  const std::string name = point.record_name();
  std::vector<StudyRun> own;
  for (const StudyRun& run : runs)
    if (run.scheme == name && same(run.step, point.step)) own.push_back(run);
  std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.start < b.start; });
  return own;
}

}  // namespace

std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs, double length) {
  std::vector<EfficiencyPoint> result;
  for (const StudyPoint& point : points) {
    const std::vector<StudyRun> own = runs_of(point, runs);
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
