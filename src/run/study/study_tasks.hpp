// SPDX-License-Identifier: MIT
// Functions that all kinds of studies use to make runs from points, and points from runs.
#pragma once

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Whether two time steps [ps] are equal up to round-off.
inline bool same_step(double a, double b) { return std::abs(a - b) < 1e-12; }

/// The runs of a scheme at a step, sorted by initial configuration. Sums over runs in this order do
/// not depend on which run ended first. The scheme is given by its name in the records.
template <class Run>
std::vector<Run> runs_of(const std::string& scheme, double step, const std::vector<Run>& runs) {
  std::vector<Run> own;
  for (const Run& run : runs)
    if (run.scheme == scheme && same_step(run.step, step)) own.push_back(run);
  std::sort(own.begin(), own.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
  return own;
}

/// The mean of a number over the runs that did not blow up; empty if fewer than two runs have the
/// number.
/// @param number  function that returns the number of a run; empty or NaN if it is not known
template <class Run, class Number>
std::optional<Estimate> mean_of_runs(const std::vector<Run>& runs, const Number& number) {
  std::vector<double> values;
  for (const Run& run : runs) {
    if (!run.stable) continue;
    const std::optional<double> value = number(run);
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  return values.size() < 2 ? std::nullopt : std::optional(mean(values));
}

/// Performs the remaining runs of a study, as many at a time as there are workers.
/// @tparam Point  type with a scheme, a step, and its `name`
template <class Point>
class StudyTasks {
 public:
  struct Task {
    Point point;
    std::size_t start;  // index of the initial configuration
    double work;        // number of force evaluations
  };

  StudyTasks(const Callbacks& callbacks, Workers& workers)
      : callbacks_(callbacks), workers_(workers) {}

  /// Adds a run unless it is already known.
  template <class Run>
  void add(const Point& point, const std::string& scheme, int start, double work,
           const std::vector<Run>& known) {
    if (std::any_of(known.begin(), known.end(), [&](const Run& run) {
          return run.scheme == scheme && run.start == start && same_step(run.step, point.step);
        }))
      return;
    tasks_.push_back({point, static_cast<std::size_t>(start), work});
    work_ += work;
  }

  bool empty() const { return tasks_.empty(); }
  const std::vector<Task>& all() const { return tasks_; }

  /// Sorts runs by decreasing cost, so that the runs that start last are short.
  void sort_by_work() {
    std::stable_sort(tasks_.begin(), tasks_.end(),
                     [](const Task& a, const Task& b) { return a.work > b.work; });
  }

  /// Makes the needed configurations among the first `count` initial configurations.
  /// @param work  work for each configuration, in force evaluations
  /// @param make  function that makes the configuration with a given index
  template <class Make>
  void prepare(const System& base, int count, double work, const Make& make) {
    starts_.assign(static_cast<std::size_t>(count), base);
    std::vector<bool> needed(starts_.size(), false);
    for (const Task& task : tasks_) needed[task.start] = true;
    work_ += work * static_cast<double>(std::count(needed.begin(), needed.end(), true));
    workers_.each(starts_.size(), [&](std::size_t k) {
      if (!needed[k] || callbacks_.stopped()) return;
      starts_[k] = make(k);
      advance(work, "preparing initial configurations");
    });
  }

  /// Performs all runs.
  /// @param finished  function that receives each run(point, initial configuration, its index) when
  ///   it ends
  template <class Finished, class MakeRun>
  void perform(const Finished& finished, const MakeRun& run) {
    workers_.each(tasks_.size(), [&](std::size_t k) {
      const auto& [point, start, work] = tasks_[k];
      if (callbacks_.stopped()) return;
      const auto done = run(point, starts_[start], start);
      if (callbacks_.stopped()) return;  // the run may be incomplete at this point
      {
        const std::lock_guard lock(guard_);
        finished(done);
      }
      advance(work, point.name);
    });
  }

 private:
  void advance(double by, const std::string& what) {
    const std::lock_guard lock(guard_);
    done_ += by;
    callbacks_.report({"study", done_ / work_, what});
  }

  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<Task> tasks_;
  std::vector<System> starts_;
  std::mutex guard_;
  double work_ = 0, done_ = 0;  // work planned and done, in force evaluations
};

}  // namespace polhode
