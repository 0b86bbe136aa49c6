// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string_view>

#include "base/version.hpp"
#include "io/files/embedded.hpp"
#include "io/files/with_error.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// Escapes the special characters of HTML in a text.
std::string html(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&'   ? "&amp;"
           : c == '<' ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

/// A curve of a small line figure as SVG, with which the page needs no other file.
struct SvgCurve {
  std::vector<double> x, y;
  std::vector<double> error{};  ///< half-width of the error band, if there is a band
};

struct SvgFigure {
  std::string title, x_label, y_label;
  std::vector<SvgCurve> curves;
  std::vector<double> marks{};  ///< x positions of vertical lines
  bool from_zero = true;        ///< whether the axis of x begins at zero
};

constexpr double width = 480, height = 260, left = 70, right = 20, top = 10, bottom = 40;

/// A range of numbers with a small margin.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double x) {
    if (!std::isfinite(x)) return;
    low = std::min(low, x), high = std::max(high, x);
  }
  bool empty() const { return !(low <= high); }
  void widen(double share) {
    const double by = high > low ? share * (high - low) : std::max(1e-3, 0.01 * std::abs(low));
    low -= by, high += by;
  }
};

/// The distance between ticks: 1, 2 or 5 times a power of ten.
double tick_of(const Span& span) {
  const double rough = (span.high - span.low) / 5,
               power = std::pow(10, std::floor(std::log10(rough)));
  for (const double nice : {1.0, 2.0, 5.0})
    if (nice * power >= rough) return nice * power;
  return 10 * power;
}

class Canvas {
 public:
  explicit Canvas(const SvgFigure& figure) : figure_(figure) {
    for (const SvgCurve& curve : figure.curves)
      for (std::size_t k = 0; k < curve.x.size(); ++k) {
        if (!std::isfinite(curve.y[k])) continue;
        const double error = curve.error.empty() ? 0 : curve.error[k];
        x_.include(curve.x[k]);
        y_.include(curve.y[k] - error);
        y_.include(curve.y[k] + error);
      }
    if (empty()) return;
    if (figure.from_zero) x_.include(0);
    x_.widen(figure.from_zero ? 0 : 0.03);
    y_.widen(0.05);
  }
  bool empty() const { return x_.empty() || y_.empty(); }

  std::string text() const {
    std::string out = axes();
    for (const SvgCurve& curve : figure_.curves) out += band(curve) + line(curve);
    for (const double mark : figure_.marks)
      out +=
          fmt::format("<line class=\"mark\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>",
                      px(mark), top, height - bottom);
    return out;
  }

 private:
  double px(double x) const {
    return left + (x - x_.low) / (x_.high - x_.low) * (width - left - right);
  }
  double py(double y) const {
    return height - bottom - (y - y_.low) / (y_.high - y_.low) * (height - top - bottom);
  }
  std::string axes() const {
    std::string out =
        fmt::format("<rect class=\"axis\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", left,
                    top, width - left - right, height - top - bottom);
    for (double step = tick_of(x_), x = std::ceil(x_.low / step) * step; x <= x_.high; x += step)
      out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>", px(x),
                         height - bottom + 16, std::abs(x) < step / 2 ? 0 : x);
    for (double step = tick_of(y_), y = std::ceil(y_.low / step) * step; y <= y_.high; y += step)
      out += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>", left - 6,
                         py(y) + 4, std::abs(y) < step / 2 ? 0 : y);
    return out +
           fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       (left + width - right) / 2, height - 6, html(figure_.x_label)) +
           fmt::format(
               "<text transform=\"translate(14 {}) rotate(-90)\" "
               "text-anchor=\"middle\">{}</text>",
               (top + height - bottom) / 2, html(figure_.y_label));
  }
  std::string points(const SvgCurve& curve, double share, bool backwards = false) const {
    std::string out;
    for (std::size_t n = 0; n < curve.x.size(); ++n) {
      const std::size_t k = backwards ? curve.x.size() - 1 - n : n;
      if (!std::isfinite(curve.y[k])) continue;
      const double error = curve.error.empty() ? 0 : curve.error[k];
      out += fmt::format("{:.1f},{:.1f} ", px(curve.x[k]), py(curve.y[k] + share * error));
    }
    return out;
  }
  std::string line(const SvgCurve& curve) const {
    return fmt::format("<polyline class=\"curve\" points=\"{}\"/>", points(curve, 0));
  }
  std::string band(const SvgCurve& curve) const {
    return curve.error.empty() ? ""
                               : fmt::format("<polygon class=\"band\" points=\"{}{}\"/>",
                                             points(curve, 1), points(curve, -1, true));
  }

  const SvgFigure& figure_;
  Span x_, y_;
};

