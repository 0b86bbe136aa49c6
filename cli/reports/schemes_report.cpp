// SPDX-License-Identifier: MIT
#include "schemes_report.hpp"

#include <fmt/core.h>

#include <cmath>

#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"

namespace polhode::cli {
namespace {

/// The flows in order: A for a drift, B for a kick, G for a gradient kick, O for a bath.
std::string flows(const Scheme& scheme) {
  std::string letters;
  for (const Stage& s : scheme.stages()) letters += s.xi == 0 ? letter_of(s.flow) : 'G';
  return letters;
}

std::string line_of(const Stage& s) {
  if (s.xi == 0)
    return fmt::format("{}({:<20})  {}", letter_of(s.flow), s.fraction, name_of(s.flow));
  return fmt::format("B({:<20}, xi = {})  gradient kick, {}", s.fraction, s.xi,
                     s.has(Gradient::exact) ? "exact" : "finite difference");
}

}  // namespace

void print_scheme(const Scheme& scheme) {
  fmt::print(
      "{}\n  order              {}\n  force evaluations  {} per step\n  gradient kicks     {} per "
      "step\n  cost               {:g} force evaluations per step\n  source             {}\n",
      scheme.name(), scheme.order() ? fmt::format("{}", scheme.order()) : "unknown",
      scheme.force_evaluations(), scheme.gradient_kicks(), scheme.cost(),
      scheme.source().empty() ? "-" : scheme.source());
  if (scheme.palindromic()) {
    const ErrorTerms error = error_terms(scheme);
    constexpr double rounding = 1e-14;  // of coefficients with 15 digits
    fmt::print("  error of order h²  {}{}\n",
               std::hypot(error.alpha, error.beta) < rounding
                   ? "none"
                   : fmt::format("alpha {:.6g}, beta {:.6g}", error.alpha, error.beta),
               scheme.has(Flow::bath) ? ", of drifts and kicks alone" : "");
  } else {
    fmt::print(
        "  palindrome         no: not time-reversible, with an error of order h in general\n");
  }
  fmt::print("  stages\n");
  for (const Stage& s : scheme.stages()) fmt::print("    {}\n", line_of(s));
  fmt::print("  as text\n    \"{}\"\n", text_of(scheme));
}

void print_schemes() {
  fmt::print("{:<16} {:>5}  {:>17}  {:>14}  {:>5}  {:<13}  {}\n", "name", "order",
             "force evaluations", "gradient kicks", "cost", "source", "flows");
  for (const Scheme& s : schemes)
    fmt::print("{:<16} {:>5}  {:>17}  {:>14}  {:>5}  {:<13}  {}\n", s.name(), s.order(),
               s.force_evaluations(), s.gradient_kicks(), s.cost(), s.source(), flows(s));
}

}  // namespace polhode::cli
