// SPDX-License-Identifier: MIT
// Mean-square displacements of centres of mass, with diffusion coefficients.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "convergence_results.hpp"
#include "curves.hpp"
#include "io/files/with_error.hpp"
#include "io/settings/quantity.hpp"
#include "measure/displacement.hpp"
#include "measure/finite_size.hpp"
#include "run/analysis/analysis_summary.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

struct PublishedViscosity {
  std::string_view model;
  std::string_view value;
};

// The published viscosities are from [gonzalez2010], at 298 K and 1 bar.
constexpr PublishedViscosity published[] = {
    {"tip3p", "0.321 mPa s"}, {"tip4p", "0.494 mPa s"},      {"tip5p", "0.699 mPa s"},
    {"spce", "0.729 mPa s"},  {"tip4p-2005", "0.855 mPa s"},
};
constexpr double published_temperature = 298;  // temperature of the published viscosities [K]
constexpr double near = 5;                     // largest difference from this value [K]; the
                                               // viscosity of water changes by 2 % per K

/// The viscosity of the liquid.
struct Viscosity {
  std::optional<double> value;  ///< [u/(nm ps)]
  std::string source;           ///< source of the value; otherwise the reason why there is no value
};

/// The finite-size correction, which is added to the diffusion coefficients.
struct Correction {
  std::optional<Vec3<double>> axes;  ///< correction along each axis [nm²/ps]
  std::string source;                ///< source of the viscosity; otherwise the reason why there is
                                     ///< no correction
  /// The correction of the mean over the axes [1e-9 m²/s].
  std::optional<double> mean() const {
    if (!axes) return {};
    return in_1e9_m2_per_s * (axes->x + axes->y + axes->z) / 3;
  }
};

Viscosity viscosity(const AllFrames& all) {
  if (all.settings.viscosity) return {all.settings.viscosity, "as given"};
  const auto& parts = all.analysis.topology.parts;
  const auto known = std::find_if(std::begin(published), std::end(published), [&](const auto& one) {
    return parts.size() == 1 && parts.front().molecule.name == one.model;
  });
  if (known == std::end(published))
    return {{},
            "there is no published viscosity for these molecules; give the viscosity as "
            "'viscosity', for example \"0.9 mPa s\""};
  if (!all.temperature || std::abs(*all.temperature - published_temperature) > near)
    return {{},
            fmt::format(
                "the published viscosity of {}, {}, applies to {:g} K and 1 bar [gonzalez2010]; "
                "give the viscosity at {} as 'viscosity'",
                known->model, known->value, published_temperature,
                all.temperature ? fmt::format("{:.4g} K", *all.temperature) : "the temperature")};
  return {
      quantity(known->value, Dimension::viscosity, "viscosity"),
      fmt::format("of {} at {:g} K and 1 bar, gonzalez2010", known->model, published_temperature)};
}

Correction correction(const AllFrames& all) {
  if (!all.temperature)
    return {{}, "the frames have no velocities, so the temperature is unknown; give a temperature"};
  const auto [eta, source] = viscosity(all);
  if (!eta) return {{}, source};
  // The last box is scaled to the mean volume, because a barostat changes the volume.
  const Box& box = all.analysis.box;
  const double scale = std::cbrt(all.analysis.conditions->volume().value / box.volume());
  return {finite_size_correction(*all.temperature, *eta, scale * box.edge), source};
}

std::string why_no_displacements(const FirstFrames& f) {
  return f.analysis.topology.size() > 1 ? ""
                                        : "displacements are relative to the centre of mass of all "
                                          "molecules, but there is only one molecule";
}

/// The line fitted to the mean-square displacements, with the diffusion coefficient [1e-9 m²/s].
CurvesFigure::Line fitted_line(const SeriesEstimate& D, const Convergence& convergence,
                               const BlockMeans& squared, double interval, const FitWindow& fit) {
  const auto at = [&](double lag) { return fitted_displacement(squared, interval, fit, lag); };
  return {"fit: " + (convergence.converged()
                         ? "D = " + with_error(D.value, known_error(D)) + " × 10⁻⁹ m²/s"
                         : std::string("D not converged")),
          {fit.from, fit.to},
          {at(fit.from), at(fit.to)}};
}

