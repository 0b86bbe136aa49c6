// SPDX-License-Identifier: MIT
#include "polhode/run/study/tune.hpp"

#include <fmt/core.h>

#include <cmath>
#include <mutex>

#include "base/instruction_set.hpp"
#include "base/version.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

struct Runs {
  std::vector<ErrorCovariance> covariances;
  std::vector<double> ratios;
};

/// Distributes runs, and reports how many are done.
class Series {
 public:
  Series(const Config& config, const TuneSettings& settings, const Callbacks& callbacks,
         Workers& workers, const System& base, std::size_t families)
      : config_(config),
        settings_(settings),
        callbacks_(callbacks),
        workers_(workers),
        all_(static_cast<double>(settings.runs) * (2 + 3 * static_cast<double>(families))) {
    starts_.assign(2 * static_cast<std::size_t>(settings.runs), base);
    workers.each(starts_.size(), [&](std::size_t r) {
      if (stopped()) return;
      starts_[r] = prepare_start(base, config, r, settings.decorrelate, callbacks.stop);
      advance("preparing initial configurations");
    });
  }

  bool stopped() const { return callbacks_.stopped(); }

  /// Runs a scheme. Runs from the first half of the initial configurations measure error brackets,
  /// and runs from the second half confirm the result.
  Runs runs(const Scheme& scheme, const std::string& label, bool brackets) {
    const auto n = static_cast<std::size_t>(settings_.runs);
    Runs result{std::vector<ErrorCovariance>(brackets ? n : 0), std::vector<double>(n)};
    std::vector<std::string> failures(n);
    workers_.each(n, [&](std::size_t r) {
      if (stopped()) return;
      System system = starts_[brackets ? r : n + r];
      ForceField forces(system.topology, system.forces, system.state.box);
      std::vector<BracketSample> samples;
      const Watch watch{.stop = callbacks_.stop, .brackets = [&](const BracketSample& sample) {
                          samples.push_back(sample);
                        }};
      const Trajectory t =
          run_trajectory(system, forces,
                         {scheme, settings_.step, settings_.length, max_sample_interval,
                          config_.integrator.lambda, brackets ? settings_.sample : 0},
                         watch);
      failures[r] = t.failure;
      if (!t.failure.empty() || stopped()) return;
      result.ratios[r] = t.statistics.energies.ratio();
      if (brackets) result.covariances[r] = error_covariance(samples, settings_.step);
      advance(label);
    });
    for (const std::string& failure : failures)
      if (!failure.empty()) throw RunError(failure);
    return result;
  }

 private:
  void advance(const std::string& what) {
    const std::lock_guard lock(guard_);
    callbacks_.report({"tuning", ++done_ / all_, what});
  }

  const Config& config_;
  const TuneSettings& settings_;
  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<System> starts_;
  std::mutex guard_;
  double done_ = 0, all_;  // work for the initial configurations of both halves, and for 3 series
                           // of each family
};

ErrorCovariance sum_without(const std::vector<ErrorCovariance>& all, std::size_t without) {
  ErrorCovariance sum;
  for (std::size_t r = 0; r < all.size(); ++r)
    if (r != without) sum += all[r];
  return sum;
}

Tuned tuned(Series& series, const SchemeFamily& family, const Runs& measured) {
  const std::size_t n = measured.covariances.size();
  const ErrorCovariance all = sum_without(measured.covariances, n);
  const std::vector<double> best = best_parameters(all, family);
  Tuned t{.reference = family.label(), .scheme = family.at(best), .parameters = {}};
  std::vector<std::vector<double>> without;
  for (std::size_t r = 0; r < n; ++r)
    without.push_back(best_parameters(sum_without(measured.covariances, r), family));
  for (std::size_t k = 0; k < best.size(); ++k) {
    std::vector<double> values;
    for (const std::vector<double>& one : without) values.push_back(one[k]);
    t.parameters.push_back({family.parameters()[k].name, best[k], jackknife_error(values)});
  }
  const ErrorTerms change = error_terms(t.scheme) - error_terms(family.reference());
  t.predicted_gain = std::sqrt(all.EE / all.variance(change));

  const std::vector<double> before = series.runs(family.reference(), family.label(), false).ratios;
  const std::vector<double> after = series.runs(t.scheme, family.label(), false).ratios;
  std::vector<double> gains;
  for (std::size_t r = 0; r < n; ++r) gains.push_back(before[r] / after[r]);
  t.reference_ratio = mean(before), t.ratio = mean(after), t.gain = mean(gains);
  return t;
}

/// The requested family, or the families of hoa2 and gier4.
std::vector<SchemeFamily> families(const TuneSettings& settings, const Config& config) {
  if (!settings.scheme.empty()) return {SchemeFamily(settings.scheme)};
  const NamedScheme& scheme = config.integrator.scheme;
  if (!free_parameters(scheme.text).empty()) return {SchemeFamily(scheme)};
  return {hoa2_family(), gier4_family()};
}

