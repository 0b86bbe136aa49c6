// SPDX-License-Identifier: MIT
// The density along a trajectory, in blocks of frames.
#include <cmath>

#include "curves.hpp"
#include "io/files/with_error.hpp"
#include "io/settings/quantity.hpp"

namespace polhode {
namespace {

/// The density of the frames. The analysis itself adds the frames, because the mean density is part
/// of every analysis.
class Density : public Observable {
 public:
  void add(const State&, const std::optional<StepError>&, Workers&) override {}
  ObservableResults results(const AllFrames& frames) override;
};

ObservableResults Density::results(const AllFrames& all) {
  const Analysis& a = all.analysis;
  const double kg_per_m3 = unit("kg/m3", Dimension::density);
  const BlockMeans means = a.conditions->blocks();
  std::vector<double> frames;
  std::vector<SeriesEstimate> densities;
  for (const auto& [weight, sum] : means.blocks()) {
    frames.push_back(weight + (frames.empty() ? 0 : frames.back()));
    densities.push_back({sum[0] / weight / kg_per_m3});
  }
  AnalysisFile file = file_over_time(a, "density", frames,
                                     {{}, "density in blocks of frames", {}, "density  (kg/m³)"});
  file.table.columns.push_back({"density", "kg/m3"});
  file.table.columns.push_back({"temperature", "K"});
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto& [weight, sum] = means.blocks()[k];
    file.table.rows[k].emplace_back(densities[k].value);
    file.table.rows[k].emplace_back(sum[3] > 0 ? sum[1] / sum[3] : std::nan(""));
  }
  const SeriesEstimate mean = a.conditions->density();
  const double value = mean.value / kg_per_m3;
  CurvesFigure::Panel panel;
  draw(panel, "blocks", {"", 2}, densities);
  panel.lines.push_back({"mean: " + with_error(value, known_error(mean) / kg_per_m3) + " kg/m³",
                         {0, file.figure.right},
                         {value, value}});
  file.figure.panels.push_back(std::move(panel));
  finish(file.figure, false);
  return {.files = {std::move(file)}};
}

}  // namespace

ObservableKind density() {
  return {"density",
          {"density"},
          false,
          [](const FirstFrames&) { return ""; },
          [](const FirstFrames&) { return std::make_unique<Density>(); }};
}

}  // namespace polhode
