// SPDX-License-Identifier: MIT
#include "polhode/run/adviser.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/run/rounding.hpp"
#include "polhode/run/step_search.hpp"
#include "polhode/run/study.hpp"
#include "polhode/run/trajectory.hpp"

namespace polhode {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Starts of the runs that choose, and of each set of runs that confirm.
constexpr std::size_t choosing = 6, confirming = 8;
/// Sets of runs that may refuse a step before the adviser gives up.
constexpr std::size_t most_refusals = 6;
constexpr double preparation = 2;  // of a start, at most [ps], in steps of 1 fs
/// Energies at least so often: rare ones would know R less well than the run could [ps].
constexpr double longest_sample = 0.004;
/// A drift of the choosing runs ends the range of steps; a smaller chance than that of a verdict,
/// for there are a dozen questions.
constexpr double least_chance = 0.001;

/// One run to be done.
struct Job {
  std::size_t candidate;
  double step;
  double length;
};

class Adviser {
 public:
  Adviser(const Config& config, const AdviserSettings& settings, const AdviserWatch& watch,
          Workers& workers)
      : config_(config),
        settings_(settings),
        watch_(watch),
        workers_(workers),
        base_(assembled(config)) {
    for (const std::string& text : settings.schemes)
      advice_.candidates.push_back({text, single_scheme_of(text), {}, {}, 0, 0, {}});
  }

  Advice advice() {
    if (!prepared_base()) return stopped();
    const Clock::time_point before = Clock::now();
    starts_ = fresh_starts(choosing);
    if (stop()) return stopped();
    const double rounds = std::ceil(static_cast<double>(choosing) / workers_.threads());
    evaluation_ = since(before) / (rounds * std::max(1.0, 1000 * preparation_length()));

    search_steps();
    if (stop()) return stopped();
    time_candidates();
    if (stop()) return stopped();
    confirm();
    if (stop()) return stopped();
    return advice_;
  }

 private:
  bool stop() const { return watch_.stop && watch_.stop(); }

  Advice stopped() {
    advice_.stopped = true;
    advice_.best.reset();
    return advice_;
  }

  void report(const std::string& what) const {
    const std::lock_guard lock(reporting_);
    if (watch_.report) watch_.report(std::min(0.99, since(begin_) / settings_.seconds), what);
  }

  /// The state that the run begins with.
  bool prepared_base() {
    report("equilibrating");
    if (config_.run.equilibrate > 0) {
      ForceField forces(base_.topology, base_.forces, base_.state.box, workers_);
      if (!equilibrate(base_, forces, config_.run.equilibrate, {nullptr, watch_.stop}, workers_))
        return false;
    }
    noise_ = force_noise(base_, workers_);
    frequency_ = einstein_frequency(base_, workers_);
    for (const Candidate& candidate : advice_.candidates)
      if (const double first = search_of(candidate).first; config_.run.length < 10 * first)
        throw Error(fmt::format(
            "runs of {:g} fs are too short for advice: it begins with steps of {:.3g} fs of {}, of "
            "which a run must hold ten; ask for longer runs",
            1000 * config_.run.length, 1000 * first, candidate.name));
    begin_ = Clock::now();
    return !stop();
  }

  double preparation_length() const { return std::min(preparation, config_.study.decorrelate); }

  /// Starts with momenta that none before had.
  std::vector<System> fresh_starts(std::size_t count) {
    report("preparing starts");
    std::vector<System> starts(count, base_);
    workers_.each(count, [&](std::size_t k) {
      if (!stop())
        starts[k] =
            decorrelated_start(base_, config_, drawn_ + k, preparation_length(), watch_.stop);
    });
    drawn_ += count;
    return starts;
  }

  TrajectorySettings settings_of(const Job& job) const {
    return {advice_.candidates[job.candidate].scheme, job.step, job.length,
            std::min(config_.run.sample, longest_sample), config_.integrator.lambda};
  }

  Outcome one_run(const System& start, const Job& job) const {
    System system = start;
    ForceField forces(system.topology, system.forces, system.state.box);
    const TrajectorySettings s = settings_of(job);
    const Trajectory t = trajectory(system, forces, s, {nullptr, watch_.stop});
    Outcome run = outcome(system, t);
    if (run.failure.empty()) {
      std::vector<double> potential;
      for (const Energies& e : t.samples) potential.push_back(e.potential());
      run.rounding = rounding_fluctuation(noise_, s.scheme, s.lambda, s.step, s.length) /
                     fluctuation(potential);
    }
    return run;
  }

