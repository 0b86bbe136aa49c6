// SPDX-License-Identifier: MIT
// What a front end was given for a job, as texts; each request is read once, into the settings of
// its job. Errors name the option.
#pragma once

#include <string>
#include <vector>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/run/adviser/adviser.hpp"
#include "polhode/run/study/tune.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/canonical/hybrid_adviser.hpp"
#include "run/conversion/conversion.hpp"
#include "run/given.hpp"

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
  /// @param run  settings of the run with the molecules for the particles of a dump file; if null,
  ///   the request gives its run file, or there is none
  Conversion conversion(const std::string& from, const std::string& to,
                        const Config* run = nullptr) const;
};

struct AdviceRequest {
  Given accuracy, drift, temperature_bias, bias, ensemble, evaluations, time, output;

  static std::vector<RequestOption<AdviceRequest>> options();
  std::string prefix() const { return output ? output.text : "advice"; }
  /// Whether advice for hybrid Monte Carlo is requested. Hybrid Monte Carlo has no bias that could
  /// be bounded.
  bool is_canonical() const;
  /// @throws Error  also if request and run file contain no requirement, or several
  AdviserSettings settings(const Config& config) const;
  /// @param schemes_given  whether to use the candidates of the settings, which must then be a
  ///   single scheme
  HybridAdviserSettings hybrid_settings(const Config& config, bool schemes_given) const;
};

struct TuneRequest {
  Given scheme, step, runs, length, decorrelate, sample;

  static std::vector<RequestOption<TuneRequest>> options();
  TuneSettings settings(const Config& config) const;
};

struct BenchmarkRequest {
  Given sizes, precision;

  static std::vector<RequestOption<BenchmarkRequest>> options();
  /// @param threads  number of threads that is compared with a single thread
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

}  // namespace polhode
