// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/adviser.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "base/stopwatch.hpp"
#include "candidate_time.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "polhode/run/study/study.hpp"
#include "run/adviser/bias_conversion.hpp"
#include "run/adviser/resumable_run.hpp"
#include "run/adviser/step_search.hpp"
#include "run/progress_pace.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/stable_step.hpp"

namespace polhode {
namespace {

/// Numbers of initial configurations for the choosing runs, and for a set of confirming runs.
constexpr std::size_t choosing = 6, confirming = 8;
/// Maximum number of rejected sets of confirming runs, after which the adviser gives up.
constexpr std::size_t max_refusals = 10;
constexpr double preparation = 2;  // longest preparation [ps], in steps of 1 fs
/// Maximum interval between energy samples [ps]; fewer samples would make R less accurate.
constexpr double max_sample_interval = 0.004;
/// Maximum number of times that a longer step is tried because R is well below the bound.
constexpr int max_lengthenings = 4;
/// Fractions of the length of confirming runs after which hopeless sets of runs are stopped.
constexpr std::array parts = {1.0 / 9, 1.0 / 3, 1.0};
/// The smallest fraction of the length of confirming runs after which a longer step may be tried.
constexpr double telling = 1.0 / 3;
/// Fractions of the computing time: for choosing runs, for timings, for the response to the
/// temperature (if needed), and the minimum for confirming runs.
constexpr double choosing_share = 0.35, clock_share = 0.1, response_share = 0.15,
                 min_confirming_share = 0.3;
/// Length of preliminary runs, relative to runs near the final step.
constexpr double way = 0.5;
/// The first step for confirming runs, relative to the step that the choosing runs propose. Short
/// runs underestimate R, especially if R grows as a high power of the step, because the energy
/// error of such schemes begins as a random walk.
double reserve(double exponent) { return 1 - 0.015 * std::clamp(exponent, 2.0, 4.0); }
/// A scheme is postponed while its expected cost exceeds this factor times the cost of the second
/// cheapest scheme. Below this factor, a scheme may still be faster in computing time.
constexpr double hopeless = 1.25;
/// Maximum relative cost of configurational temperatures, and their force evaluations per sample.
constexpr double temperature_share = 0.03, sample_cost = 2;
/// The p-value below which an energy drift of the choosing runs ends the range of steps. This
/// p-value is smaller than the usual significance level, because there are about a dozen tests.
constexpr double significance_level = 0.001;

/// A test run to be performed.
struct Job {
  std::size_t candidate;
  double step;
  double length;
};

class Adviser {
 public:
  Adviser(const Config& config, const AdviserSettings& settings, const Callbacks& callbacks,
          Workers& workers)
      : config_(config),
        settings_(settings),
        callbacks_(callbacks),
        workers_(workers),
        base_(build_system(config)) {
    for (const NamedScheme& scheme : settings.schemes)
      advice_.candidates.push_back({label_of(scheme), single_scheme_of(scheme), {}, {}, 0, 0, {}});
    settled_.resize(advice_.candidates.size());
    check_criterion(settings.criterion, base_.topology);
  }

  Advice advice() {
    if (!prepare_base()) return stopped_advice();
    const Stopwatch watch;
    effort_.expect(min_work());
    starts_ = fresh_starts(choosing);
    if (stop()) return stopped_advice();
    const double rounds = std::ceil(static_cast<double>(choosing) / workers_.threads());
    evaluation_ = watch.seconds() / (rounds * std::max(1.0, 1000 * preparation_length()));
    const double seconds = min_work() * evaluation_ / workers_.threads();
    if (seconds > settings_.seconds)
      callbacks_.note(
          fmt::format("choosing the step needs at least {:.0f} s, more than the requested {:g} s",
                      seconds, settings_.seconds));
    effort_.expect(std::max(min_work(), budget(1) / evaluation_ - effort_.done()));
    prepare_conversion();
    if (stop()) return stopped_advice();
    confirm();
    if (stop()) return stopped_advice();
    for (std::size_t c = 0; c < settled_.size(); ++c)
      if (!settled_[c]) advice_.candidates[c].obstacle = waiting(c);
    return advice_;
  }

