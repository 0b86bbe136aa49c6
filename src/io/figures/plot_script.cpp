// SPDX-License-Identifier: MIT
#include "plot_script.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "figure_script.hpp"

namespace polhode {
namespace {

// The largest cost at which any curve exceeds a ratio; at higher costs all are close to the axis.
double last_cost_above(const std::vector<EfficiencyCurve>& curves, double ratio) {
  double last = 1;
  for (const EfficiencyCurve& curve : curves)
    for (const EfficiencyMark& mark : curve.marks)
      if (mark.stable && mark.ratio >= ratio) last = std::max(last, mark.cost);
  return last;
}

struct Ranges {
  double cost_low = std::numeric_limits<double>::infinity(), cost_high = 0;
  double ratio_low = std::numeric_limits<double>::infinity(), ratio_high = 0;
};

Ranges ranges_of(const std::vector<EfficiencyCurve>& curves) {
  Ranges r;
  for (const EfficiencyCurve& curve : curves)
    for (const EfficiencyMark& mark : curve.marks) {
      if (!mark.stable) continue;
      r.cost_low = std::min(r.cost_low, mark.cost), r.cost_high = std::max(r.cost_high, mark.cost);
      if (mark.ratio > 0) r.ratio_low = std::min(r.ratio_low, mark.ratio);
      r.ratio_high = std::max(r.ratio_high, mark.ratio);
    }
  if (r.cost_high == 0) r.cost_low = 1, r.cost_high = 1000;
  if (!(r.ratio_low < r.ratio_high)) r.ratio_low = r.ratio_high / 10;
  if (r.ratio_high == 0) r.ratio_low = 1e-3, r.ratio_high = 1;
  return r;
}

// Whether the points include a step that is too large for the scheme.
bool end_known(const EfficiencyCurve& curve) {
  return std::any_of(curve.marks.begin(), curve.marks.end(), [](auto& m) { return !m.stable; });
}

bool any_at_rounding(const EfficiencyCurve& curve) {
  return std::any_of(curve.marks.begin(), curve.marks.end(),
                     [](auto& m) { return m.stable && m.at_rounding; });
}

// Ranges of the axes: linear up to `highest`, as far as any curve differs from the axis; and
// logarithmic for all points.
void add_ranges(FigureScript& script, const std::vector<EfficiencyCurve>& curves,
                double max_ratio) {
  const Ranges r = ranges_of(curves);
  const double top = std::min(max_ratio, 1.08 * r.ratio_high);
  script.number("cost_low", 0.6 * r.cost_low);
  script.number("cost_high", 1.1 * last_cost_above(curves, 0.02 * top));
  script.number("ratio_high", 100 * top);
  script.number("all_cost_low", 0.8 * r.cost_low).number("all_cost_high", 1.25 * r.cost_high);
  script.number("all_ratio_low", 70 * r.ratio_low).number("all_ratio_high", 160 * r.ratio_high);
}

std::vector<std::vector<double>> rows_of(const EfficiencyCurve& curve) {
  std::vector<std::vector<double>> rows;
  bool last = end_known(curve);  // marks ascend in cost, so the first has the longest step
  for (const EfficiencyMark& mark : curve.marks) {
    if (!mark.stable) continue;
    rows.push_back({mark.cost, 100 * mark.ratio, 100 * mark.error, last ? 1.0 : 0.0,
                    mark.at_rounding ? 1.0 : 0.0});
    last = false;
  }
  return rows;
}

std::vector<std::string> names_of(const auto& curves) {
  std::vector<std::string> names;
  for (const auto& curve : curves) names.push_back(curve.scheme);
  return names;
}

std::vector<std::vector<double>> rows_of(const AdviceCurve& curve) {
  std::vector<std::vector<double>> rows;
  for (const AdviceMark& mark : curve.marks)
    rows.push_back({mark.seconds, 100 * mark.ratio, 100 * mark.error});
  return rows;
}

std::vector<std::vector<double>> model_of(const AdviceCurve& curve) {
  std::vector<std::vector<double>> rows;
  for (const auto& [seconds, ratio] : curve.model) rows.push_back({seconds, 100 * ratio});
  return rows;
}

/// The vertical range of a panel: all values if there is no bound, otherwise those up to a few
/// loose bounds, so that a large bias of one scheme does not hide what others have.
std::pair<double, double> range_of(const CanonicalFigure& figure, std::size_t panel) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const CanonicalFigure::Curve& curve : figure.curves)
    for (const CanonicalMark& mark : curve.marks) {
      const auto [value, error] = mark.values[panel];
      if (!std::isfinite(value)) continue;
      low = std::min(low, value - error), high = std::max(high, value + error);
    }
  const double bound = figure.panels[panel].loose;
  if (bound == 0)
    return low > 0 && low < high ? std::pair{0.7 * low, 1.4 * high} : std::pair{1., 1e4};
  constexpr double most = 2.5;  // bounds
  return {1.1 * std::clamp(low, -most * bound, -bound),
          1.1 * std::clamp(high, bound, most * bound)};
}