/// Completes the settings: the step of the run file is used unless the settings give a step.
TuneSettings complete(TuneSettings settings, const Config& config) {
  at_place(config.source, [&] { single_scheme_of(config.integrator.scheme); });
  if (settings.step == 0) settings.step = config.integrator.step;
  constexpr double min_repeats = 20;  // minimum number of samples for covariances of three
                                      // quantities
  if (settings.length < min_repeats * settings.sample)
    throw Error(fmt::format(
        "the length of {:g} fs is shorter than {:g} intervals between samples of the error "
        "brackets, {:g} fs each; use "
        "longer runs, or a shorter interval between samples",
        settings.length * units::fs_per_ps, min_repeats, settings.sample * units::fs_per_ps));
  return settings;
}

Quantities of_family(const Tuned& t) {
  Quantities parameters;
  for (const TunedParameter& p : t.parameters)
    parameters.push_back({p.name, "", nested({p.value, p.error}), "", p.name});
  return {row("", ""),
          {"reference", "", t.reference, "scheme that is optimized", "family of"},
          {"parameters", "", parameters, "optimized parameters"},
          {"R", "%", t.ratio, "R with these parameters; `R_error` is the standard error", "R"},
          {"R_reference", "%", t.reference_ratio,
           "R of the reference scheme; `R_reference_error` is the standard error",
           "R of the reference"},
          {"gain", "", t.gain, "`R_reference` divided by `R`; `gain_error` is the standard error",
           "gain", ", measured"},
          {"predicted_gain", "", t.predicted_gain, "gain predicted from the error brackets", "gain",
           ", predicted"},
          {"scheme", "", text_of(t.scheme), "stages of the optimized scheme", "as text"}};
}

/// rms of an error bracket, from the sum of its mean squares over the runs [kJ/mol].
double rms_bracket(double squares, const TuneSettings& settings) {
  return std::sqrt(squares / settings.runs);
}

}  // namespace

TuneResult tune(const Config& config, const TuneSettings& given, const Callbacks& callbacks,
                Workers& workers) {
  const TuneSettings settings = complete(given, config);
  const std::vector<SchemeFamily> all = families(settings, config);
  const System base = build_system(config);
  callbacks.note(fmt::format(
      "polhode {}: tuning for {} molecules at {:g} fs, {} runs of {:g} ps for tuning and {} for "
      "confirmation, instruction set {}, threads {}",
      version(), base.topology.size(), settings.step * units::fs_per_ps, settings.runs,
      settings.length, settings.runs, name(current_instruction_set()), workers.threads()));
  note_molecules(base, callbacks);
  note_forces(base, callbacks);
  Series series(config, settings, callbacks, workers, base, all.size());
  TuneResult result{.settings = settings,
                    .molecules = base.topology.size(),
                    .covariance = {},
                    .short_steps = {},
                    .families = {}};
  for (const SchemeFamily& family : all) {
    const Runs measured = series.runs(family.reference(), family.label(), true);
    if (callbacks.stopped()) break;  // runs without results have no best parameters
    if (result.families.empty()) {
      result.covariance = sum_without(measured.covariances, measured.covariances.size());
      if (!(result.covariance.aa > 0))
        throw Error(
            "the error of order h² is zero, because no forces act on the molecules; use a system "
            "whose molecules interact",
            config.source);
      if (all.size() > 1) result.short_steps = best_at_short_steps(result.covariance, family)[0];
    }
    result.families.push_back(tuned(series, family, measured));
  }
  result.interrupted = callbacks.stopped();
  return result;
}

Quantities quantities(const TuneResult& r) {
  std::vector<Quantities> families;
  for (const Tuned& family : r.families) families.push_back(of_family(family));
  Quantities list = {
      {"molecules", "", r.molecules, "number of molecules", "molecules"},
      {"step", "fs", r.settings.step * units::fs_per_ps, "time step", "step"},
      {"runs", "", r.settings.runs, "number of runs for tuning; as many runs confirm the result",
       "runs"},
      {"length", "ps", r.settings.length, "length of each run", "length"},
      {"rms_first_bracket", "kJ/mol", rms_bracket(r.covariance.aa, r.settings),
       "rms of h² times the first error bracket", "first bracket"},
      {"rms_second_bracket", "kJ/mol", rms_bracket(r.covariance.bb, r.settings),
       "rms of h² times the second error bracket", "second bracket"},
      {"correlation", "", r.covariance.ab / std::sqrt(r.covariance.aa * r.covariance.bb),
       "correlation of the two error brackets", "correlation"}};
  if (r.short_steps)
    list.push_back({"eta_of_short_steps", "", *r.short_steps, "optimal eta for short steps",
                    "eta of short steps"});
  list.push_back({"families", "", families, "optimized schemes"});
  return list;
}

}  // namespace polhode
