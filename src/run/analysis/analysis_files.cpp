// SPDX-License-Identifier: MIT
#include "analysis_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "polhode/base/units.hpp"

namespace polhode {
namespace {

constexpr double wavenumber = 1e12 / 29979245800.0;  // 1/ps in wavenumbers [1/cm]

/// The standard error; an empty field if it is not known.
double known_error(const SeriesEstimate& e) {
  return e.known == Known::yes ? e.error : std::nan("");
}

/// Adds a column of values, and a column of their errors.
void add(AnalysisFile& file, const std::string& name, const std::string& unit,
         const std::vector<SeriesEstimate>& values, bool drawn = true) {
  file.table.columns.push_back({name, unit});
  if (drawn) file.figure.columns.push_back({file.table.columns.size(), name});
  file.table.columns.push_back({name + " error", unit});
  for (std::size_t k = 0; k < file.table.rows.size(); ++k) {
    file.table.rows[k].emplace_back(values.at(k).value);
    file.table.rows[k].emplace_back(known_error(values.at(k)));
  }
}

/// A file whose first column is the lag, or the value of `at(k)`.
template <class At>
AnalysisFile file_over(const std::string& name, const std::string& column, const std::string& unit,
                       std::size_t rows, const At& at, CurvesFigure figure) {
  AnalysisFile file{name, {{{column, unit}}, {}}, std::move(figure)};
  for (std::size_t k = 0; k < rows; ++k) file.table.rows.push_back({at(k)});
  return file;
}

AnalysisFile file_of_lags(const std::string& name, std::size_t lags, double interval,
                          CurvesFigure figure) {
  return file_over(
      name, "lag", "ps", lags, [&](std::size_t k) { return static_cast<double>(k) * interval; },
      std::move(figure));
}

/// The name of a quantity of one part; if there is only one molecule, its name is omitted.
std::string of_part(const Analysis& a, std::size_t part, const std::string& what) {
  return a.topology.parts.size() == 1 ? what : a.topology.parts[part].molecule.name + " " + what;
}

AnalysisFile radial_file(const Analysis& a) {
  const RadialDistribution& radial = *a.radial;
  AnalysisFile file =
      file_over("rdf", "r", "nm", radial.bins(), [&](std::size_t k) { return radial.middle(k); },
                {{}, "radial distribution of sites", "r  (nm)", "g", {}, true});
  for (std::size_t p = 0; p < a.pairs.size(); ++p) {
    const std::string name = a.pairs[p][0] + "-" + a.pairs[p][1];
    add(file, "g " + name, "1", radial.g(p));
    file.table.columns.push_back({"coordination " + name, "1"});
    const std::vector<double> n = radial.coordination(p);
    for (std::size_t k = 0; k < n.size(); ++k) file.table.rows[k].emplace_back(n[k]);
  }
  return file;
}

AnalysisFile displacement_file(Analysis& a, Workers& workers) {
  AnalysisFile file;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part) {
    const std::vector<SeriesEstimate> squared =
        series_estimates(a.displacement->mean_square(part, workers));
    if (part == 0)
      file = file_of_lags(
          "msd", squared.size(), a.interval,
          {{}, "mean-square displacement of centres of mass", "lag  (ps)", "MSD  (nm²)", {}});
    add(file, of_part(a, part, "msd"), "nm2", squared);
  }
  return file;
}

AnalysisFile rotation_file(Analysis& a, Workers& workers) {
  AnalysisFile file;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part)
    for (std::size_t axis = 0; axis < a.reorientation->axes(part).size(); ++axis)
      for (const int rank : {1, 2}) {
        const std::vector<SeriesEstimate> P =
            series_estimates(a.reorientation->legendre(part, axis, rank, workers));
        if (file.name.empty())
          file = file_of_lags("rotation", P.size(), a.interval,
                              {{}, "reorientation of body axes", "lag  (ps)", "P₁, P₂", {}});
        add(file,
            of_part(a, part, fmt::format("P{} {}", rank, a.reorientation->axes(part)[axis].name)),
            "1", P);
      }
  return file;
}

