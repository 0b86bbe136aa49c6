// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "run/adviser/advice_report.hpp"

namespace polhode {
namespace {

std::string short_percent(const Estimate& x) {
  return fmt::format("{:.3g} ± {:.2g} %", 100 * x.value, 100 * x.error);
}

}  // namespace

std::string bound_text(Quality quality, double bound) {
  switch (quality) {
    case Quality::drift:
      return fmt::format("{:.3g} kJ/mol/ns", bound / unit("kJ/mol/ns", Dimension::power));
    case Quality::temperature_difference:
      return fmt::format("{:.3g} K", bound);
    case Quality::energy_bias:
      return fmt::format("{:.3g} kJ/mol", bound);
    case Quality::pressure_bias:
      return fmt::format("{:.3g} bar", bound / unit("bar", Dimension::pressure));
    case Quality::ratio:
    case Quality::temperature_bias:
      break;
  }
  return fmt::format("{:.3g} %", 100 * bound);
}

std::string description(const Criterion& criterion) {
  const std::string_view name = name_of(criterion.quality);
  const bool vowel = name[0] == 'e' || name[0] == 'R';
  return fmt::format("{} {} of at most {}", vowel ? "an" : "a", name,
                     bound_text(criterion.quality, criterion.bound));
}

std::string unreachable(const Advice& advice, const Criterion& criterion) {
  const Candidate* best = nullptr;
  const AdviserPoint* reached = nullptr;
  const auto consider = [&](const Candidate& candidate, const AdviserPoint& point) {
    if (!point.usable || (reached && reached->bound <= point.bound)) return;
    best = &candidate;
    reached = &point;
  };
  for (const Candidate& candidate : advice.candidates)
    for (const AdviserPoint& point : candidate.points) consider(candidate, point);
  for (const auto& [c, point] : advice.refused) consider(advice.candidates[c], point);
  std::string text =
      fmt::format("no scheme was found that meets {} for this system", description(criterion));
  if (!reached)
    return text +
           "; at every step tried, a run blew up or had an energy drift: equilibrate longer, or "
           "check the initial configuration";
  text += fmt::format("; the smallest bound reached is {}, with {} at {:.3g} fs",
                      bound_text(criterion.quality, reached->bound), best->name,
                      reached->step * units::fs_per_ps);
  if (reached->max_rounding() > 0.5 * reached->ratio().value)
    text += fmt::format(
        ". At this step the round-off limit of mixed precision is R = {:.2g} %; precision = "
        "\"double\" removes this limit",
        100 * reached->max_rounding());
  if (criterion.quality != Quality::ratio)
    text +=
        ". The bound includes the standard error of the mean; a longer search or longer runs "
        "reduce this error";
  return text;
}

std::string answer(const Advice& advice) {
  const AdviserPoint& p = advice.confirmation;
  return fmt::format("{} at {:.3g} fs, R = {} in {} independent runs of {:.3g} ps",
                     advice.candidates[*advice.best].name, p.step * units::fs_per_ps,
                     short_percent(p.ratio()), p.runs.size(), p.length);
}

}  // namespace polhode
