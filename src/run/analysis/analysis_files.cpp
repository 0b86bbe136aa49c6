// SPDX-License-Identifier: MIT
#include "analysis_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"

namespace polhode {
namespace {

constexpr double wavenumber = 1e12 / 29979245800.0;  // 1/ps in wavenumbers [1/cm]

/// The standard error; an empty field if it is not known.
double known_error(const SeriesEstimate& e) {
  return e.known == Known::yes ? e.error : std::nan("");
}

/// Adds a column of values, and a column of their errors; returns the curve that they are, without
/// a name.
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

/// Draws a curve in a panel, which grows to hold it with its errors; nothing without a value.
/// @param name  in the legend; empty: not there
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

/// Leaves out panels without curves, and leaves room above and below the others.
/// @param from_zero  quantities are not negative, and axes begin at 0
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

/// A file whose first column is the lag, or the value of `at(k)`.
template <class At>
AnalysisFile file_over(const std::string& name, const std::string& column, const std::string& unit,
                       std::size_t rows, const At& at, CurvesFigure figure) {
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

std::string title_of_part(const Analysis& a, std::size_t part) {
  return a.topology.parts.size() == 1 ? "" : a.topology.parts[part].molecule.name;
}

/// The name of a quantity of one part; if there is only one molecule, its name is omitted.
std::string of_part(const Analysis& a, std::size_t part, const std::string& what) {
  return a.topology.parts.size() == 1 ? what : title_of_part(a, part) + " " + what;
}

AnalysisFile radial_file(const Analysis& a) {
  const RadialDistribution& radial = *a.radial;
  AnalysisFile file =
      file_over("rdf", "r", "nm", radial.bins(), [&](std::size_t k) { return radial.middle(k); },
                {{}, "radial distribution of sites", "r  (nm)", "g"});
  for (std::size_t p = 0; p < a.pairs.size(); ++p) {
    const std::string name = a.pairs[p][0] + "-" + a.pairs[p][1];
    const std::vector<SeriesEstimate> g = radial.g(p);
    CurvesFigure::Panel panel{name, {}};
    draw(panel, "", add(file.table, "g " + name, "1", g), g);
    file.figure.panels.push_back(std::move(panel));
    file.table.columns.push_back({"coordination " + name, "1"});
    const std::vector<double> n = radial.coordination(p);
    for (std::size_t k = 0; k < n.size(); ++k) file.table.rows[k].emplace_back(n[k]);
  }
  finish(file.figure, true);
  return file;
}

/// The line from which D follows, named after it.
CurvesFigure::Line diffusion_line(const BlockMeans& squared, double interval,
                                  const PartSummary& part, const FitWindow& fit) {
  const auto at = [&](double lag) { return fitted_displacement(squared, interval, fit, lag); };
  const std::string D = part.diffusion_convergence.converged()
                            ? "D = " +
                                  with_error(in_1e9_m2_per_s * part.diffusion->value,
                                             in_1e9_m2_per_s * known_error(*part.diffusion)) +
                                  " × 10⁻⁹ m²/s"
                            : "D not converged";
  return {"fit: " + D, {fit.from, fit.to}, {at(fit.from), at(fit.to)}};
}

AnalysisFile displacement_file(Analysis& a, const AnalysisSummary& s, Workers& workers) {
  AnalysisFile file;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part) {
    const BlockMeans means = a.displacement->mean_square(part, workers);
    const std::vector<SeriesEstimate> squared = series_estimates(means);
    if (part == 0)
      file = file_of_lags(
          "msd", squared.size(), a.interval,
          {{}, "mean-square displacement of centres of mass", "lag  (ps)", "MSD  (nm²)"});
    CurvesFigure::Panel panel{title_of_part(a, part), {}};
    draw(panel, "MSD", add(file.table, of_part(a, part, "msd"), "nm2", squared), squared);
    if (s.parts[part].diffusion)
      panel.lines.push_back(diffusion_line(means, a.interval, s.parts[part], s.fit));
    file.figure.panels.push_back(std::move(panel));
  }
  finish(file.figure, true);
  return file;
}

/// P₁ and P₂ of each kind of molecule, side by side.
AnalysisFile rotation_file(Analysis& a, Workers& workers) {
  AnalysisFile file;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part) {
    std::array<CurvesFigure::Panel, 2> panels{
        {{of_part(a, part, "P₁"), {}}, {of_part(a, part, "P₂"), {}}}};
    for (std::size_t axis = 0; axis < a.reorientation->axes(part).size(); ++axis)
      for (const int rank : {1, 2}) {
        const std::vector<SeriesEstimate> P =
            series_estimates(a.reorientation->legendre(part, axis, rank, workers));
        if (file.name.empty())
          file = file_of_lags("rotation", P.size(), a.interval,
                              {{}, "reorientation of body axes", "lag  (ps)", "P₁, P₂"});
        const std::string& name = a.reorientation->axes(part)[axis].name;
        draw(panels[static_cast<std::size_t>(rank - 1)], name,
             add(file.table, of_part(a, part, fmt::format("P{} {}", rank, name)), "1", P), P);
      }
    file.figure.panels.insert(file.figure.panels.end(), panels.begin(), panels.end());
  }
  file.figure.across = 2;
  finish(file.figure, false);
  return file;
}

struct NamedCorrelation {
  std::size_t part;
  std::string name;
  BlockMeans curve;
  bool linear;
};

std::vector<NamedCorrelation> velocity_correlations(Analysis& a, Workers& workers) {
  std::vector<NamedCorrelation> curves;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part) {
    curves.push_back({part, "v", a.velocity->linear(part, workers), true});
    for (const std::size_t axis : a.velocity->turning_axes(part))
      curves.push_back({part,
                        a.velocity->linear_body(part) ? "omega" : fmt::format("omega {}", axis + 1),
                        a.velocity->angular(part, axis, workers), false});
  }
  return curves;
}

