// SPDX-License-Identifier: MIT
#include "advise_report.hpp"

#include <fmt/core.h>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "run/adviser/advice_curves.hpp"
#include "temperature_tables.hpp"

namespace polhode::cli {
namespace {

constexpr const char* kinds[] = {"translation", "rotation_1", "rotation_2", "rotation_3"};

double in_kJ_per_ns(double power) { return power / unit("kJ/mol/ns", Dimension::power); }

std::string percent(const Estimate& x) { return with_error(100 * x.value, 100 * x.error) + " %"; }

void print_candidates(const Advice& advice, const Criterion& criterion) {
  fmt::print("{:<18} {:>8} {:>12} {:>10}   R % at the steps tried\n", "scheme", "step fs",
             "forces 1/ps", "ns/day");
  for (const Candidate& candidate : advice.candidates) {
    std::string tried;
    for (const AdviserPoint& p : candidate.points)
      tried += p.usable ? fmt::format(" {:.3g} fs: {:.3g}", p.step * units::fs_per_ps,
                                      100 * p.ratio().value)
                        : fmt::format(" {:.3g} fs: {}", p.step * units::fs_per_ps,
                                      blew_up(p.runs) ? "blew up" : "energy drifts");
    fmt::print(
        "{:<18} {:>8} {:>12} {:>10}  {}\n", candidate.name,
        candidate.step > 0 ? fmt::format("{:.3g}", candidate.step * units::fs_per_ps) : "-",
        candidate.step > 0 ? fmt::format("{:.0f}", candidate.scheme.cost() / candidate.step) : "-",
        candidate.seconds > 0 ? fmt::format("{:.3g}", candidate.ns_per_day()) : "-", tried);
  }
  for (const Candidate& candidate : advice.candidates)
    if (!candidate.obstacle.empty()) fmt::print("{}: {}\n", candidate.name, candidate.obstacle);
  for (const auto& [c, point] : advice.refused)
    fmt::print("not confirmed: {} at {:.3g} fs, {}\n", advice.candidates[c].name,
               point.step * units::fs_per_ps,
               blew_up(point.runs) ? "a run blew up"
                                   : fmt::format("R = {}, bound {}", percent(point.ratio()),
                                                 bound_text(criterion.quality, point.bound)));
  for (const auto& [c, point] : advice.surpassed)
    fmt::print("longer steps were tried: with {} at {:.3g} fs the bound is {}\n",
               advice.candidates[c].name, point.step * units::fs_per_ps,
               bound_text(criterion.quality, point.bound));
}

void print_best(const AdviceReport& r) {
  const Advice& advice = r.advice;
  const Criterion& criterion = r.criterion;
  const Candidate& best = advice.candidates[*advice.best];
  const AdviserPoint& p = advice.confirmation;
  fmt::print("\nfor {} use {} at {:.3g} fs\n", description(criterion), best.name,
             p.step * units::fs_per_ps);
  fmt::print("  R                   {}, mean of {} independent runs of {:.3g} ps\n",
             percent(p.ratio()), p.runs.size(), p.length);
  const std::string_view name = name_of(criterion.quality);
  fmt::print("  {}{}\n",
             criterion.quality == Quality::ratio
                 ? "a new run           has R below "
                 : fmt::format("{:<18}  is smaller than ", name.substr(0, name.find(" of "))),
             fmt::format("{} with a probability of {:g} %, {:.2g} of the requested bound",
                         bound_text(criterion.quality, p.bound), 100 * guarantee_probability,
                         p.bound / criterion.bound));
  fmt::print("  energy drift        {} kJ/mol/ns per molecule\n",
             with_error(in_kJ_per_ns(p.drift().value), in_kJ_per_ns(p.drift().error)));
  fmt::print("  temperature         {:.2f} K",
             mean(each(p.runs, [](const Outcome& run) { return run.temperatures.all; })).value);
  const char* before = "; off by";
  for (std::size_t k = 0; k < 4; ++k)
    if (p.bias(k).error > 0) {
      fmt::print("{} {} {}", before, kinds[k], percent(p.bias(k)));
      before = ",";
    }
  fmt::print("\n  speed               {:.3g} ns/day with {} {}\n", best.ns_per_day(), r.threads,
             r.threads == 1 ? "thread" : "threads");
}

}  // namespace

void print_advice(const AdviceReport& r) {
  const Advice& advice = r.advice;
  print_candidates(advice, r.criterion);
  if (!advice.best) return;
  print_best(r);
  if (advice.runner_up) {
    const Candidate& second = advice.candidates[*advice.runner_up];
    fmt::print("  runner-up           {} at {:.3g} fs, {:.3g} ns/day, not confirmed\n", second.name,
               second.step * units::fs_per_ps, second.ns_per_day());
  }
  std::vector<Curve> shown = {curves(advice)[*advice.best]};
  if (advice.runner_up) shown.push_back(curves(advice)[*advice.runner_up]);
  print_temperatures(shown, equipartition(shown));
}

}  // namespace polhode::cli