/// The figure as an `svg` element with its caption, in a `figure` element. It is empty if no point
/// is finite.
std::string svg(const SvgFigure& figure) {
  const Canvas canvas(figure);
  if (canvas.empty()) return "";
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>"
      "<figcaption>{}</figcaption></figure>\n",
      width, height, html(figure.title), canvas.text(), html(figure.title));
}

std::string value_cell(const MeasuredProperty& m) {
  if (m.value.known != Known::yes) return "not known";
  return with_error(m.value.value, m.value.error) + " " + m.request.property->unit;
}

std::string interval_cell(const MeasuredProperty& m) {
  const auto interval = m.interval(0.95);
  return interval ? fmt::format("{:.5g} to {:.5g}", interval->front(), interval->back()) : "";
}

std::string reached_cell(const MeasuredProperty& m) {
  if (m.reached()) return "yes";
  if (m.value.known != Known::yes && m.request.relative)
    return fmt::format("no: {:.2g} % requested", 100 * m.request.error);
  return fmt::format("no: ± {:.2g} requested", m.requested_error());
}

std::string row_of(const MeasuredProperty& m) {
  std::string corrections;
  if (m.bias)
    corrections +=
        fmt::format("time-step bias {} subtracted. ", with_error(m.bias->value, m.bias->error));
  if (m.step_bound)
    corrections += fmt::format(
        "Time-step bias below {:.2g} with 95 % probability, from {} paired runs at half of the "
        "step, with a difference of {}{}. ",
        m.step_bound->bound, m.step_bound->pairs,
        with_error(m.step_bound->difference.value, m.step_bound->difference.error),
        m.step_bound->bound > m.requested_error() / 3
            ? "; this is not below a third of the error requested"
            : "");
  if (m.finite_size)
    corrections += fmt::format("Finite-size correction {:.3g} included. ", *m.finite_size);
  if (!m.remark.empty()) corrections += m.remark + ". ";
  if (!m.obstacle.empty()) corrections += "Not converged: " + m.obstacle + ". ";
  if (!m.contributions.empty()) corrections += "Value " + m.contributions + ".";
  return fmt::format(
      "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td>"
      "<td>{}</td></tr>\n",
      html(m.request.property->name), html(value_cell(m)), interval_cell(m), reached_cell(m),
      html(corrections));
}

std::string table_of(const MeasuredPoint& point) {
  std::string rows;
  for (const MeasuredProperty& m : point.properties) rows += row_of(m);
  return "<div class=\"wide\"><table><tr><th>property</th><th>value</th><th>95 % interval</th>"
         "<th>error reached</th><th>corrections</th></tr>\n" +
         rows + "</table></div>\n";
}

/// Adds a point with its error to a curve.
void add(SvgCurve& curve, double x, const SeriesEstimate& y) {
  curve.x.push_back(x);
  curve.y.push_back(y.value);
  curve.error.push_back(y.error);
}

SvgCurve curve_of(const std::vector<double>& x, const std::vector<SeriesEstimate>& y) {
  SvgCurve curve;
  for (std::size_t k = 0; k < x.size(); ++k) add(curve, x[k], y[k]);
  return curve;
}

