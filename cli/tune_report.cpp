// SPDX-License-Identifier: MIT
#include "tune_report.hpp"

#include <fmt/core.h>

#include <string>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/with_error.hpp"

namespace polhode::cli {
namespace {

void print(const Tuned& t) {
  const auto ratio = [](const Estimate& R) { return with_error(100 * R.value, 100 * R.error); };
  fmt::print("\nfamily of {}\n", t.reference.name());
  fmt::print("  eta               {}\n", with_error(t.member.eta, t.error.eta));
  if (t.member.xi != 0) fmt::print("  xi                {}\n", with_error(t.member.xi, t.error.xi));
  fmt::print("  R                 {} %, {} for {}\n", ratio(t.ratio), ratio(t.reference_ratio),
             t.reference.name());
  fmt::print("  gain              {} measured, {:.3f} predicted\n",
             with_error(t.gain.value, t.gain.error), t.predicted_gain);
  fmt::print("  as text           \"{}\"\n", text_of(t.scheme));
}

}  // namespace

void print_tuning(const TuneResult& result) {
  const ErrorCovariance& c = result.covariance;
  fmt::print("error brackets, times h²: rms {:.4g} and {:.4g} kJ/mol, correlation {:.3f}\n",
             rms_bracket(c.aa, result.settings), rms_bracket(c.bb, result.settings),
             correlation(c));
  fmt::print("eta of short steps: {:.5f}\n", result.short_steps);
  print(result.plain);
  print(result.gradient);
}

}  // namespace polhode::cli
