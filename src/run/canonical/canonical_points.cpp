// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "io/settings/output_units.hpp"
#include "io/settings/scheme_labels.hpp"
#include "math/prediction.hpp"
#include "polhode/base/error.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/canonical/canonical_study.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/study/study_tasks.hpp"

namespace polhode {
namespace {

/// Whether a quantity, given by its index, is a temperature. The exact value of a temperature is
/// known, so no reference measurement is needed.
constexpr bool is_temperature(std::size_t quantity) { return quantity >= 1 && quantity <= 4; }

/// The mean of a quantity over all methods of exact sampling, except for one method. For each
/// initial configuration, the mean over the steps is computed first. The mean over the
/// configurations is computed next, because runs from different configurations are independent.
std::optional<Estimate> exact_mean(const std::vector<CanonicalMethod>& methods,
                                   const std::vector<CanonicalRun>& runs,
                                   const CanonicalMethod& without, std::size_t quantity) {
  std::map<int, std::vector<double>> of_start;
  for (const CanonicalMethod& method : methods) {
    if (!method.hybrid || (method.text == without.text && method.step == without.step)) continue;
    for (const CanonicalRun& run : runs_of(method.text, method.step, runs))
      if (run.stable && std::isfinite(run.means[quantity]))
        of_start[run.start].push_back(run.means[quantity]);
  }
  std::vector<double> means;
  for (const auto& [start, values] : of_start) means.push_back(mean(values).value);
  return means.size() < 2 ? std::nullopt : std::optional(mean(means));
}

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

Estimate CanonicalPoint::evaluations_per_sample() const {
  const double factor = 2 * method.cost();
  return {factor * correlation_time.value, factor * correlation_time.error};
}

std::optional<Accuracy> CanonicalPoint::accuracy(std::size_t quantity,
                                                 BiasCriterion criterion) const {
  if (!bias[quantity]) return std::nullopt;
  return accuracy_of(*bias[quantity], canonical_quantities[quantity].bound(criterion), runs);
}

Accuracy CanonicalPoint::accuracy(BiasCriterion criterion) const {
  if (!stable) return Accuracy::above;
  bool any = false, all = true;
  for (std::size_t k = 0; k < bias.size(); ++k)
    if (const auto one = accuracy(k, criterion)) {
      if (*one == Accuracy::above) return Accuracy::above;
      any = true;
      all = all && *one == Accuracy::below;
    }
  return any && all ? Accuracy::below : Accuracy::undecided;
}

Accuracy accuracy_of(const Estimate& bias, double bound, int runs) {
  if (runs < 2) return Accuracy::undecided;
  const double doubt = t_quantile(0.975, runs - 1) * bias.error, size = std::abs(bias.value);
  if (size + doubt < bound) return Accuracy::below;
  return size - doubt > bound ? Accuracy::above : Accuracy::undecided;
}

const char* in_words(BiasCriterion criterion) {
  return criterion == BiasCriterion::strict ? "strict" : "loose";
}

const char* in_words(Accuracy accuracy) {
  constexpr const char* words[] = {"below the bound", "above the bound", "undecided"};
  return words[static_cast<std::size_t>(accuracy)];
}

std::vector<CanonicalPoint> canonical_points(const std::vector<CanonicalMethod>& methods,
                                             const std::vector<CanonicalRun>& runs,
                                             double temperature) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<CanonicalPoint> points;
  for (const CanonicalMethod& method : methods) {
    const std::vector<CanonicalRun> own = runs_of(method.text, method.step, runs);
    if (own.empty()) continue;
    CanonicalPoint point{.method = method};
    point.runs = static_cast<int>(own.size());
    point.stable = std::all_of(own.begin(), own.end(), [](const auto& run) { return run.stable; });
    const auto over_runs = [&](const auto& value) {
      return mean_of_runs(own, value).value_or(Estimate{unknown, unknown});
    };
    point.correlation_time = over_runs([](const auto& run) { return run.correlation_time; });
    point.acceptance = over_runs([](const auto& run) { return run.acceptance; });
    point.weight = over_runs([](const auto& run) { return run.weight; });
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k) {
      point.mean[k] = mean_of_runs(own, [k](const auto& run) { return run.means[k]; });
      const std::optional<Estimate> exact =
          is_temperature(k) ? Estimate{temperature, 0} : exact_mean(methods, runs, method, k);
      if (point.mean[k] && exact)
        point.bias[k] = Estimate{point.mean[k]->value - exact->value,
                                 std::hypot(point.mean[k]->error, exact->error)};
    }
    points.push_back(point);
  }
  return points;
}

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
