// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include "io/settings/output_units.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/canonical/canonical_study.hpp"
#include "run/study/study_tasks.hpp"

namespace polhode {
namespace {

// Default steps [fs] for water: one list for schemes with one force evaluation per step, and one
// for schemes with two or three. Schemes with more evaluations use longer steps at equal cost.
std::vector<double> default_steps(const CanonicalMethod& method, bool coarse) {
  std::vector<double> fs;
  if (method.scheme.cost() <= 1)
    fs = coarse ? std::vector<double>{2, 5} : std::vector<double>{2, 4, 6};
  else
    fs = coarse ? std::vector<double>{4, 7} : std::vector<double>{4, 6, 8};
  const double stretch = std::max(1.0, method.scheme.cost() / 4);
  for (double& h : fs) h *= stretch / units::fs_per_ps;
  return fs;
}

CanonicalMethod method_of(const NamedScheme& given) {
  const Scheme scheme = single_scheme_of(given);
  const bool hybrid = !scheme.has(Flow::bath);
  const std::string prefix = hybrid ? "hmc-" : "";
  if (hybrid) check_hybrid(scheme);
  return {.name = prefix + label_of(given),
          .text = prefix + named_text_of(NestedScheme(scheme)),
          .scheme = scheme,
          .hybrid = hybrid};
}

/// Whether the schemes are the default schemes of a study of energy conservation, given explicitly
/// or by the default run file.
bool of_energy_study(const std::vector<NamedScheme>& schemes) {
  return schemes == StudySettings{}.schemes ||
         schemes == std::vector<NamedScheme>{"velocity-verlet", "hoa2", "gier4-fd"};
}

}  // namespace

std::vector<NamedScheme> canonical_schemes() {
  return {"obabo",      "baoab",        "aboba",         "hoa2-ends",       "hoa2-middle",
          "bcss3-ends", "bcss3-middle", "gier4-fd-ends", "gier4-fd-middle", "hoa2"};
}

std::vector<CanonicalMethod> canonical_methods(const StudySettings& settings) {
  std::vector<CanonicalMethod> methods;
  for (const NamedScheme& scheme :
       of_energy_study(settings.schemes) ? canonical_schemes() : settings.schemes) {
    CanonicalMethod method = method_of(scheme);
    for (const double h :
         settings.steps.empty() ? default_steps(method, settings.coarse) : settings.steps) {
      method.step = h;
      if (std::any_of(methods.begin(), methods.end(), [&](const CanonicalMethod& other) {
            return other.name == method.name && same_step(other.step, h);
          }))
        throw Error(
            fmt::format("the study contains {} with a step of {:g} fs twice; give each scheme and "
                        "each step once",
                        method.name, units::fs_per_ps * h));
      methods.push_back(method);
    }
  }
  return methods;
}

}  // namespace polhode
