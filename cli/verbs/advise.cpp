// SPDX-License-Identifier: MIT
// polhode advise [FILE]: finds the cheapest scheme and step that meet an accuracy.

#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "polhode/base/error.hpp"
#include "run/adviser/advice_report.hpp"
#include "run/canonical/hybrid_adviser.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

using AdviseOptions = RequestOptions<AdviceRequest>;

/// Advises on hybrid Monte Carlo, whose averages have no time-step bias to bound.
int advise_canonical(const AdviseOptions& o, const Config& config, const Overlay& given) {
  const Override* length = given.find("run.length");
  const HybridAdviserSettings settings = o.request.hybrid_settings(
      config, given.find("integrator.candidates") != nullptr,
      length != nullptr ? Given{length->values.front(), length->place} : Given{});
  Workers workers = o.workers();
  const HybridAdvice advice = advise_hybrid(config, settings, console(), workers);
  if (advice.stopped) return interrupted(" before the search ended");
  print_results(quantities(advice), o);
  if (advice.finalists.empty()) throw RunError(answer(advice));
  return 0;
}

int advise(const AdviseOptions& o, const Overlay& given) {
  const Config config = o.config();
  if (o.request.is_canonical()) return advise_canonical(o, config, given);
  Workers workers = o.workers();
  const AdviserSettings settings = o.request.settings(config);
  const AdviceReport report =
      run_adviser(config, settings, o.request.prefix(), o.output(), console(), workers);
  if (report.advice.stopped) return interrupted(" before the search ended; no file was written");
  print_results(quantities(report), o);
  if (!report.advice.best) throw RunError(unreachable(report.advice, settings.criterion));
  return 0;
}

}  // namespace

Action advise_verb(Command& command) {
  auto o = std::make_shared<AdviseOptions>();
  o->declare(command, "simultaneous runs");
  o->declare_verbose(command);
  command.add_request(o->request);
  command.add_settings();
  o->declare_force(command);
  return [o, command] { return advise(*o, command.overlay()); };
}

}  // namespace polhode::cli
