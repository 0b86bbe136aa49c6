// SPDX-License-Identifier: MIT

#include "figure_script.hpp"

namespace polhode {

std::string script_of(const EnergyFigure& figure, const Image& image) {
  return FigureScript(image, 720, 480)
      .file("data", figure.csv)
      .text("caption", figure.title)
      .text("energy", figure.energy)
      .text("ratio", figure.ratio)
      .with("energies");
}

std::string script_of(const EfficiencyFigure& figure, const Image& image) {
  return FigureScript(image, 1000, 500)
      .file("data", figure.csv)
      .schemes(figure.schemes)
      .text("caption", figure.caption)
      .number("highest", 100 * figure.max_ratio)
      .with("efficiency");
}

std::string script_of(const AdviceFigure& figure, const Image& image) {
  FigureScript script(image, 720, 480);
  std::vector<SchemeRows> rows;
  std::vector<double> steps, seconds, ratios, exponents, short_exponents;
  for (const AdviceFigure::Curve& curve : figure.curves) {
    rows.push_back(curve.rows);
    steps.push_back(curve.step), seconds.push_back(curve.seconds);
    ratios.push_back(100 * curve.ratio), exponents.push_back(curve.exponent);
    short_exponents.push_back(curve.short_exponent);
  }
  script.file("data", figure.csv).schemes(rows);
  script.numbers("step_of", steps).numbers("seconds_of", seconds).numbers("R_of", ratios);
  script.numbers("exponent_of", exponents).numbers("short_exponent_of", short_exponents);
  script.number("bound", 100 * figure.bound.value_or(0));
  script.count("answers", figure.confirmed ? 1 : 0);
  const auto answer = figure.confirmed.value_or(AdviceFigure::Answer{0, 0});
  return script.count("best", answer.curve + 1).count("answer", answer.row).with("advice");
}

std::string script_of(const CanonicalFigure& figure, const Image& image) {
  std::vector<std::string> titles, columns, errors;
  std::vector<double> strict, loose;
  for (const CanonicalFigure::Panel& panel : figure.panels) {
    titles.push_back(panel.title), columns.push_back(panel.column), errors.push_back(panel.error);
    strict.push_back(panel.strict), loose.push_back(panel.loose);
  }
  return FigureScript(image, 1200, 760)
      .file("data", figure.csv)
      .schemes(figure.schemes)
      .text("caption", figure.caption)
      .count("panels", figure.panels.size())
      .texts("title_of", titles)
      .texts("column_of", columns)
      .texts("error_of", errors)
      .numbers("strict_of", strict)
      .numbers("loose_of", loose)
      .with("canonical");
}

std::string script_of(const PolhodeFigure& figure, const Image& image) {
  FigureScript script(image, 1000, 560);
  script.file("data", figure.data);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string number = std::to_string(k + 1);
    script.number("J" + number, figure.J[k]).number("L" + number, figure.L[k]);
  }
  return script.with("polhode");
}

}  // namespace polhode
