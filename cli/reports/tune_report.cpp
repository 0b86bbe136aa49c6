// SPDX-License-Identifier: MIT
#include "tune_report.hpp"

#include <fmt/core.h>

#include <string>

#include "io/files/with_error.hpp"
#include "polhode/integrate/scheme_text.hpp"

namespace polhode::cli {
namespace {

void print(const Tuned& t) {
  const auto ratio = [](const Estimate& R) { return with_error(100 * R.value, 100 * R.error); };
  fmt::print("\nfamily of {}\n", t.reference);
  for (const TunedParameter& p : t.parameters)
    fmt::print("  {:<17} {}\n", p.name, with_error(p.value, p.error));
  fmt::print("  R                 {} %, {} for {}\n", ratio(t.ratio), ratio(t.reference_ratio),
             t.reference);
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
  if (result.short_steps) fmt::print("eta of short steps: {:.5f}\n", *result.short_steps);
  for (const Tuned& family : result.families) print(family);
}

}  // namespace polhode::cli
