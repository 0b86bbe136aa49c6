// SPDX-License-Identifier: MIT
#include "analyze_report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "polhode/base/units.hpp"

namespace polhode::cli {
namespace {

constexpr double wavenumber = 1e12 / 29979245800.0;  // 1/ps in wavenumbers [1/cm]

/// The standard error; NaN if it is not known, which is an empty field, or null in JSON.
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
                {{}, "radial distribution of sites", "r  (nm)", "g", {}});
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
  AnalysisFile waves = file_over(
      "spectrum", "frequency", "THz", first.frequency.size(),
      [&](std::size_t k) { return first.frequency[k]; },
      {{}, "spectra of velocities and angular velocities", "frequency  (THz)", "I  (ps)", {}});
  waves.table.columns.push_back({"wavenumber", "1/cm"});
  for (std::size_t k = 0; k < first.frequency.size(); ++k)
    waves.table.rows[k].emplace_back(first.frequency[k] * wavenumber);
  for (const auto& [name, curve, linear] : curves) {
    add(time, name, "1", series_estimates(normalized(curve)));
    add(time, name + " product", linear ? "nm2/ps2" : "1/ps2", series_estimates(curve), false);
    if (linear)
      add(time, name + " integral", "nm2/ps", series_estimates(running_integral(curve, a.interval)),
          false);
    add(waves, name, "ps", spectrum(curve, a.interval).intensity);
  }
  return {std::move(time), std::move(waves)};
}

AnalysisFile dielectric_file(const AnalysisSummary& s) {
  const TotalDipole::Result& d = *s.dielectric;
  AnalysisFile file = file_over(
      "dielectric", "frames", "1", d.frames.size(), [&](std::size_t k) { return d.frames[k]; },
      {{}, "dielectric constant of the frames so far", "frames", "ε", {{2, "epsilon"}}});
  file.table.columns.push_back({"epsilon", "1"});
  for (std::size_t k = 0; k < d.stages.size(); ++k) file.table.rows[k].emplace_back(d.stages[k]);
  return file;
}

AnalysisFile density_file(const Analysis& a) {
  const BlockMeans means = a.conditions->blocks();
  AnalysisFile file{
      "density",
      {{{"frames", "1"}, {"density", "g/cm3"}, {"temperature", "K"}}, {}},
      {{}, "density in blocks of frames", "frames", "density  (g/cm³)", {{2, "density"}}}};
  double frames = 0;
  for (const auto& [weight, sum] : means.blocks())
    file.table.rows.push_back({frames += weight, sum[0] / weight / units::gram_per_cm3,
                               a.has_velocities ? sum[1] / weight : std::nan("")});
  return file;
}

/// Diffusion coefficient converted from nm²/ps to 10⁻⁹ m²/s.
double in_si(double diffusion) { return 1000 * diffusion; }

SeriesEstimate without_images(const SeriesEstimate& D, double finite_size_correction) {
  return {D.value + finite_size_correction, D.error, D.known};
}

nlohmann::json pair(const SeriesEstimate& e, double scale = 1) {
  return {{"value", e.value * scale}, {"error", known_error(e) * scale}};
}

/// Null for numbers that do not exist without a peak.
nlohmann::json peak_json(const SitePair& sites,
                         const std::optional<RadialDistribution::Peak>& peak) {
  if (!peak)
    return {{"pair", sites},
            {"peak_nm", nullptr},
            {"peak_height", nullptr},
            {"minimum_nm", nullptr},
            {"coordination", nullptr}};
  return {{"pair", sites},
          {"peak_nm", pair(peak->position)},
          {"peak_height", pair(peak->height)},
          {"minimum_nm", peak->shell ? nlohmann::json(peak->shell->end.value) : nlohmann::json()},
          {"coordination", peak->shell ? pair(peak->shell->coordination) : nlohmann::json()}};
}

/// "2.30 ± 0.03", or the value and why it has no error.
std::string text(const SeriesEstimate& e, int digits, double scale = 1) {
  if (e.known == Known::yes)
    return fmt::format("{:.{}f} ± {:.{}f}", e.value * scale, digits, e.error * scale, digits);
  return fmt::format("{:.{}f} (error not known from {})", e.value * scale, digits,
                     e.known == Known::too_short ? "so short a run" : "so few frames");
}

void print_peak(const std::string& name, const std::optional<RadialDistribution::Peak>& peak) {
  fmt::print("{:<22}", name);
  if (!peak) {
    fmt::print("no peak within its range\n");
    return;
  }
  fmt::print("first peak {} at {} nm; ", text(peak->height, 3), text(peak->position, 4));
  if (peak->shell)
    fmt::print("{} neighbours up to {:.3f} nm\n", text(peak->shell->coordination, 2),
               peak->shell->end.value);
  else
    fmt::print("no minimum within its range\n");
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
  if (s.dielectric) files.push_back(dielectric_file(s));
  if (a.density) files.push_back(density_file(a));
  std::erase_if(files, [](const AnalysisFile& file) { return file.table.rows.empty(); });
  return files;
}

