// SPDX-License-Identifier: MIT
#include "run/adviser/advice_curves.hpp"

#include <algorithm>

namespace polhode {

EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point) {
  const StudyPoint studied{candidate.name, {candidate.scheme}, point.step};
  std::vector<StudyRun> runs;
  for (const Outcome& run : point.runs)
    runs.push_back({.scheme = studied.record_name(),
                    .step = point.step,
                    .start = static_cast<int>(runs.size()),
                    .stable = run.failure.empty(),
                    .ratio = run.ratio,
                    .drift = run.drift,
                    .temperature = run.temperatures.all,
                    .rounding = run.rounding,
                    .parts = run.temperatures,
                    .configurational = run.configurational});
  return efficiency_points({studied}, runs, point.length).front();
}

std::vector<Curve> curves(const Advice& advice) {
  std::vector<Curve> all;
  for (std::size_t c = 0; c < advice.candidates.size(); ++c) {
    const Candidate& candidate = advice.candidates[c];
    std::vector<AdviserPoint> points = candidate.points;
    for (const auto* sets : {&advice.refused, &advice.surpassed})
      for (const auto& [of, point] : *sets)
        if (of == c) points.push_back(point);
    if (advice.best == c) points.push_back(advice.confirmation);
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.step < b.step; });
    Curve curve{candidate.name, {}, 0};
    bool usable = true;
    for (const AdviserPoint& point : points) {
      usable = usable && point.usable;
      if (usable) ++curve.usable;
      curve.points.push_back(efficiency_point(candidate, point));
    }
    all.push_back(curve);
  }
  return all;
}

}  // namespace polhode