 private:
  bool stop() const { return callbacks_.stopped(); }

  Advice stopped_advice() {
    advice_.stopped = true;
    advice_.best.reset();
    return advice_;
  }

  void report(const std::string& what) const {
    const std::lock_guard lock(reporting_);
    callbacks_.report({"advising", effort_.fraction(), what});
  }

  /// Returns a stop() that is called after each step and adds the step's evaluations to the effort.
  std::function<bool()> counting_stop(double evaluations, const std::string& what) const {
    return [this, evaluations, what] {
      effort_.add(evaluations);
      if (pace_.due(watch_.seconds())) report(what);
      return stop();
    };
  }

  /// The minimum work of a search [force evaluations]: the shortest runs at about five time steps
  /// for each scheme, and one set of confirming runs.
  double min_work() const {
    const double search = 5 * way * choosing * static_cast<double>(advice_.candidates.size());
    return confirming * 1000 * preparation_length() +
           (search + confirming) * min_length() * 3.3 * frequency_;
  }

  /// Prepares the initial state of the run.
  bool prepare_base() {
    report("equilibrating");
    if (config_.run.minimise)
      minimise(
          base_, {}, [this](std::size_t, const Steepness&) { return stop(); }, workers_);
    if (config_.run.equilibrate > 0) {
      ForceField forces(base_.topology, base_.forces, base_.state.box, workers_);
      if (!equilibrate(base_, forces, config_.run.equilibrate, {nullptr, callbacks_.stop},
                       workers_))
        return false;
    }
    noise_ = force_noise(base_, workers_);
    frequency_ = einstein_frequency(base_, base_.state, workers_);
    check_forces(frequency_, config_.source);
    for (const Candidate& candidate : advice_.candidates)
      check_length(config_.run.length, search_of(candidate).first, candidate.name);
    since_start_ = Stopwatch();
    return !stop();
  }

  /// Prepares the conversion of biases from constant energy to the run file's ensemble.
  void prepare_conversion() {
    if (!needs_conversion(settings_.criterion.quality, config_.ensemble)) return;
    constexpr double cost = 2, part = 0.2 * cost;  // cost of hoa2; its step times the frequency
    const double step = three_digits(part / frequency_);
    const ResponseRuns runs{
        step,
        std::max(affordable(budget(response_share), choosing, cost / step), 10 * min_length())};
    const auto count = counting_stop(cost, "measuring how averages depend on the temperature");
    conversion_ = bias_conversion(config_, starts_, runs, callbacks_, count, workers_);
  }

  double preparation_length() const { return std::min(preparation, config_.study.decorrelate); }

  /// Draws initial configurations with new momenta.
  std::vector<ResumableRun> fresh_starts(std::size_t count) {
    report("preparing initial configurations");
    std::vector<ResumableRun> starts;
    for (std::size_t k = 0; k < count; ++k)
      starts.push_back({base_, start_seed(config_, drawn_ + k)});
    workers_.each(count, [&](std::size_t k) {
      if (!stop())
        starts[k].system = prepare_start(base_, config_, drawn_ + k, preparation_length(),
                                         counting_stop(1, "preparing initial configurations"));
    });
    drawn_ += count;
    return starts;
  }

  /// Continues a run up to the length of the job.
  Outcome advance(ResumableRun& resumable, const Job& job) const {
    const Scheme& scheme = advice_.candidates[job.candidate].scheme;
    Outcome run = advance_run(
        resumable,
        {.scheme = scheme,
         .step = job.step,
         .length = job.length,
         .sample = std::min(config_.run.sample, max_sample_interval),
         .lambda = config_.integrator.lambda,
         .configurational_sample = sample_cost / temperature_share * job.step / scheme.cost()},
        noise_, counting_stop(scheme.cost(), advice_.candidates[job.candidate].name));
    if (conversion_ && run.failure.empty()) conversion_->apply(run);
    return run;
  }

