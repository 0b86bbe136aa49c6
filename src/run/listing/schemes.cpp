// SPDX-License-Identifier: MIT
#include "run/listing/lists.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "integrate/postprocessor.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// The flows of a scheme in order, as letters: A for a drift, B for a kick, G for a gradient kick,
/// O for a bath.
std::string flows(const Scheme& scheme) {
  std::string letters;
  for (const Stage& s : scheme.stages()) letters += s.xi == 0 ? letter_of(s.flow) : 'G';
  return letters;
}

Quantities of_stage(const Stage& s) {
  const bool fd = s.has(Gradient::finite_difference);
  const std::string gradient = s.xi == 0 ? "" : fd ? "finite difference" : "exact";
  return {
      {"flow", "", std::string(name_of(s.flow)), "`drift`, `kick` or `bath`", "flow"},
      {"fraction", "", s.fraction, "fraction of the time step", "fraction of the step", "", "", 16},
      {"xi", "", s.xi, "prefactor of the gradient correction", "xi", "", "", 16},
      {"gradient", "", gradient, "`exact`, `finite difference` or empty", "gradient"}};
}

/// The error terms of a scheme as text: "alpha 0.01, beta -0.02", "none", or a note that the scheme
/// is not a palindrome.
std::string error_text(const Scheme& scheme) {
  if (!scheme.palindromic()) return "in general of order h (the scheme is not time-reversible)";
  const ErrorTerms error = error_terms(scheme);
  constexpr double rounding = 1e-14;  // round-off of coefficients with 15 digits
  return (std::hypot(error.alpha, error.beta) < rounding
              ? "none"
              : fmt::format("alpha {:.6g}, beta {:.6g}", error.alpha, error.beta)) +
         (scheme.has(Flow::bath) ? ", for the scheme without its bath" : "");
}

std::string postprocessor_text(const Scheme& scheme) {
  const Postprocessor* const known = postprocessor_of(scheme);
  return known ? text_of(known->stages) : "";
}

/// A scheme as a list.
/// @param alone  whether the scheme is listed separately, rather than as a row of a table
Quantities of_scheme(const Scheme& scheme, bool alone) {
  const auto label = [&](const char* text) { return alone ? text : ""; };
  std::vector<Quantities> stages;
  for (const Stage& s : scheme.stages()) stages.push_back(of_stage(s));
  return {
      {"name", "", std::string(scheme.name()), "name of the scheme", "name"},
      {"order", "", scheme.order(), "order of the scheme; 0 if unknown"},
      row("order", scheme.order() ? std::to_string(scheme.order()) : "unknown"),
      {"force_evaluations", "", scheme.force_evaluations(), "force evaluations per step",
       "force evaluations"},
      {"gradient_kicks", "", scheme.gradient_kicks(), "gradient kicks per step", "gradient kicks"},
      {"derivatives", "", scheme.derivatives(), "derivatives of the forces per step"},
      {"cost", "", scheme.cost(), "sum of force evaluations and derivatives per step", "cost"},
      {"palindrome", "", scheme.palindromic(), "whether the scheme is time-reversible",
       label("palindrome")},
      {"postprocessor", "", postprocessor_text(scheme),
       "stages of the postprocessor that `output.processed` applies; empty if none is known",
       label("postprocessor")},
      {"source", "", std::string(scheme.source()), "key of the bibliography", "source"},
      alone ? row("error of order h²", error_text(scheme)) : row("flows", flows(scheme)),
      {"stages", "", stages, "stages of the scheme, in order", label("stages")},
      {"text", "", text_of(scheme), "stages of the scheme as text", label("as text")}};
}

}  // namespace

Quantities quantities(const Scheme& scheme) { return of_scheme(scheme, true); }

std::vector<Quantities> all_schemes() {
  std::vector<Quantities> all;
  for (const Scheme& scheme : schemes) all.push_back(of_scheme(scheme, false));
  return all;
}

}  // namespace polhode