/// Adds a curve of a part to a table, and to the part's panel.
void add_to_panel(AnalysisFile& file, const Analysis& a, const NamedCorrelation& one,
                  const std::string& unit, const std::vector<SeriesEstimate>& values) {
  draw(file.figure.panels[one.part],
       one.linear ? one.name : "ω" + one.name.substr(std::strlen("omega")),
       add(file.table, of_part(a, one.part, one.name), unit, values), values);
}

/// Autocorrelation functions divided by their value at lag 0, which has its own column.
std::vector<AnalysisFile> velocity_files(Analysis& a, Workers& workers) {
  const std::vector<NamedCorrelation> curves = velocity_correlations(a, workers);
  const std::size_t lags = curves.front().curve.mean().size();
  AnalysisFile time = file_of_lags(
      "velocity", lags, a.interval,
      {{}, "autocorrelation of velocities and angular velocities", "lag  (ps)", "C(t)/C(0)"});
  const Spectrum first = spectrum(curves.front().curve, a.interval);
  AnalysisFile spectra = file_over(
      "spectrum", "frequency", "THz", first.frequency.size(),
      [&](std::size_t k) { return first.frequency[k]; },
      {{}, "spectra of velocities and angular velocities", "frequency  (THz)", "I  (ps)"});
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part)
    for (AnalysisFile* file : {&time, &spectra})
      file->figure.panels.push_back({title_of_part(a, part), {}});
  spectra.table.columns.push_back({"wavenumber", "1/cm"});
  for (std::size_t k = 0; k < first.frequency.size(); ++k)
    spectra.table.rows[k].emplace_back(first.frequency[k] * wavenumber);
  for (const NamedCorrelation& one : curves) {
    const std::string name = of_part(a, one.part, one.name);
    add_to_panel(time, a, one, "1", series_estimates(normalized(one.curve)));
    add(time.table, name + " product", one.linear ? "nm2/ps2" : "1/ps2",
        series_estimates(one.curve));
    if (one.linear)
      add(time.table, name + " integral", "nm2/ps",
          series_estimates(running_integral(one.curve, a.interval)));
    add_to_panel(spectra, a, one, "ps", spectrum(one.curve, a.interval).intensity);
  }
  finish(time.figure, false);
  finish(spectra.figure, true);
  return {std::move(time), std::move(spectra)};
}

/// A file over the time analyzed so far, or over its frames if they have no times.
/// @param frames  number of frames so far, for each row
AnalysisFile file_over_time(const Analysis& a, const std::string& name,
                            const std::vector<double>& frames, CurvesFigure figure) {
  const double interval = a.mean_interval();
  figure.x_label = interval > 0 ? "time analyzed  (ps)" : "frames analyzed";
  return file_over(
      name, interval > 0 ? "time" : "frames", interval > 0 ? "ps" : "1", frames.size(),
      [&](std::size_t k) { return interval > 0 ? interval * frames[k] : frames[k]; },
      std::move(figure));
}

AnalysisFile dielectric_file(const Analysis& a, const AnalysisSummary& s) {
  const TotalDipole::Result& d = *s.dielectric;
  AnalysisFile file = file_over_time(a, "dielectric", d.frames,
                                     {{}, "dielectric constant of the frames so far", {}, "ε"});
  CurvesFigure::Panel panel;
  draw(panel, "", add(file.table, "epsilon", "1", d.stages), d.stages);
  file.figure.panels.push_back(std::move(panel));
  finish(file.figure, true);
  return file;
}

AnalysisFile density_file(const Analysis& a) {
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
    file.table.rows[k].emplace_back(a.has_velocities ? sum[1] / weight : std::nan(""));
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
  return file;
}

}  // namespace

std::vector<std::string> file_names(const std::set<Observable>& what) {
  std::vector<std::string> names;
  for (const Observable one : what) {
    names.push_back(observable_names()[static_cast<std::size_t>(one)]);
    if (one == Observable::velocity) names.push_back("spectrum");
  }
  return names;
}

std::vector<AnalysisFile> analysis_files(Analysis& a, const AnalysisSummary& s, Workers& workers) {
  std::vector<AnalysisFile> files;
  if (a.radial) files.push_back(radial_file(a));
  if (a.displacement) files.push_back(displacement_file(a, s, workers));
  if (a.reorientation) files.push_back(rotation_file(a, workers));
  if (a.velocity)
    for (AnalysisFile& file : velocity_files(a, workers)) files.push_back(std::move(file));
  if (s.dielectric) files.push_back(dielectric_file(a, s));
  if (a.density) files.push_back(density_file(a));
  std::erase_if(files, [](const AnalysisFile& file) { return file.table.rows.empty(); });
  return files;
}

}  // namespace polhode
