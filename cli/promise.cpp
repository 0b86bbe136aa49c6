// SPDX-License-Identifier: MIT
#include "promise.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "advise_report.hpp"
#include "interrupt.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/table_file.hpp"
#include "progress.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

void keep(const std::string& file, const Promise& promise, const IntegratorSettings& integrator) {
  const nlohmann::json json{
      {"accuracy", promise.accuracy},         {"length_ps", promise.length},
      {"R_expected", promise.expected.value}, {"R_expected_error", promise.expected.error},
      {"scheme", integrator.scheme},          {"step_ps", integrator.step}};
  write_file(file, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

Promise kept_before(const std::string& file, IntegratorSettings& integrator) {
  try {
    const auto json = nlohmann::json::parse(std::ifstream(file));
    integrator.scheme = json.at("scheme");
    integrator.step = json.at("step_ps");
    return {json.at("accuracy"),
            json.at("length_ps"),
            {json.at("R_expected"), json.at("R_expected_error")}};
  } catch (const nlohmann::json::exception& e) {
    throw Error(
        fmt::format("'{}' does not hold the promise of the run that is to go on ({}); begin "
                    "it anew with --force",
                    file, e.what()));
  }
}

}  // namespace

std::optional<Promise> promised(Config& config, Beginning beginning, Workers& workers) {
  IntegratorSettings& integrator = config.integrator;
  if (!integrator.accuracy) return std::nullopt;
  const std::string file = config.output.prefix + "-promise.json";
  if (beginning.go_on && std::filesystem::exists(file)) return kept_before(file, integrator);
  refuse_existing(file, beginning.force);
  AdviserSettings settings{{Quality::ratio, *integrator.accuracy}, integrator.candidates};
  if (integrator.scheme_given) settings.schemes = {integrator.scheme};
  catch_interrupts();
  log("choosing a step for {}\n", described(settings.criterion));
  Advice advice;
  {
    Progress progress("choosing the step");
    advice = advised(
        config, settings,
        {[&](double done, const std::string& what) { progress.show(done, what); }, interrupted},
        workers);
  }
  if (advice.stopped) {
    log("interrupted while choosing the step; nothing was written\n");
    return std::nullopt;
  }
  if (!advice.best) throw RunError(unreachable(advice, settings.criterion));
  const AdviserPoint& point = advice.confirmation;
  integrator.scheme = advice.candidates[*advice.best].name;
  integrator.step = point.step;
  log("for {}: {}\n", described(settings.criterion), answer(advice));
  const Promise promise{*integrator.accuracy, point.length, point.ratio()};
  keep(file, promise, integrator);
  return promise;
}

Kept checked(const Promise& promise, const TrajectoryStatistics& statistics) {
  const SeriesEstimate whole = statistics.energies.ratio_with_error();
  const Estimate ratio = statistics.stretches.ratio().value_or(Estimate{whole.value, whole.error});
  return {promise, ratio};
}

void print_kept(const Kept& k) {
  const std::string what = fmt::format(
      "R = {:.3g} ± {:.2g} % over {:.3g} ps, at most {:.3g} % was promised", 100 * k.ratio.value,
      100 * k.ratio.error, k.promise.length, 100 * k.promise.accuracy);
  fmt::print("promise               {}: {}\n", k.kept() ? "kept" : "NOT KEPT", what);
  if (!k.kept())
    log("warning: the promise of [integrator] accuracy was not kept: {}; give a smaller "
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
