// SPDX-License-Identifier: MIT
#include "polhode/run/study/tune.hpp"

#include <fmt/core.h>

#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>

#include "polhode/base/error.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/base/version.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/run/simulation/system_notes.hpp"
#include "polhode/run/simulation/trajectory.hpp"

namespace polhode {
namespace {

ErrorTerms difference(const ErrorTerms& a, const ErrorTerms& b) {
  return {a.alpha - b.alpha, a.beta - b.beta};
}

/// The minimum of a function of η, which is unique between position and velocity Verlet.
FamilyMember minimise(const std::function<double(double)>& variance) {
  constexpr int bits = 26;  // half of the digits: a minimum cannot be located more precisely
  return {boost::math::tools::brent_find_minima(variance, 0.0, 0.5, bits).first, 0};
}

}  // namespace

Scheme family_scheme(double eta, double xi) {
  const std::array stages{B(eta), A(0.5), B(1 - 2 * eta, xi), A(0.5), B(eta)};
  return {stages, 2};
}

ErrorCovariance& ErrorCovariance::operator+=(const ErrorCovariance& other) {
  EE += other.EE, Ea += other.Ea, Eb += other.Eb;
  aa += other.aa, ab += other.ab, bb += other.bb;
  VV += other.VV;
  return *this;
}

double ErrorCovariance::variance(const ErrorTerms& change) const {
  const auto [x, y] = change;
  return EE - 2 * (x * Ea + y * Eb) + x * x * aa + 2 * x * y * ab + y * y * bb;
}

ErrorCovariance error_covariance(std::span<const BracketSample> samples, double h) {
  struct Row {
    double E, a, b, V;
  };
  std::vector<Row> rows;
  Row mean{};
  const auto n = static_cast<double>(samples.size());
  for (const BracketSample& s : samples) {
    rows.push_back({s.energies.total(), h * h * s.brackets.second_derivative, h * h * s.brackets.W,
                    s.energies.potential()});
    const Row& r = rows.back();
    mean.E += r.E / n, mean.a += r.a / n, mean.b += r.b / n, mean.V += r.V / n;
  }
  ErrorCovariance c;
  for (const Row& r : rows) {
    const double E = r.E - mean.E, a = r.a - mean.a, b = r.b - mean.b, V = r.V - mean.V;
    c += {E * E / n, E * a / n, E * b / n, a * a / n, a * b / n, b * b / n, V * V / n};
  }
  return c;
}

FamilyMember best_plain(const ErrorCovariance& covariance, const Scheme& reference) {
  return minimise([&](double eta) {
    return covariance.variance(
        difference(error_terms(family_scheme(eta, 0)), error_terms(reference)));
  });
}

FamilyMember best_plain_at_short_steps(const ErrorCovariance& covariance) {
  ErrorCovariance brackets = covariance;
  brackets.EE = brackets.Ea = brackets.Eb = 0;
  return minimise(
      [&](double eta) { return brackets.variance(error_terms(family_scheme(eta, 0))); });
}

FamilyMember best_gradient(const ErrorCovariance& c, const Scheme& reference) {
  // If the brackets are perfectly correlated, one combination is undetermined and kept.
  constexpr double min_part = 1e-9;
  const double aa = c.aa * (1 + min_part), bb = c.bb * (1 + min_part);
  const double determinant = aa * bb - c.ab * c.ab;
  const ErrorTerms from = error_terms(reference);
  const double alpha = from.alpha + (c.Ea * bb - c.Eb * c.ab) / determinant;
  const double beta = from.beta + (c.Eb * aa - c.Ea * c.ab) / determinant;
  const double eta = (24 * alpha + 1) / 6;  // α = (6η − 1)/24, and β falls by (1 − 2η) ξ
  return {eta, (error_terms(family_scheme(eta, 0)).beta - beta) / (1 - 2 * eta)};
}

namespace {

struct Runs {
  std::vector<ErrorCovariance> covariances;
  std::vector<double> ratios;
};

/// Distributes runs, and reports how many are done.
class Series {
 public:
  Series(const Config& config, const TuneSettings& settings, const Callbacks& callbacks,
         Workers& workers, const System& base)
      : config_(config), settings_(settings), callbacks_(callbacks), workers_(workers) {
    starts_.assign(2 * static_cast<std::size_t>(settings.runs), base);
    workers.each(starts_.size(), [&](std::size_t r) {
      if (stopped()) return;
      starts_[r] = prepare_start(base, config, r, settings.decorrelate, callbacks.stop);
      advance("preparing initial configurations");
    });
  }

  bool stopped() const { return callbacks_.stopped(); }

  /// Runs a scheme: the first half of the initial configurations measures brackets, the second
  /// confirms.
  Runs runs(const Scheme& scheme, bool brackets) {
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
      advance(std::string(scheme.name()));
    });
    for (const std::string& failure : failures)
      if (!failure.empty()) throw RunError(failure);
    return result;
  }

 private:
  void advance(const std::string& what) {
    const std::lock_guard lock(guard_);
    const double all = 8 * settings_.runs;  // initial configurations of both halves, two families
                                            // of 3 series each
    callbacks_.report({"tuning", ++done_ / all, what});
  }

  const Config& config_;
  const TuneSettings& settings_;
  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<System> starts_;
  std::mutex guard_;
  double done_ = 0;
};