/// The diffusion coefficients in this box, of a kind of molecule and along the axes [1e-9 m²/s],
/// and the coefficient in an infinite box.
Quantities quantities_of(const std::string& molecule, const SeriesEstimate& D,
                         const AxisEstimates& axes, const Convergence& convergence,
                         const FitWindow& fit, const Correction& c) {
  const std::string label = "D of " + molecule;
  SeriesEstimate corrected = D;
  corrected.value += c.mean().value_or(0);
  Quantities list = {{"D", "1e-9 m2/s", converging(D, convergence, max_lag)}};
  if (c.axes)
    list.push_back({"D_without_images", "1e-9 m2/s", converging(corrected, convergence, max_lag)});
  if (!convergence.converged()) {
    list.push_back(row(label, not_converged(convergence, max_lag)));
    return list;
  }
  list.push_back({"D_along_axes", "1e-9 m2/s", axes});
  list.push_back(row(label, fmt::format("{} 1e-9 m2/s in this box, lags {:g} to {:g} ps",
                                        short_text(D), fit.from, fit.to)));
  list.push_back(
      row("  along x, y and z", fmt::format("{}, {} and {} 1e-9 m2/s", short_text(axes[0]),
                                            short_text(axes[1]), short_text(axes[2]))));
  list.push_back(row("  in an infinite box",
                     c.axes ? fmt::format("{} 1e-9 m2/s, corrected for finite size (viscosity {})",
                                          short_text(corrected), c.source)
                            : "not corrected for finite size: " + c.source));
  return list;
}

void note_long_steps(const Displacement& displacement, const AllFrames& all) {
  if (displacement.max_step() > safe_step)
    all.notes.push_back(fmt::format(
        "between frames centres of mass moved by up to {:.2f} box edges; above {:g} box edges, "
        "displacements across periodic boundaries may be too short, so write frames more often",
        displacement.max_step(), safe_step));
}

/// Adds the mean-square displacements of one kind of molecule.
Quantities add_displacements(AnalysisFile& file, Displacement& displacement, std::size_t part,
                             const FitWindow& fit, const Correction& correction,
                             const AllFrames& all) {
  const Analysis& a = all.analysis;
  const auto& [molecule, count] = a.topology.parts[part];
  const BlockMeans means = displacement.mean_square(part, all.workers);
  const std::vector<SeriesEstimate> squared = series_estimates(means);
  CurvesFigure::Panel panel{title_of_part(a, part), {}};
  draw(panel, "MSD", add(file.table, of_part(a, part, "msd"), "nm2", squared), squared);
  Quantities list;
  const SeriesEstimate D = scaled(diffusion(means, a.interval, fit), in_1e9_m2_per_s);
  if (count > 0 && !std::isnan(D.value)) {
    AxisEstimates along;
    for (std::size_t axis = 0; axis < along.size(); ++axis)
      along[axis] = scaled(
          diffusion_along(displacement.mean_square_along(axis, part, all.workers), a.interval, fit),
          in_1e9_m2_per_s);
    const Convergence convergence = diffusion_convergence(means, a.interval, fit);
    panel.lines.push_back(fitted_line(D, convergence, means, a.interval, fit));
    list = quantities_of(molecule.name, D, along, convergence, fit, correction);
  } else if (count > 0 && part == 0) {
    all.notes.push_back(
        fmt::format("no diffusion coefficient: there are fewer than two lags between {:g} and {:g} "
                    "ps; the maximum lag is {:g} ps",
                    fit.from, fit.to, static_cast<double>(squared.size() - 1) * a.interval));
  }
  file.figure.panels.push_back(std::move(panel));
  return list;
}

ObservableResults displacement_results(Displacement& displacement, const AllFrames& all) {
  const Analysis& a = all.analysis;
  note_long_steps(displacement, all);
  const std::size_t lags = displacement.mean_square(0, all.workers).mean().size();
  const double max_lag = static_cast<double>(lags - 1) * a.interval;
  const FitWindow fit = all.settings.fit.value_or(FitWindow{max_lag / 5, max_lag});
  const Correction c = correction(all);
  AnalysisFile file =
      file_of_lags("msd", lags, a.interval,
                   {{}, "mean-square displacement of centres of mass", "lag  (ps)", "MSD  (nm²)"});
  Quantities about = {{"fit", "ps", std::vector{fit.from, fit.to}},
                      {"viscosity_source", "", c.source}};
  if (c.axes) {
    const Vec3<double> axes = in_1e9_m2_per_s * *c.axes;
    about.push_back({"finite_size_correction", "1e-9 m2/s", *c.mean()});
    about.push_back(
        {"finite_size_correction_along_axes", "1e-9 m2/s", std::vector{axes.x, axes.y, axes.z}});
  }
  ObservableResults results{.quantities = {{"diffusion", "", std::move(about)}}};
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part)
    results.parts.push_back(add_displacements(file, displacement, part, fit, c, all));
  finish(file.figure, true);
  results.files.push_back(std::move(file));
  return results;
}

}  // namespace

ObservableKind msd() {
  return correlated<Displacement>("msd", {"msd"}, why_no_displacements, displacement_results);
}

}  // namespace polhode
