// SPDX-License-Identifier: MIT
// Requests: the options that a front end received for a job, as texts. Each request is read once,
// into the settings of its job. Errors name the option.
#pragma once

#include <string>
#include <vector>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/run/adviser/adviser.hpp"
#include "polhode/run/study/tune.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/canonical/hybrid_adviser.hpp"
#include "run/conversion/conversion.hpp"
#include "run/given.hpp"
#include "run/study/study_report.hpp"

namespace polhode {

struct MinimisationRequest {
  Given max_force, max_torque, max_steps;

  static std::vector<RequestOption<MinimisationRequest>> options();
  MinimisationSettings settings() const;
};

struct ConversionRequest {
  Given particles, names, every, start, stop;

  static std::vector<RequestOption<ConversionRequest>> options();
  /// The settings of a conversion.
  /// @param run  settings of the run whose molecules are the particles of a dump file; if null, the
  ///   run file in the request is used, if any
  Conversion conversion(const std::string& from, const std::string& to,
                        const Config* run = nullptr) const;
};

struct AdviceRequest {
  Given accuracy, drift, temperature_bias, bias, ensemble, evaluations, time, output;

  static std::vector<RequestOption<AdviceRequest>> options();
  std::string prefix() const { return output ? output.text : "advice"; }
  /// Whether advice for hybrid Monte Carlo is requested. For hybrid Monte Carlo, no bound on a bias
  /// is needed, because there is no time-step bias.
  bool is_canonical() const;
  /// @throws Error  also if the request and the run file together contain no requirement, or more
  ///   than one, and for options that apply only to hybrid Monte Carlo
  AdviserSettings settings(const Config& config) const;
  /// @param schemes_given  whether to use the candidates of the settings, which must then be a
  ///   single scheme
  /// @param length  length of the run, if a front end received one
  /// @throws Error  also for options that do not apply to hybrid Monte Carlo, such as the length
  HybridAdviserSettings hybrid_settings(const Config& config, bool schemes_given,
                                        const Given& length) const;
};

struct StudyRequest {
  Given from_record, output;
  bool quick = false;

  static std::vector<RequestOption<StudyRequest>> options();
  std::string prefix() const { return output ? output.text : "study"; }
};

/// Performs the study of the settings, or makes the tables and the figure of a record. An
/// interrupted study resumes from its record.
/// @param use  function that receives the report of either kind of study; its result is returned
template <class Use>
auto perform_study(Config config, const StudyRequest& request, OutputOptions output,
                   const Callbacks& callbacks, Workers& workers, const Use& use) {
  config.study.coarse = request.quick;
  if (output.existing == ExistingFiles::refuse && !request.from_record)
    output.existing = ExistingFiles::resume;
  const auto perform = [&](auto run) {
    return use(run(config, request.from_record.text, request.prefix(), output, callbacks, workers));
  };
  if (config.study.ensemble == StudyEnsemble::nvt) return perform(run_canonical_study);
  return perform(run_study);
}

struct TuneRequest {
  Given scheme, step, runs, length, decorrelate, sample;

  static std::vector<RequestOption<TuneRequest>> options();
  TuneSettings settings(const Config& config) const;
};

struct BenchmarkRequest {
  Given sizes, precision;

  static std::vector<RequestOption<BenchmarkRequest>> options();
  /// @param threads  number of threads whose speed is compared with a single thread
  BenchmarkSettings settings(bool is_quick, int threads) const;
};

struct VerificationRequest {
  Given order, lambda;

  static std::vector<RequestOption<VerificationRequest>> options();
  int expected_order() const;
  /// The displacement factor λ of gradient kicks.
  /// @param scheme  scheme with this factor in its gradients
  double gradient_lambda(const NestedScheme& scheme) const;
};

/// A free top and the times of its trajectory, in any consistent units.
struct FreeTop {
  Vec3<double> J, L;  ///< principal moments, and angular momentum in the body frame
  double step = 0, length = 0;
};

struct TopRequest {
  Given J, L, step, length, output, table, method;

  static std::vector<RequestOption<TopRequest>> options();
  /// The top that the request describes.
  /// @throws Error  unless the request has three moments and three components of L; the message
  ///   names the option
  FreeTop top() const;
  /// The rotations of a table of tops, see rotate_table().
  std::string rotated_table() const;
};

}  // namespace polhode
