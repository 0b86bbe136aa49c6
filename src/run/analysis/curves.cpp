// SPDX-License-Identifier: MIT
#include "curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polhode {

double known_error(const SeriesEstimate& e) {
  return e.known == Known::yes ? e.error : std::nan("");
}

std::string short_text(const SeriesEstimate& e) {
  return text_of(e) + (e.known == Known::yes ? "" : " ± ?");
}

std::string bias_text(const SeriesEstimate& bias, double value) {
  return fmt::format("{}, without it {:.5g}", short_text(bias), value - bias.value);
}

CurvesFigure::Curve add(Table& table, const std::string& name, const std::string& unit,
                        const std::vector<SeriesEstimate>& values) {
  table.columns.push_back({name, unit});
  const std::size_t column = table.columns.size();
  table.columns.push_back({name + " error", unit});
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    table.rows[k].emplace_back(values.at(k).value);
    table.rows[k].emplace_back(known_error(values.at(k)));
  }
  return {"", column, column + 1};
}

void draw(CurvesFigure::Panel& panel, const std::string& name, CurvesFigure::Curve curve,
          const std::vector<SeriesEstimate>& values) {
  curve.name = name;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool errors = false;
  for (const SeriesEstimate& e : values) {
    if (!std::isfinite(e.value)) continue;
    const double error = e.known == Known::yes ? e.error : 0;
    low = std::min(low, e.value - error), high = std::max(high, e.value + error);
    errors = errors || e.known == Known::yes;
  }
  if (!(low <= high)) return;
  if (!errors) curve.error = 0;
  panel.low = panel.curves.empty() ? low : std::min(panel.low, low);
  panel.high = panel.curves.empty() ? high : std::max(panel.high, high);
  panel.curves.push_back(std::move(curve));
}

void finish(CurvesFigure& figure, bool from_zero) {
  std::erase_if(figure.panels, [](const auto& panel) { return panel.curves.empty(); });
  for (CurvesFigure::Panel& panel : figure.panels) {
    if (from_zero) panel.low = 0;
    const double range = panel.high - panel.low;
    const double size = std::abs(panel.high);
    const double room = size == 0 ? 1 : 0.05 * (range > 1e-6 * size ? range : size);
    if (!from_zero) panel.low -= room;
    panel.high += room;
  }
}

AnalysisFile file_over(const std::string& name, const std::string& column, const std::string& unit,
                       std::size_t rows, const std::function<double(std::size_t)>& at,
                       CurvesFigure figure) {
  AnalysisFile file{name, {{{column, unit}}, {}}, std::move(figure)};
  for (std::size_t k = 0; k < rows; ++k) file.table.rows.push_back({at(k)});
  if (rows > 1) file.figure.right = at(rows - 1);
  return file;
}

AnalysisFile file_of_lags(const std::string& name, std::size_t lags, double interval,
                          CurvesFigure figure) {
  return file_over(
      name, "lag", "ps", lags, [&](std::size_t k) { return static_cast<double>(k) * interval; },
      std::move(figure));
}

AnalysisFile file_over_time(const Analysis& a, const std::string& name,
                            const std::vector<double>& frames, CurvesFigure figure) {
  const double interval = a.mean_interval();
  figure.x_label = interval > 0 ? "time analyzed  (ps)" : "frames analyzed";
  return file_over(
      name, interval > 0 ? "time" : "frames", interval > 0 ? "ps" : "1", frames.size(),
      [&](std::size_t k) { return interval > 0 ? interval * frames[k] : frames[k]; },
      std::move(figure));
}

std::string title_of_part(const Analysis& a, std::size_t part) {
  return a.topology.parts.size() == 1 ? "" : a.topology.parts[part].molecule.name;
}

std::string of_part(const Analysis& a, std::size_t part, const std::string& what) {
  return a.topology.parts.size() == 1 ? what : title_of_part(a, part) + " " + what;
}

}  // namespace polhode