struct NamedCorrelation {
  std::string name;
  BlockMeans curve;
  bool linear;
};

std::vector<NamedCorrelation> velocity_correlations(Analysis& a, Workers& workers) {
  std::vector<NamedCorrelation> curves;
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part) {
    curves.push_back({of_part(a, part, "v"), a.velocity->linear(part, workers), true});
    for (const std::size_t axis : a.velocity->turning_axes(part))
      curves.push_back({of_part(a, part, fmt::format("omega {}", axis + 1)),
                        a.velocity->angular(part, axis, workers), false});
  }
  return curves;
}

/// Autocorrelation functions divided by their value at lag 0, which has its own column.
std::vector<AnalysisFile> velocity_files(Analysis& a, Workers& workers) {
  const std::vector<NamedCorrelation> curves = velocity_correlations(a, workers);
  const std::size_t lags = curves.front().curve.mean().size();
  AnalysisFile time = file_of_lags(
      "velocity", lags, a.interval,
      {{}, "autocorrelation of velocities and angular velocities", "lag  (ps)", "C(t)/C(0)", {}});
  const Spectrum first = spectrum(curves.front().curve, a.interval);
  AnalysisFile spectra = file_over(
      "spectrum", "frequency", "THz", first.frequency.size(),
      [&](std::size_t k) { return first.frequency[k]; },
      {{}, "spectra of velocities and angular velocities", "frequency  (THz)", "I  (ps)", {}});
  spectra.table.columns.push_back({"wavenumber", "1/cm"});
  for (std::size_t k = 0; k < first.frequency.size(); ++k)
    spectra.table.rows[k].emplace_back(first.frequency[k] * wavenumber);
  for (const auto& [name, curve, linear] : curves) {
    add(time, name, "1", series_estimates(normalized(curve)));
    add(time, name + " product", linear ? "nm2/ps2" : "1/ps2", series_estimates(curve), false);
    if (linear)
      add(time, name + " integral", "nm2/ps", series_estimates(running_integral(curve, a.interval)),
          false);
    add(spectra, name, "ps", spectrum(curve, a.interval).intensity);
  }
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
  AnalysisFile file =
      file_over_time(a, "dielectric", d.frames,
                     {{}, "dielectric constant of the frames so far", {}, "ε", {{2, "epsilon"}}});
  file.table.columns.push_back({"epsilon", "1"});
  for (std::size_t k = 0; k < d.stages.size(); ++k) file.table.rows[k].emplace_back(d.stages[k]);
  return file;
}

AnalysisFile density_file(const Analysis& a) {
  const BlockMeans means = a.conditions->blocks();
  std::vector<double> frames;
  for (const auto& block : means.blocks())
    frames.push_back(block.weight + (frames.empty() ? 0 : frames.back()));
  AnalysisFile file =
      file_over_time(a, "density", frames,
                     {{}, "density in blocks of frames", {}, "density  (g/cm³)", {{2, "density"}}});
  file.table.columns.push_back({"density", "g/cm3"});
  file.table.columns.push_back({"temperature", "K"});
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto& [weight, sum] = means.blocks()[k];
    file.table.rows[k].emplace_back(sum[0] / weight / units::gram_per_cm3);
    file.table.rows[k].emplace_back(a.has_velocities ? sum[1] / weight : std::nan(""));
  }
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
  if (a.displacement) files.push_back(displacement_file(a, workers));
  if (a.reorientation) files.push_back(rotation_file(a, workers));
  if (a.velocity)
    for (AnalysisFile& file : velocity_files(a, workers)) files.push_back(std::move(file));
  if (s.dielectric) files.push_back(dielectric_file(a, s));
  if (a.density) files.push_back(density_file(a));
  std::erase_if(files, [](const AnalysisFile& file) { return file.table.rows.empty(); });
  return files;
}

}  // namespace polhode
