// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string_view>

#include "base/version.hpp"
#include "io/files/embedded.hpp"
#include "io/files/with_error.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"
#include "run/properties/svg_figure.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

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

std::string of_missing(const std::vector<MissingPoint>& points) {
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
  body += of_missing(report.missing);
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
