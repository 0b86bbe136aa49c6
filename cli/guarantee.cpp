// SPDX-License-Identifier: MIT
#include "guarantee.hpp"

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

void keep(const std::string& file, const Guarantee& guarantee,
          const IntegratorSettings& integrator) {
  const nlohmann::json json{{"accuracy", guarantee.accuracy},
                            {"length_ps", guarantee.length},
                            {"R_expected", guarantee.expected.value},
                            {"R_expected_error", guarantee.expected.error},
                            {"scheme", integrator.scheme},
                            {"step_ps", integrator.step}};
  write_file(file, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

Guarantee read_guarantee(const std::string& file, IntegratorSettings& integrator) {
  try {
    const auto json = nlohmann::json::parse(std::ifstream(file));
    integrator.scheme = json.at("scheme");
    integrator.step = json.at("step_ps");
    return {json.at("accuracy"),
            json.at("length_ps"),
            {json.at("R_expected"), json.at("R_expected_error")}};
  } catch (const nlohmann::json::exception& e) {
    throw Error(
        fmt::format("'{}' does not contain the accuracy guarantee of the run to be resumed ({}); "
                    "start over with --force",
                    file, e.what()));
  }
}

}  // namespace

std::optional<Guarantee> choose_guaranteed_step(Config& config, StartMode start_mode,
                                                Workers& workers) {
  IntegratorSettings& integrator = config.integrator;
  if (!integrator.accuracy) return std::nullopt;
  const std::string file = config.output.prefix + "-guarantee.json";
  if (start_mode.resume && std::filesystem::exists(file)) return read_guarantee(file, integrator);
  refuse_existing(file, start_mode.force);
  AdviserSettings settings{{Quality::ratio, *integrator.accuracy}, integrator.candidates};
  if (integrator.scheme_given) settings.schemes = {integrator.scheme};
  catch_interrupts();
  log("choosing a step for {}\n", description(settings.criterion));
  Advice advice;
  {
    Progress progress("choosing the step");
    advice = advise(
        config, settings,
        {[&](double done, const std::string& what) { progress.show(done, what); }, interrupted},
        workers);
  }
  if (advice.stopped) {
    log("interrupted while choosing the step; no file was written\n");
    return std::nullopt;
  }
  if (!advice.best) throw RunError(unreachable(advice, settings.criterion));
  const AdviserPoint& point = advice.confirmation;
  integrator.scheme = advice.candidates[*advice.best].name;
  integrator.step = point.step;
  log("for {}: {}\n", description(settings.criterion), answer(advice));
  const Guarantee guarantee{*integrator.accuracy, point.length, point.ratio()};
  keep(file, guarantee, integrator);
  return guarantee;
}

GuaranteeCheck check_guarantee(const Guarantee& guarantee, const TrajectoryStatistics& statistics) {
  const SeriesEstimate whole = statistics.energies.ratio_with_error();
  const Estimate ratio = statistics.stretches.ratio().value_or(Estimate{whole.value, whole.error});
  return {guarantee, ratio};
}

void print_guarantee(const GuaranteeCheck& k) {
  const std::string what = fmt::format(
      "R = {:.3g} ± {:.2g} % over {:.3g} ps; the accuracy guarantee is {:.3g} %",
      100 * k.ratio.value, 100 * k.ratio.error, k.guarantee.length, 100 * k.guarantee.accuracy);
  fmt::print("accuracy guarantee    {}: {}\n", k.met() ? "met" : "NOT MET", what);
  if (!k.met())
    log("warning: the accuracy guarantee of [integrator] accuracy was not met: {}; give a smaller "
        "accuracy, or set the step yourself\n",
        what);
}

nlohmann::json as_json(const GuaranteeCheck& k) {
  return {{"accuracy", k.guarantee.accuracy},
          {"length_ps", k.guarantee.length},
          {"R_expected", k.guarantee.expected.value},
          {"R", k.ratio.value},
          {"R_error", k.ratio.error},
          {"met", k.met()}};
}

}  // namespace polhode::cli