void print_summary(const Analysis& a, const AnalysisSummary& s) {
  fmt::print("{} frames from {:g} to {:g} ps", a.frames, a.first, a.last);
  if (a.interval > 0) fmt::print(", {:.6g} ps apart", a.interval);
  fmt::print(", {} molecules\n\n", a.topology.size());
  fmt::print("density               {} g/cm3\n",
             text(a.conditions->density(), 5, 1 / units::gram_per_cm3));
  if (a.has_velocities)
    fmt::print("temperature           {} K, of the velocities\n",
               text(a.conditions->temperature(), 2));
  for (std::size_t k = 0; k < s.peaks.size(); ++k)
    print_peak(fmt::format("g {}-{}", a.pairs[k][0], a.pairs[k][1]), s.peaks[k]);
  for (const PartSummary& part : s.parts) {
    if (part.diffusion) {
      fmt::print("D of {:<17}{} 1e-9 m2/s in this box, lags {:g} to {:g} ps\n", part.molecule,
                 text(*part.diffusion, 3, in_si(1)), s.fit.from, s.fit.to);
      if (s.finite_size_correction)
        fmt::print("{:<22}{} 1e-9 m2/s corrected for finite size (viscosity {})\n", "",
                   text(without_images(*part.diffusion, *s.finite_size_correction), 3, in_si(1)),
                   s.viscosity_source);
      else
        fmt::print("{:<22}not corrected for finite size: {}\n", "", s.viscosity_source);
    }
    if (part.green_kubo)
      fmt::print("{:<22}{} 1e-9 m2/s in this box, from velocities\n",
                 fmt::format("D of {}", part.molecule), text(*part.green_kubo, 3, in_si(1)));
    for (const AxisRelaxation& axis : part.axes)
      for (std::size_t k = 0; k < 2; ++k) {
        fmt::print("{:<22}", fmt::format("P{} {} {}", k + 1, part.molecule, axis.axis));
        if (const auto& t = axis.rank[k])
          fmt::print("{} ps by integral, {} ps by exponential ({:g} to {:g} ps)\n",
                     text(t->integral, 3), text(t->exponential, 3), t->from, t->to);
        else
          fmt::print("does not fall to 1/e³ within the window\n");
      }
  }
  if (const auto& d = s.dielectric)
    fmt::print("dielectric constant   {}; Kirkwood factor {}; |<M>| is {:.2f} of the rms M\n",
               text(d->constant, 2), text(d->kirkwood, 2), d->mean_over_rms);
}

nlohmann::json as_json(const Analysis& a, const AnalysisSummary& s) {
  nlohmann::json json = {
      {"frames", a.frames},
      {"first_ps", a.first},
      {"last_ps", a.last},
      {"interval_ps", a.interval},
      {"molecules", a.topology.size()},
      {"fit_deviation_nm", a.deviation},
      {"interrupted", a.stopped},
      {"notes", s.notes},
      {"density_g_per_cm3", pair(a.conditions->density(), 1 / units::gram_per_cm3)}};
  if (a.has_velocities) json["temperature_K"] = pair(a.conditions->temperature());
  for (std::size_t k = 0; k < s.peaks.size(); ++k)
    json["rdf"].push_back(peak_json(a.pairs[k], s.peaks[k]));
  if (a.displacement)
    json["diffusion"] = {{"fit_ps", {s.fit.from, s.fit.to}},
                         {"viscosity_source", s.viscosity_source}};
  if (s.finite_size_correction)
    json["diffusion"]["finite_size_correction_1e-9_m2_per_s"] = in_si(*s.finite_size_correction);
  for (const PartSummary& part : s.parts) {
    nlohmann::json one = {{"molecule", part.molecule}, {"count", part.count}};
    if (part.diffusion) one["D_1e-9_m2_per_s"] = pair(*part.diffusion, in_si(1));
    if (part.diffusion && s.finite_size_correction)
      one["D_without_images_1e-9_m2_per_s"] =
          pair(without_images(*part.diffusion, *s.finite_size_correction), in_si(1));
    if (part.green_kubo) one["D_green_kubo_1e-9_m2_per_s"] = pair(*part.green_kubo, in_si(1));
    for (const AxisRelaxation& axis : part.axes)
      for (std::size_t k = 0; k < 2; ++k) {
        nlohmann::json& time = one["relaxation"][axis.axis][fmt::format("P{}", k + 1)];
        if (const auto& t = axis.rank[k])
          time = {{"integral_ps", pair(t->integral)},
                  {"exponential_ps", pair(t->exponential)},
                  {"fit_ps", {t->from, t->to}}};
      }
    json["parts"].push_back(std::move(one));
  }
  if (const auto& d = s.dielectric)
    json["dielectric"] = {{"constant", pair(d->constant)},
                          {"kirkwood", pair(d->kirkwood)},
                          {"mean_over_rms_dipole", d->mean_over_rms}};
  return json;
}

}  // namespace polhode::cli
