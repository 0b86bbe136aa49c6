// SPDX-License-Identifier: MIT
#include "promise.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "advise_report.hpp"
#include "interrupt.hpp"
#include "polhode/base/error.hpp"
#include "progress.hpp"

namespace polhode::cli {

std::optional<Promise> promised(Config& config, Workers& workers) {
  IntegratorSettings& integrator = config.integrator;
  if (!integrator.accuracy) return std::nullopt;
  AdviserSettings settings{{Quality::ratio, *integrator.accuracy}, config.study.schemes};
  if (integrator.scheme_given) settings.schemes = {integrator.scheme};
  catch_interrupts();
  Advice advice;
  {
    Progress progress("choosing the step");
    advice = advised(
        config, settings,
        {[&](double done, const std::string& what) { progress.show(done, what); }, interrupted},
        workers);
  }
  if (advice.stopped) {
    fmt::print(stderr, "interrupted while choosing the step; nothing was written\n");
    return std::nullopt;
  }
  if (!advice.best) throw RunError(unreachable(advice, settings.criterion));
  const AdviserPoint& point = advice.confirmation;
  integrator.scheme = advice.candidates[*advice.best].name;
  integrator.step = point.step;
  fmt::print(stderr, "for {}: {}\n", described(settings.criterion), answer(advice));
  return Promise{*integrator.accuracy, point.length, point.ratio()};
}

Kept checked(const Promise& promise, std::span<const Energies> samples) {
  return {promise, ratio_over(promise.length, samples)};
}

void print_kept(const Kept& k) {
  const std::string what = fmt::format(
      "R = {:.3g} ± {:.2g} % over {:.3g} ps, at most {:.3g} % was promised", 100 * k.ratio.value,
      100 * k.ratio.error, k.promise.length, 100 * k.promise.accuracy);
  fmt::print("promise               {}: {}\n", k.kept() ? "kept" : "NOT KEPT", what);
  if (!k.kept())
    fmt::print(stderr,
               "warning: the promise of [integrator] accuracy was not kept: {}; give a smaller "
               "accuracy, or a step of your own\n",
               what);
}

nlohmann::json as_json(const Kept& k) {
  return {{"accuracy", k.promise.accuracy},
          {"length_ps", k.promise.length},
          {"R_expected", k.promise.expected.value},
          {"R", k.ratio.value},
          {"R_error", k.ratio.error},
          {"kept", k.kept()}};
}

}  // namespace polhode::cli