ErrorCovariance sum_without(const std::vector<ErrorCovariance>& all, std::size_t without) {
  ErrorCovariance sum;
  for (std::size_t r = 0; r < all.size(); ++r)
    if (r != without) sum += all[r];
  return sum;
}

using Choice = std::function<FamilyMember(const ErrorCovariance&)>;

Tuned tuned(Series& series, const Scheme& reference, const Runs& measured, const Choice& choice) {
  const std::size_t n = measured.covariances.size();
  const ErrorCovariance all = sum_without(measured.covariances, n);
  const FamilyMember member = choice(all);
  Tuned t{reference, family_scheme(member.eta, member.xi), member, {}, 1, {}, {}, {}};
  std::vector<double> etas, xis;
  for (std::size_t r = 0; r < n; ++r) {
    const FamilyMember without = choice(sum_without(measured.covariances, r));
    etas.push_back(without.eta), xis.push_back(without.xi);
  }
  t.error = {jackknife_error(etas), jackknife_error(xis)};
  t.predicted_gain =
      std::sqrt(all.EE / all.variance(difference(error_terms(t.scheme), error_terms(reference))));

  const std::vector<double> before = series.runs(reference, false).ratios;
  const std::vector<double> after = series.runs(t.scheme, false).ratios;
  std::vector<double> gains;
  for (std::size_t r = 0; r < n; ++r) gains.push_back(before[r] / after[r]);
  t.reference_ratio = mean(before), t.ratio = mean(after), t.gain = mean(gains);
  return t;
}

/// The settings, with the run file's step unless they have one.
TuneSettings complete(TuneSettings settings, const Config& config) {
  try {
    single_scheme_of(config.integrator.scheme);
  } catch (const Error& e) {
    throw e.at(config.source);
  }
  if (settings.step == 0) settings.step = config.integrator.step;
  constexpr double min_repeats = 20;  // for covariances of three quantities
  if (settings.length < min_repeats * settings.sample)
    throw Error(fmt::format(
        "length {:g} fs is shorter than {:g} samples of the error brackets, {:g} fs apart; take "
        "longer runs, or a shorter interval between samples",
        settings.length * units::fs_per_ps, min_repeats, settings.sample * units::fs_per_ps));
  return settings;
}

nlohmann::json as_json(const Tuned& t) {
  return {{"reference", t.reference.name()},
          {"scheme", text_of(t.scheme)},
          {"eta", t.member.eta},
          {"eta_error", t.error.eta},
          {"xi", t.member.xi},
          {"xi_error", t.error.xi},
          {"predicted_gain", t.predicted_gain},
          {"R_reference", t.reference_ratio.value},
          {"R_reference_error", t.reference_ratio.error},
          {"R", t.ratio.value},
          {"R_error", t.ratio.error},
          {"gain", t.gain.value},
          {"gain_error", t.gain.error}};
}

}  // namespace

double correlation(const ErrorCovariance& c) { return c.ab / std::sqrt(c.aa * c.bb); }

double rms_bracket(double squares, const TuneSettings& settings) {
  return std::sqrt(squares / settings.runs);
}

TuneResult tune(const Config& config, const TuneSettings& given, const Callbacks& callbacks,
                Workers& workers) {
  const TuneSettings settings = complete(given, config);
  const System base = build_system(config);
  callbacks.note(fmt::format(
      "polhode {}: tuning for {} molecules at {:g} fs, {} runs of {:g} ps that measure and {} that "
      "confirm, instruction set {}, threads {}",
      version(), base.topology.size(), settings.step * units::fs_per_ps, settings.runs,
      settings.length, settings.runs, name(current_instruction_set()), workers.threads()));
  note_molecules(base, callbacks);
  note_forces(base, callbacks);
  Series series(config, settings, callbacks, workers, base);
  const Scheme hoa2 = scheme_of("hoa2"), gier4 = scheme_of("gier4");
  const Runs plain = series.runs(hoa2, true);
  const ErrorCovariance sum = sum_without(plain.covariances, plain.covariances.size());
  const double short_steps = best_plain_at_short_steps(sum).eta;
  const Tuned first =
      tuned(series, hoa2, plain, [&](const ErrorCovariance& c) { return best_plain(c, hoa2); });
  const Tuned second = tuned(series, gier4, series.runs(gier4, true),
                             [&](const ErrorCovariance& c) { return best_gradient(c, gier4); });
  return {settings, base.topology.size(), sum, short_steps, first, second, callbacks.stopped()};
}

std::string tune_json(const TuneResult& r) {
  return nlohmann::json{{"molecules", r.molecules},
                        {"step_fs", r.settings.step * units::fs_per_ps},
                        {"runs", r.settings.runs},
                        {"length_ps", r.settings.length},
                        {"rms_first_bracket_kJ_per_mol", rms_bracket(r.covariance.aa, r.settings)},
                        {"rms_second_bracket_kJ_per_mol", rms_bracket(r.covariance.bb, r.settings)},
                        {"correlation", correlation(r.covariance)},
                        {"eta_of_short_steps", r.short_steps},
                        {"plain", as_json(r.plain)},
                        {"gradient", as_json(r.gradient)}}
      .dump(2);
}

}  // namespace polhode