  /// Runs of every job from every start, as many at once as there are workers.
  std::vector<AdviserPoint> measured(const std::vector<Job>& jobs,
                                     const std::vector<System>& starts) const {
    std::vector<AdviserPoint> points;
    for (const Job& job : jobs)
      points.push_back({job.step, job.length, std::vector<Outcome>(starts.size()), 0, false});
    workers_.each(jobs.size() * starts.size(), [&](std::size_t k) {
      if (stop()) return;
      const std::size_t j = k / starts.size(), r = k % starts.size();
      points[j].runs[r] = one_run(starts[r], jobs[j]);
      report(advice_.candidates[jobs[j].candidate].name);
    });
    for (AdviserPoint& point : points) {
      point.bound = upper_bound(settings_.criterion.quality, point.runs);
      point.usable = !blew_up(point.runs) && !drifts(point.runs, least_chance);
    }
    return points;
  }

  /// Seconds that all runs together may take, in those of one thread.
  double budget(double share) const { return share * settings_.seconds * workers_.threads(); }

  /// The length of `runs` runs that fit into a time with so many force evaluations per ps.
  double affordable(double seconds, double runs, double cost) const {
    return seconds / (runs * cost * evaluation_);
  }

  StepSearch search_of(const Candidate& candidate) const {
    // A harmonic freedom of frequency ω is stable up to ω h = 2 for each force evaluation of a good
    // scheme, and the fastest bodies of a liquid move twice as fast as their mean.
    const double first = 0.12 * std::min(3.0, candidate.scheme.cost()) / frequency_;
    return {settings_.criterion, candidate.scheme.order(), three_digits(first)};
  }

  void search_steps() {
    // About six steps of each scheme, with 3.3 ω force evaluations per ps where R is half a
    // percent.
    const double runs = 6.0 * choosing * static_cast<double>(advice_.candidates.size());
    const double least = std::min(config_.run.length, 60 / frequency_);
    const double most = std::min(config_.run.length, 600 / frequency_);
    const double length = std::clamp(affordable(budget(0.4), runs, 3.3 * frequency_), least, most);
    while (!stop()) {
      std::vector<Job> jobs;
      for (std::size_t c = 0; c < advice_.candidates.size(); ++c) {
        const Candidate& candidate = advice_.candidates[c];
        const auto step = next_step(search_of(candidate), candidate.points);
        // Ten steps at least, or there is nothing to see.
        if (step && length >= 10 * *step) jobs.push_back({c, *step, length});
      }
      if (jobs.empty()) break;
      const std::vector<AdviserPoint> found = measured(jobs, starts_);
      for (std::size_t j = 0; j < jobs.size(); ++j) {
        auto& points = advice_.candidates[jobs[j].candidate].points;
        const auto place = std::find_if(points.begin(), points.end(), [&](const AdviserPoint& p) {
          return p.step > found[j].step;
        });
        points.insert(place, found[j]);
      }
    }
    for (Candidate& candidate : advice_.candidates) {
      const FoundStep found = found_step(search_of(candidate), candidate.points);
      candidate.model = found.model;
      if (found.step > 0)
        candidate.step = three_digits(found.step);
      else
        candidate.obstacle = "no step that was tried keeps the bound";
    }
  }

  /// The wall-clock time of a simulated ps, as the run will have it: all threads on one system, in
  /// turns, so that a change of the clock rate or of other work meets all schemes alike.
  void time_candidates() {
    constexpr int turns = 3;
    const double seconds =
        0.1 * settings_.seconds / (turns * static_cast<double>(advice_.candidates.size()));
    std::vector<std::vector<double>> times(advice_.candidates.size());
    for (int turn = 0; turn < turns; ++turn)
      for (std::size_t c = 0; c < advice_.candidates.size() && !stop(); ++c) {
        const Candidate& candidate = advice_.candidates[c];
        if (candidate.step == 0) continue;
        report("clocking " + candidate.name);
        times[c].push_back(time_of(candidate, std::clamp(seconds, 0.02, 0.3)));
      }
    for (std::size_t c = 0; c < times.size(); ++c)
      if (!times[c].empty()) {
        std::sort(times[c].begin(), times[c].end());
        advice_.candidates[c].seconds = times[c][times[c].size() / 2];
      }
  }

