// SPDX-License-Identifier: MIT
// The gnuplot script for curves in one or more panels.
#include <algorithm>
#include <string>
#include <vector>

#include "base/printable.hpp"
#include "figure_script.hpp"

namespace polhode {
namespace {

// The Okabe-Ito palette, for lines that do not show a scheme.
const std::vector<std::string> palette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                          "#E69F00", "#56B4E9", "#000000"};

std::size_t readable_across(std::size_t panels) {
  return panels == 1 ? 1 : panels <= 4 ? 2 : panels <= 12 ? 3 : 4;
}

/// Sizes of a panel with its axes [pixels]; a figure is at least as wide as one panel.
struct Layout {
  std::size_t across, down, width, height;
};

constexpr std::size_t narrowest = 720;

Layout layout_of(const CurvesFigure& figure) {
  const std::size_t panels = std::max<std::size_t>(1, figure.panels.size());
  const std::size_t across = figure.across > 0 ? figure.across : readable_across(panels);
  const std::size_t width = std::max(narrowest / across, std::size_t{320});
  return {across, (panels + across - 1) / across, width,
          across == 1   ? 400u
          : across == 2 ? 330u
                        : 230u};
}

/// The legend entries of a panel: the curves and lines that have names.
std::vector<std::string> legend_of(const CurvesFigure::Panel& panel) {
  std::vector<std::string> names;
  for (const auto& curve : panel.curves) names.push_back(curve.name);
  for (const auto& line : panel.lines) names.push_back(line.name);
  std::erase(names, "");
  return names;
}

/// The number of legend entries that fit next to each other in a width [pixels], by gnuplot's
/// estimate of their widths.
std::size_t legend_columns(const std::vector<std::string>& names, std::size_t width) {
  std::size_t longest = 1;
  for (const std::string& name : names) longest = std::max(longest, character_count(name));
  return std::max<std::size_t>(1, width / (7 * longest + 47));
}

/// First and last indices of consecutive ranges, counted from 1 as in gnuplot. A range is empty if
/// `last` is less than `first`.
struct Ranges {
  std::vector<std::size_t> first, last;
  void add(std::size_t count) {
    first.push_back(last.empty() ? 1 : last.back() + 1);
    last.push_back(first.back() + count - 1);
  }
  void write(FigureScript& script, const std::string& of) const {
    script.counts("first_" + of, first).counts("last_" + of, last);
  }
};

void add_curves(FigureScript& script, const CurvesFigure& figure) {
  Ranges curves, bands;
  std::vector<std::string> names, colours;
  std::vector<std::size_t> columns, errors, banded;
  for (const CurvesFigure::Panel& panel : figure.panels) {
    const std::size_t before = banded.size();
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
      const CurvesFigure::Curve& curve = panel.curves[k];
      names.push_back(curve.name);
      colours.push_back(palette[k % palette.size()]);
      columns.push_back(curve.column);
      errors.push_back(curve.error);
      if (curve.error > 0) banded.push_back(columns.size());
    }
    curves.add(panel.curves.size());
    bands.add(banded.size() - before);
  }
  banded.push_back(1);  // gnuplot evaluates an element even in a loop without iterations
  curves.write(script, "curve");
  bands.write(script, "band");
  script.texts("name", names).texts("colour", colours);
  script.counts("column_of", columns).counts("error_of", errors).counts("banded", banded);
}

void add_lines(FigureScript& script, const CurvesFigure& figure) {
  Ranges lines;
  std::vector<std::string> names;
  std::vector<double> x, y;
  for (const CurvesFigure::Panel& panel : figure.panels) {
    for (const CurvesFigure::Line& line : panel.lines) {
      names.push_back(line.name);
      x.insert(x.end(), line.x.begin(), line.x.end());
      y.insert(y.end(), line.y.begin(), line.y.end());
    }
    lines.add(panel.lines.size());
  }
  // gnuplot evaluates an element even in a loop without iterations
  names.emplace_back();
  for (std::vector<double>* ends : {&x, &y}) ends->insert(ends->end(), {0, 0});
  script.texts("line_name", names).numbers("line_x", x).numbers("line_y", y);
  lines.write(script, "line");
}

}  // namespace

std::string script_of(const CurvesFigure& figure, const Image& image) {
  const Layout layout = layout_of(figure);
  std::vector<std::string> titles;
  std::vector<double> low, high;
  std::vector<std::size_t> columns;
  std::size_t rows = 0;
  for (const CurvesFigure::Panel& panel : figure.panels) {
    titles.push_back(panel.title);
    low.push_back(panel.low), high.push_back(panel.high);
    const std::vector<std::string> legend = legend_of(panel);
    columns.push_back(legend_columns(legend, layout.width - 64));
    rows = std::max(rows, (legend.size() + columns.back() - 1) / columns.back());
  }
  const bool titled = std::any_of(titles.begin(), titles.end(), [](auto& t) { return !t.empty(); });
  const std::size_t head = 8 + 18 * rows + (titled ? 22 : 0);  // height above a panel [pixels]
  constexpr std::size_t caption = 40, foot = 44;
  FigureScript script(image, layout.across * layout.width + 34,
                      caption + foot + layout.down * (layout.height + head));
  script.file("data", figure.csv).text("caption", figure.title);
  script.text("x_label", figure.x_label).text("y_label", figure.y_label);
  script.number("left", figure.left).number("right", figure.right);
  script.count("across", layout.across).count("panels", figure.panels.size());
  script.count("head", head).count("legend_rows", rows);
  script.texts("title_of", titles).counts("legend_columns", columns);
  script.numbers("low_of", low).numbers("high_of", high);
  add_curves(script, figure);
  add_lines(script, figure);
  return script.with("panels");
}

}  // namespace polhode