  /// Runs every job from every initial configuration, as many at a time as there are workers.
  std::vector<AdviserPoint> measure(const std::vector<Job>& jobs) const {
    std::vector<AdviserPoint> points;
    for (const Job& job : jobs)
      points.push_back({job.step, job.length, std::vector<Outcome>(starts_.size())});
    double work = 0;
    for (const Job& job : jobs) work += work_of(job, starts_.size());
    effort_.expect(std::max(work + min_work(), budget(1) / evaluation_ - effort_.done()));
    workers_.each(jobs.size() * starts_.size(), [&](std::size_t k) {
      if (stop()) return;
      const std::size_t j = k / starts_.size(), r = k % starts_.size();
      ResumableRun resumable = starts_[r];
      points[j].runs[r] = advance(resumable, jobs[j]);
    });
    for (AdviserPoint& point : points) judge(point);
    return points;
  }

  /// The number of force evaluations of runs.
  double work_of(const Job& job, std::size_t runs) const {
    return static_cast<double>(runs) * job.length / job.step *
           advice_.candidates[job.candidate].scheme.cost();
  }

  void judge(AdviserPoint& point) const {
    point.bound = upper_bound(settings_.criterion, point.runs);
    point.usable = !blew_up(point.runs) && !drifts(point.runs, significance_level);
  }

  /// Whether no blow-up and no energy drift excludes the step of a point.
  bool calm(const AdviserPoint& point) const {
    return !blew_up(point.runs) &&
           (settings_.criterion.quality == Quality::drift || !drifts(point.runs));
  }

  /// Whether a single run of full length already shows that its set of runs cannot meet the bound.
  /// Of eight values, no value can be more than 7/√8 = 2.47 standard deviations above the mean. The
  /// prediction bound of eight runs is 2.51 standard deviations above the mean.
  bool breaks(const Outcome& run) const {
    return settings_.criterion.quality == Quality::ratio &&
           (!run.failure.empty() || run.ratio > settings_.criterion.bound);
  }

  /// Performs confirming runs until they end, or until they cannot meet the bound any more.
  AdviserPoint confirming_runs(std::vector<ResumableRun> resumable_runs, const Job& whole) const {
    AdviserPoint point{whole.step, whole.length, std::vector<Outcome>(resumable_runs.size())};
    effort_.expect(work_of(whole, resumable_runs.size()));
    for (const double part : parts) {
      if (part < 1 && part * whole.length < min_length()) continue;
      const Job job{whole.candidate, whole.step, part * whole.length};
      std::atomic<bool> broken = false;
      std::vector<char> done(resumable_runs.size(), 0);
      workers_.each(resumable_runs.size(), [&](std::size_t r) {
        // At least two runs are needed to estimate the scatter.
        if (stop() || (broken && r >= 2)) return;
        point.runs[r] = advance(resumable_runs[r], job);
        done[r] = 1;
        if (part == 1 && breaks(point.runs[r])) broken = true;
      });
      if (stop()) return point;
      point.length = job.length;
      if (broken) {
        std::vector<Outcome> ended;
        for (std::size_t r = 0; r < done.size(); ++r)
          if (done[r]) ended.push_back(point.runs[r]);
        point.runs = std::move(ended);
      }
      judge(point);
      if (!calm(point) || !may_meet(settings_.criterion, point.runs, part)) break;
      if (part >= telling && longer_step(whole.candidate, point)) break;
    }
    return point;
  }

  /// A longer step that is worth trying, if the runs are far enough below the bound. R scatters
  /// more in incomplete runs, so their margin to the bound is underestimated.
  std::optional<double> longer_step(std::size_t c, const AdviserPoint& point) const {
    const Candidate& candidate = advice_.candidates[c];
    if (settings_.criterion.quality != Quality::ratio || !candidate.model || !calm(point) ||
        advice_.surpassed.size() >= max_lengthenings ||
        since_start_.seconds() + last_set_ > settings_.seconds)
      return std::nullopt;
    double too_long = std::numeric_limits<double>::infinity();
    for (const AdviserPoint& p : candidate.points)
      if (!p.usable) too_long = std::min(too_long, p.step);
    for (const auto& [of, p] : advice_.refused)
      if (of == c) too_long = std::min(too_long, p.step);
    return lengthened(point.step, point.bound / settings_.criterion.bound,
                      candidate.model->exponent(point.step), too_long);
  }

  /// The minimum length of useful runs [ps].
  double min_length() const { return std::min(config_.run.length, 60 / frequency_); }