std::vector<std::vector<double>> rows_of(const CanonicalFigure::Curve& curve) {
  std::vector<std::vector<double>> rows;
  for (const CanonicalMark& mark : curve.marks) {
    rows.push_back({mark.cost});
    for (const auto& [value, error] : mark.values)
      rows.back().insert(rows.back().end(), {value, error});
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

std::string energy_script(const EnergyFigure& figure, const std::string& csv, const Image& image) {
  return FigureScript(image, 720, 480)
      .file("data", csv)
      .text("caption", figure.title)
      .text("energy", figure.energy)
      .text("ratio", figure.ratio)
      .with("energies");
}

std::string efficiency_script(const EfficiencyFigure& figure, const Image& image) {
  std::vector<EfficiencyCurve> curves = figure.curves;
  std::erase_if(curves, [](const EfficiencyCurve& curve) {
    return std::none_of(curve.marks.begin(), curve.marks.end(), [](auto& m) { return m.stable; });
  });
  for (EfficiencyCurve& curve : curves)
    std::sort(curve.marks.begin(), curve.marks.end(),
              [](const auto& a, const auto& b) { return a.cost < b.cost; });
  FigureScript script(image, 1000, 500);
  script.schemes(names_of(curves)).text("caption", figure.caption);
  script.count("some_end", std::any_of(curves.begin(), curves.end(), end_known));
  script.count("some_rounded", std::any_of(curves.begin(), curves.end(), any_at_rounding));
  add_ranges(script, curves, figure.max_ratio);
  script.block("points");
  for (const EfficiencyCurve& curve : curves) script.rows(curve.scheme, rows_of(curve));
  return script.end_block().with("efficiency");
}

std::string advice_script(const AdviceFigure& figure, const Image& image) {
  FigureScript script(image, 720, 480);
  script.schemes(names_of(figure.curves));
  script.count("some_bound", figure.bound.has_value());
  script.number("bound", 100 * figure.bound.value_or(0));
  script.count("some_answer", figure.confirmed.has_value());
  script.block("points");
  for (const AdviceCurve& curve : figure.curves) script.rows(curve.scheme, rows_of(curve));
  script.end_block().block("models");
  for (const AdviceCurve& curve : figure.curves) script.rows(curve.scheme, model_of(curve));
  AdviceCurve answer{"the answer", {}, {}};
  if (figure.confirmed) answer.marks.push_back(*figure.confirmed);
  return script.end_block()
      .block("answer")
      .rows(answer.scheme, rows_of(answer))
      .end_block()
      .with("advice");
}

std::string canonical_script(const CanonicalFigure& figure, const Image& image) {
  FigureScript script(image, 1200, 760);
  script.schemes(names_of(figure.curves)).text("caption", figure.caption);
  script.count("panels", figure.panels.size());
  std::vector<std::string> titles;
  double cost_low = std::numeric_limits<double>::infinity(), cost_high = 0;
  for (std::size_t j = 0; j < figure.panels.size(); ++j) {
    const std::string number = std::to_string(j + 1);
    const auto [low, high] = range_of(figure, j);
    titles.push_back(figure.panels[j].title);
    script.number("strict" + number, figure.panels[j].strict);
    script.number("loose" + number, figure.panels[j].loose);
    script.number("low" + number, low).number("high" + number, high);
  }
  script.texts("panel", titles).block("points");
  for (const CanonicalFigure::Curve& curve : figure.curves) {
    for (const CanonicalMark& mark : curve.marks)
      cost_low = std::min(cost_low, mark.cost), cost_high = std::max(cost_high, mark.cost);
    script.rows(curve.scheme, rows_of(curve));
  }
  script.end_block().number("cost_low", 0.8 * cost_low).number("cost_high", 1.25 * cost_high);
  return script.with("canonical");
}

std::string polhode_script(const PolhodeFigure& figure, const Image& image) {
  FigureScript script(image, 1000, 560);
  script.file("data", figure.data);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string number = std::to_string(k + 1);
    script.number("J" + number, figure.J[k]).number("L" + number, figure.L[k]);
  }
  return script.with("polhode");
}

}  // namespace polhode