  double time_of(const Candidate& candidate, double seconds) const {
    System system = starts_.front();
    ForceField forces(system.topology, system.forces, system.state.box, workers_);
    const Clock::time_point start = Clock::now();
    const auto over = [&] { return stop() || since(start) > seconds; };
    // From twenty to a thousand steps at a time, a few rebuilds of the list among them.
    const double least = 20 * candidate.step;
    const TrajectorySettings s{candidate.scheme, candidate.step, 1000 * candidate.step,
                               config_.run.sample, config_.integrator.lambda};
    double length = 0, spent = 0;
    do {
      const Trajectory t = trajectory(system, forces, s, {nullptr, over}, workers_);
      length += static_cast<double>(t.steps) * s.step;
      spent += t.timings.all();
    } while (length < least && !stop());
    return spent / length;
  }

  /// The cheapest of those that may be, by the time of a simulated ps.
  std::optional<std::size_t> cheapest(std::optional<std::size_t> besides = {}) const {
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < advice_.candidates.size(); ++c) {
      const Candidate& candidate = advice_.candidates[c];
      if (candidate.step == 0 || besides == c) continue;
      if (!best || candidate.seconds < advice_.candidates[*best].seconds) best = c;
    }
    return best;
  }

  void confirm() {
    while (advice_.refused.size() < most_refusals) {
      const auto c = cheapest();
      if (!c) return;
      Candidate& candidate = advice_.candidates[*c];
      const double cost = candidate.scheme.cost() / candidate.step;
      const double length =
          std::clamp(affordable(budget(0.4), confirming, cost),
                     std::min(config_.run.length, 60 / frequency_), config_.run.length);
      const std::vector<System> starts = fresh_starts(confirming);
      if (stop()) return;
      const AdviserPoint point = measured({{*c, candidate.step, length}}, starts).front();
      if (stop()) return;
      const bool calm = !blew_up(point.runs) &&
                        (settings_.criterion.quality == Quality::drift || !drifts(point.runs));
      if (calm && point.bound <= settings_.criterion.bound) {
        advice_.best = c;
        advice_.runner_up = cheapest(c);
        advice_.confirmation = point;
        return;
      }
      advice_.refused.emplace_back(*c, point);
      shorten(candidate, point, calm);
    }
  }

  /// After runs that did not confirm a step: as much shorter as they say.
  void shorten(Candidate& candidate, const AdviserPoint& point, bool calm) const {
    double factor = 0.85;
    if (calm && candidate.model)
      factor = std::clamp(std::pow(settings_.criterion.bound / point.bound,
                                   1 / candidate.model->exponent(candidate.step)),
                          0.6, 0.97);
    const double shorter = three_digits(factor * candidate.step);
    candidate.seconds *= candidate.step / shorter;
    candidate.step = shorter;
  }

  const Config& config_;
  const AdviserSettings& settings_;
  const AdviserWatch& watch_;
  Workers& workers_;
  System base_;
  ForceNoise noise_;
  double frequency_ = 0;   // [1/ps]
  double evaluation_ = 0;  // seconds of one thread
  std::vector<System> starts_;
  std::size_t drawn_ = 0;  // starts so far
  Clock::time_point begin_ = Clock::now();
  mutable std::mutex reporting_;
  Advice advice_;
};

}  // namespace

double einstein_frequency(const System& system, Workers& workers) {
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  Load load(system.bodies.size());
  forces(system.state, load);
  double highest = 0;
  std::size_t body = 0;
  for (const auto& part : system.topology.parts) {
    std::array<double, 4> squares{};  // of p/√m and L_k/√J_k, their changes per time
    for (std::size_t end = body + part.count; body < end; ++body) {
      const Bodies& b = system.bodies;
      squares[0] += dot(load.f[body], load.f[body]) * b.inverse_m[body] / 3;
      const Vec3<double> tau = to_body(system.state.attitude[body], load.tau[body]);
      for (std::size_t k = 0; k < 3; ++k) squares[k + 1] += tau[k] * tau[k] * b.inverse_J[body][k];
    }
    for (const double sum : squares)
      highest = std::max(highest, sum / static_cast<double>(part.count));
  }
  return std::sqrt(highest / (units::boltzmann * system.temperature));
}

Advice advised(const Config& config, const AdviserSettings& settings, const AdviserWatch& watch,
               Workers& workers) {
  return Adviser(config, settings, watch, workers).advice();
}

Estimate ratio_over(double length, std::span<const Energies> samples) {
  const double whole = samples.back().time - samples.front().time;
  const auto stretches = static_cast<std::size_t>(whole / length * (1 + 1e-9));
  if (stretches < 2) return fluctuation_ratio_with_error(samples);
  std::vector<double> ratios;
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t first = samples.size() * k / stretches,
                      end = samples.size() * (k + 1) / stretches;
    ratios.push_back(fluctuation_ratio(samples.subspan(first, end - first)));
  }
  return mean(ratios);
}

}  // namespace polhode