/// A figure of the convergence of a value with the amount of data; empty if fewer than two parts of
/// the data have an error.
std::string convergence(const MeasuredProperty& m) {
  SvgCurve curve;
  for (std::size_t k = 0; k < m.stages.size(); ++k) {
    const double part = static_cast<double>(k + 1) / static_cast<double>(m.stages.size());
    if (m.stages[k].known == Known::yes) add(curve, 100 * part, m.stages[k]);
  }
  if (curve.x.size() < 2) return "";
  const std::string name = m.request.property->name, unit = m.request.property->unit;
  return svg({name + ", convergence", "part of the data (%)", unit.empty() ? name : unit, {curve}});
}

std::string correlation(const MeasuredCurve& measured) {
  return svg(
      {measured.title, measured.axis, measured.unit, {curve_of(measured.x, measured.value)}});
}

std::string distribution(const MeasuredDistribution& d) {
  std::string title = fmt::format("g(r) of {} and {}", d.pair[0], d.pair[1]);
  std::vector<double> marks;
  if (d.peak && d.peak->shell) {
    marks.push_back(d.peak->shell->end.value);
    title += "; the dashed line marks the first minimum";
  }
  return svg({title, "r (nm)", "g(r)", {curve_of(d.r, d.g)}, marks});
}

std::string equilibration(const EquilibrationTrace& trace, std::size_t replica) {
  return svg(
      {fmt::format("potential energy of replica {}; the line is where equilibrium begins", replica),
       "time (ps)",
       "kJ/mol",
       {{trace.time, trace.potential}},
       {trace.begin}});
}

std::string section(const std::string& title, const std::string& figures) {
  return figures.empty()
             ? ""
             : fmt::format("<h3>{}</h3>\n<div class=\"figures\">{}</div>\n", title, figures);
}

std::string section_of(const MeasuredPoint& point) {
  std::string text = fmt::format("<h2>{}</h2>\n", html(point.at.text())) + table_of(point);
  if (const std::string how = point.conditions(); !how.empty())
    text += fmt::format("<p>{}; box edge {:.4g} nm.</p>\n", how, point.edge);
  std::string converged, correlations, slab, structure, equilibrated, definitions;
  for (const MeasuredProperty& m : point.properties) converged += convergence(m);
  for (const MeasuredCurve& curve : point.curves) correlations += correlation(curve);
  for (const MeasuredCurve& curve : point.profiles) slab += correlation(curve);
  if (point.wants_distributions())
    for (const MeasuredDistribution& d : point.distributions) structure += distribution(d);
  for (std::size_t k = 0; k < point.traces.size(); ++k)
    equilibrated += equilibration(point.traces[k], k);
  for (const MeasuredProperty& m : point.properties)
    definitions += fmt::format("<li>{}: {}.</li>\n", html(m.request.property->name),
                               html(m.request.property->definition));
  return text + section("Convergence", converged) + section("Dynamics", correlations) +
         section("Slab", slab) + section("Structure", structure) +
         section("Equilibration", equilibrated) + "<h3>Definitions</h3>\n<ul>" + definitions +
         "</ul>\n";
}

std::string estimate_text(const SeriesEstimate& e) {
  return e.known == Known::yes ? with_error(e.value, e.error) : "not known";
}

/// The densities at one pressure, with a line at their maximum.
std::string density_figure(const MeasureReport& report, const DensityMaximum& m) {
  std::map<double, SeriesEstimate> densities;  // by temperature
  for (const MeasuredPoint& point : report.points)
    if (point.at.pressure == m.pressure && point.density.known == Known::yes)
      densities[point.at.temperature] = point.density;
  SvgCurve curve;
  for (const auto& [temperature, density] : densities) add(curve, temperature, density);
  std::vector<double> marks;
  const bool known = m.obstacle.empty();
  if (known) marks.push_back(m.temperature.value);
  return svg({known ? "density; the dashed line marks its maximum" : "density",
              "temperature (K)",
              "kg/m3",
              {curve},
              marks,
              false});
}