  /// The total time of all runs, in seconds of one thread.
  double budget(double share) const { return share * settings_.seconds * workers_.threads(); }

  /// The length of each of `runs` runs that together fit into a given computing time.
  double affordable(double seconds, double runs, double cost) const {
    return seconds / (runs * cost * evaluation_);
  }

  StepSearch search_of(const Candidate& candidate) const {
    // For a good scheme, a harmonic degree of freedom of frequency ω is stable up to ω h = 2 per
    // force evaluation. In a liquid, the highest frequency is about twice the mean frequency.
    const double first = 0.12 * std::min(3.0, candidate.scheme.cost()) / frequency_;
    return {settings_.criterion, candidate.scheme.order(), three_digits(first)};
  }

  /// The expected force evaluations per ps of a scheme; 0 if nothing is known yet.
  double expected_cost(std::size_t c) const {
    const Candidate& candidate = advice_.candidates[c];
    if (settled_[c] && candidate.step == 0) return std::numeric_limits<double>::infinity();
    return candidate.scheme.cost() /
           (settled_[c] ? candidate.step
                        : max_expected_step(search_of(candidate), candidate.points));
  }

  /// The maximum cost at which a scheme may be the best or second-best and deserves further runs.
  double worthwhile() const {
    std::vector<double> costs;
    for (std::size_t c = 0; c < settled_.size(); ++c) costs.push_back(expected_cost(c));
    std::sort(costs.begin(), costs.end());
    return hopeless * costs[std::min<std::size_t>(1, costs.size() - 1)];
  }

  std::string waiting(std::size_t c) const {
    return fmt::format(
        "the scheme is expected to need at least {:.0f} force evaluations per ps, more than the "
        "best schemes",
        expected_cost(c));
  }

  /// Runs every promising candidate at the steps that its search still needs.
  void search_steps() {
    // The estimate assumes runs with about five different time steps for each scheme. For the
    // Einstein frequency ω, an R of 0.5 % costs about 3.3 ω force evaluations per ps.
    const double runs = 5.0 * choosing * static_cast<double>(advice_.candidates.size());
    const double max_length = std::min(config_.run.length, 600 / frequency_);
    const double length = std::clamp(affordable(budget(choosing_share), runs, 3.3 * frequency_),
                                     min_length(), max_length);
    for (std::size_t settled = 0; settled < settled_.size() && !stop();) {
      std::vector<Job> jobs;
      const double costliest = worthwhile();
      settled = 0;
      for (std::size_t c = 0; c < settled_.size(); ++c) {
        Candidate& candidate = advice_.candidates[c];
        if (settled_[c] || expected_cost(c) > costliest) {
          ++settled;
          continue;
        }
        const StepSearch search = search_of(candidate);
        const auto step = next_step(search, candidate.points);
        // A run has at least ten steps, the minimum for R.
        if (step && length >= 10 * *step)
          jobs.push_back({c, *step,
                          decides(search, candidate.points, *step)
                              ? length
                              : std::max({way * length, min_length(), 10 * *step})});
        else
          settle(c);
      }
      const std::vector<AdviserPoint> found = measure(jobs);
      for (std::size_t j = 0; j < jobs.size(); ++j) {
        auto& points = advice_.candidates[jobs[j].candidate].points;
        const auto place = std::find_if(points.begin(), points.end(), [&](const AdviserPoint& p) {
          return p.step > found[j].step;
        });
        points.insert(place, found[j]);
      }
    }
  }

  void settle(std::size_t c) {
    Candidate& candidate = advice_.candidates[c];
    const FoundStep found = found_step(search_of(candidate), candidate.points);
    settled_[c] = true;
    candidate.model = found.model;
    if (found.step > 0)
      candidate.step =
          three_digits((found.model ? reserve(found.model->exponent(found.step)) : 1) * found.step);
    else
      candidate.obstacle = "no step tried meets the bound";
  }

  /// The cheapest eligible candidate, by the computing time per simulated ps.
  std::optional<std::size_t> cheapest(std::optional<std::size_t> besides = {}) const {
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < advice_.candidates.size(); ++c) {
      const Candidate& candidate = advice_.candidates[c];
      if (candidate.step == 0 || besides == c) continue;
      if (!best || candidate.seconds < advice_.candidates[*best].seconds) best = c;
    }
    return best;
  }

  /// Tries steps until a step is confirmed and much longer steps are ruled out.
  void confirm() {
    std::vector<ResumableRun> starts;
    while (advice_.refused.size() < max_refusals) {
      search_steps();  // includes candidates that became promising when another was rejected
      if (stop()) return;
      time_candidates(
          advice_.candidates, starts_.front().system, config_, clock_share * settings_.seconds,
          [this](const std::string& name) { report("clocking " + name); }, callbacks_.stop,
          workers_);
      if (stop()) return;
      const auto c = advice_.best ? advice_.best : cheapest();
      if (!c) return;
      // New initial configurations after a rejection would favour runs with a low R by chance.
      if (starts.empty()) starts = fresh_starts(confirming);
      if (stop()) return;
      Candidate& candidate = advice_.candidates[*c];
      const double cost = candidate.scheme.cost() / candidate.step;
      const double left =
          std::max(min_confirming_share, 1 - since_start_.seconds() / settings_.seconds);
      const double length = advice_.best ? advice_.confirmation.length
                                         : std::clamp(affordable(budget(left), confirming, cost),
                                                      min_length(), config_.run.length);
      const Stopwatch watch;
      const AdviserPoint point = confirming_runs(starts, {*c, candidate.step, length});
      if (stop()) return;
      if (point.length == length) last_set_ = watch.seconds();
      const auto longer = longer_step(*c, point);
      if (calm(point) && point.length == length && point.bound <= settings_.criterion.bound) {
        if (advice_.best) advice_.surpassed.emplace_back(*c, advice_.confirmation);
        advice_.best = c;
        advice_.runner_up = cheapest(c);
        advice_.confirmation = point;
        if (!longer) return;
      } else if (longer) {
        advice_.surpassed.emplace_back(*c, point);
      } else {
        advice_.refused.emplace_back(*c, point);
        if (advice_.best) {  // try a step between the rejected and the confirmed step
          const auto between = longer_step(*c, advice_.confirmation);
          set_step(candidate, between.value_or(advice_.confirmation.step));
          if (!between) return;
          continue;
        }
        shorten(candidate, point, point.length / length);
        continue;
      }
      set_step(candidate, *longer);
    }
  }

  /// Changes the step of a candidate. The computing time per step remains the same.
  static void set_step(Candidate& candidate, double step) {
    candidate.seconds *= candidate.step / step;
    candidate.step = step;
  }

  /// Shortens the step of a candidate after unsuccessful confirming runs.
  /// @param part  fraction of the length that the runs covered
  void shorten(Candidate& candidate, const AdviserPoint& point, double part) const {
    const double factor = calm(point) && candidate.model
                              ? shortening(settings_.criterion, point.runs, confirming, part,
                                           candidate.model->exponent(candidate.step))
                              : 0.85;
    set_step(candidate, three_digits(factor * candidate.step));
  }

  const Config& config_;
  const AdviserSettings& settings_;
  const Callbacks& callbacks_;
  Workers& workers_;
  System base_;
  ForceNoise noise_;
  mutable Effort effort_;  // effort in force evaluations
  double frequency_ = 0;   // Einstein frequency [1/ps]
  double evaluation_ = 0;  // time of a force evaluation, in seconds of one thread
  std::vector<ResumableRun> starts_;
  std::optional<BiasConversion> conversion_;
  double last_set_ = 0;        // time that the last set of runs took [s]
  std::vector<bool> settled_;  // candidates with sufficiently accurate steps
  std::size_t drawn_ = 0;      // number of initial configurations drawn so far
  Stopwatch since_start_;
  mutable std::mutex reporting_;
  const Stopwatch watch_{};
  mutable SharedPace pace_;  // pace of progress reports after steps
  Advice advice_;
};

}  // namespace

Advice advise(const Config& config, const AdviserSettings& settings, const Callbacks& callbacks,
              Workers& workers) {
  return Adviser(config, settings, callbacks, workers).advice();
}

}  // namespace polhode