std::string of_curves(const MeasureReport& report) {
  const auto& [maxima, slopes] = report.curves;
  if (maxima.empty() && slopes.empty()) return "";
  std::string rows, figures, text = "<h2>Curves over state points</h2>\n";
  for (const DensityMaximum& m : maxima) {
    figures += density_figure(report, m);
    rows += fmt::format(
        "<tr><td class=\"number\">{:g}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{}</td><td>{}</td></tr>\n",
        in_bar(m.pressure), estimate_text(m.temperature), estimate_text(m.density),
        m.obstacle.empty() ? m.fit.text() : html(m.obstacle));
  }
  if (!maxima.empty())
    text +=
        "<h3>Temperature of maximum density</h3>\n<div class=\"wide\"><table><tr>"
        "<th>pressure (bar)</th><th>temperature (K)</th><th>density (kg/m3)</th>"
        "<th>polynomial</th></tr>\n" +
        rows + "</table></div>\n<div class=\"figures\">" + figures + "</div>\n";
  rows.clear();
  for (const SlopeValue& s : slopes)
    rows += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"number\">{} {}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{:.1f}</td><td>{}</td></tr>\n",
        s.property->name, html(s.at.text()), estimate_text(s.slope), html(s.property->unit),
        estimate_text(s.fluctuation), s.deviation, s.fit.text());
  if (!slopes.empty())
    text +=
        "<h3>Slopes</h3>\n<div class=\"wide\"><table><tr><th>property</th><th>state</th>"
        "<th>slope</th><th>from fluctuations</th><th>deviation (standard errors)</th>"
        "<th>polynomial</th></tr>\n" +
        rows + "</table></div>\n";
  return text;
}

void replace(std::string& text, const std::string& mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

std::string not_measured(const std::vector<MissingPoint>& points) {
  if (points.empty()) return "";
  std::string text = "<h2>Not measured</h2>\n<ul>\n";
  for (const MissingPoint& point : points)
    text += fmt::format("<li>{}: {}</li>\n", html(point.at.text()), html(point.reason));
  return text + "</ul>\n";
}

// Second virial coefficients need no simulation, and thus no scheme.
std::string source_of_scheme(const MeasureReport& report) {
  const bool simulated =
      std::any_of(report.points.begin(), report.points.end(),
                  [](const MeasuredPoint& point) { return !point.conditions().empty(); });
  return simulated ? "van Zon, Omelyan, Schofield, J. Chem. Phys. 128, 136102 (2008) for the "
                     "scheme, and "
                   : "";
}

constexpr std::string_view title = "Properties of ";

}  // namespace

void check_page(const std::string& path) {
  std::ifstream file(path);
  if (!file) return;
  std::string head(1000, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.find(fmt::format("<title>{}", title)) == head.npos)
    throw Error(
        fmt::format("'{}' exists and is not a page of measure, and would be overwritten; give "
                    "another output, or delete the file",
                    path));
}

std::string measure_page(const MeasureReport& report, const std::string& command) {
  std::string body = fmt::format("<h1>{}{}</h1>\n<p><code>{}</code></p>\n", title,
                                 html(report.system), html(command));
  body += of_curves(report);
  for (const MeasuredPoint& point : report.points) body += section_of(point);
  body += not_measured(report.missing);
  body += fmt::format(
      "<footer>polhode {}. Errors are standard errors; intervals are by Student's t. Cite {}the "
      "sources that the manual names for each property.</footer>",
      version(), source_of_scheme(report));
  std::string page(embedded_text("pages/measure.html").value());
  replace(page, "@title@", std::string(title) + html(report.system));
  replace(page, "@body@", body);
  return page;
}

}  // namespace polhode
