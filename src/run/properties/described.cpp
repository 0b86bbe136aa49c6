// SPDX-License-Identifier: MIT
// The conditions and curves of a state point, for figures.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "io/settings/quantity.hpp"
#include "polhode/base/units.hpp"
#include "run/properties/distances.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"
#include "run/properties/target.hpp"

namespace polhode {
namespace {

std::vector<EquilibrationTrace> traces_of(const PointData& data) {
  std::vector<EquilibrationTrace> traces;
  for (const Replica& replica : data.replicas) {
    EquilibrationTrace trace;
    const double part = replica.step * static_cast<double>(steps_of_averages) / parts_of_averages;
    for (const AveragesSegment& segment : replica.averages)
      for (std::size_t k = 0; k < segment.potentials.size(); ++k) {
        trace.time.push_back((static_cast<double>(trace.time.size()) + 0.5) * part);
        trace.potential.push_back(segment.potentials[k] /
                                  static_cast<double>(data.topology.size()));
        trace.density.push_back(in_kg_m3(data.topology.mass() / segment.volumes[k]));
      }
    trace.begin = static_cast<double>(equilibrated(replica) * parts_of_averages) * part;
    traces.push_back(std::move(trace));
  }
  return traces;
}

/// A spectrum in units of the property that it is at zero frequency, up to a frequency where the
/// spectrum of a liquid has decreased.
/// @param length  length of a segment [ps]
MeasuredCurve spectrum_of(const char* title, const char* unit, double length,
                          const std::function<SeriesEstimate(std::size_t bin)>& value) {
  constexpr double max_mode = 200;
  MeasuredCurve c{title, "frequency (1/ps)", unit, {}, {}};
  for (std::size_t b = 0; b < pressure_bins().size() && pressure_bins().middle(b) < max_mode; ++b) {
    c.x.push_back(pressure_bins().middle(b) / length);
    c.value.push_back(value(b));
  }
  return c;
}

double length_of_segment(const Contributions& contributions) {
  return lag_interval(*contributions.all.front().replica) *
         static_cast<double>(lags * windows_in_segment);
}

MeasuredCurve spectrum_of_pressure(const Contributions& contributions,
                                   std::span<const BlockMeans> runs,
                                   const CorrelationsOfDynamics& which, const StatePoint& at) {
  const double to_mPa_s = box_of(contributions).volume() / (2 * units::boltzmann * at.temperature) /
                          unit("mPa s", Dimension::viscosity);
  return spectrum_of("spectrum of the pressure: at zero frequency it is the viscosity", "mPa s",
                     length_of_segment(contributions), [&](std::size_t b) {
                       return pooled_estimate(
                           runs, [&](auto all) { return to_mPa_s * which.spectrum_in(all)[b]; });
                     });
}

std::vector<MeasuredCurve> spectrum_of_heat_flux(const PointData& data) {
  const Contributions contributions(data, MeasuredIn::conduction);
  const std::vector<BlockMeans> runs = dynamics_of(contributions, all_sums);
  if (runs.front().empty()) return {};
  const double factor = conductivity_per_spectrum(data.at.temperature);
  return {spectrum_of("spectrum of the heat flux: at zero frequency it is the thermal conductivity",
                      "W/m/K", length_of_segment(contributions),
                      [&](std::size_t b) { return scaled(pooled_mean(runs, b), factor); })};
}

/// The mean-square displacement of each kind of molecule, and the spectrum of the pressure.
std::vector<MeasuredCurve> curves_of(const PointData& data) {
  const CorrelationsOfDynamics which(data.topology);
  const Contributions contributions(data, MeasuredIn::dynamics);
  const std::vector<BlockMeans> runs = dynamics_of(contributions, which.functions());
  if (runs.front().empty()) return {};
  const double interval = lag_interval(*contributions.all.front().replica);
  const auto curve = [&](std::string title, std::string in, std::size_t correlation,
                         double factor) {
    MeasuredCurve c{std::move(title), "lag (ps)", std::move(in), {}, {}};
    constexpr std::size_t every = 8;  // a figure cannot show more points
    for (std::size_t k = 0; k < lags; k += every) {
      c.x.push_back(static_cast<double>(k) * interval);
      c.value.push_back(
          pooled_estimate(runs, [&](auto all) { return factor * all[correlation * lags + k]; }));
    }
    return c;
  };
  std::vector<MeasuredCurve> curves;
  for (std::size_t part = 0; part < which.displacement.size(); ++part)
    curves.push_back(curve("mean-square displacement of " + data.topology.parts[part].molecule.name,
                           "nm2", which.displacement[part], 1));
  curves.push_back(spectrum_of_pressure(contributions, runs, which, data.at));
  return curves;
}

/// The radial distribution functions of the dynamics.
std::vector<MeasuredDistribution> distributions(const PointData& data) {
  const std::vector<BlockMeans> runs = dynamics_of(
      Contributions(data, MeasuredIn::dynamics), CorrelationsOfDynamics(data.topology).distances());
  if (runs.front().empty()) return {};
  const std::vector<double> means = overall(runs);
  const Distances distances = Distances::of_sums(data.topology, means.size());
  std::vector<MeasuredDistribution> list;
  for (std::size_t p = 0; p < distances.pairs().size(); ++p) {
    MeasuredDistribution d{distances.pairs()[p], {}, {}, {}};
    const std::vector<double> scale = distances.scales(p);
    for (std::size_t k = 0; k < distances.bins(); ++k) {
      d.r.push_back(distances.middle(k));
      d.g.push_back(scaled(pooled_mean(runs, distances.index(p, k)), scale[k]));
    }
    d.peak =
        distances.first_peak(p, means, [&](const auto& f) { return pooled_estimate(runs, f); });
    list.push_back(std::move(d));
  }
  return list;
}

}  // namespace

bool MeasuredPoint::wants_distributions() const {
  return std::ranges::any_of(properties, [](const MeasuredProperty& m) {
    return std::string_view(m.request.property->name) == "coordination-number";
  });
}

MeasuredPoint described(const PointData& data) {
  MeasuredPoint point{
      .at = data.at,
      .molecules = data.topology.size(),
      .replicas = data.replicas.size(),
      .edge = std::cbrt(box_of(Contributions(data, MeasuredIn::dynamics)).volume())};
  for (const Replica& replica : data.replicas) {
    if (!replica.prepared()) continue;
    const double segment = replica.step * static_cast<double>(steps_of_averages);
    const auto discarded = static_cast<double>(equilibrated(replica));
    point.step_max = std::max(point.step_max, replica.step);
    point.equilibration_max = std::max(point.equilibration_max, discarded * segment);
    point.length_of_averages +=
        (static_cast<double>(replica.averages.size()) - discarded) * segment;
    std::size_t segments = 0;
    for (const MeasuredIn kind : kinds_of_run)
      if (const DynamicsChain* chain = chain_of(replica, kind)) segments += chain->segments.size();
    point.length_of_coupling +=
        replica.step * steps_of(MeasuredIn::coupling, replica.coupled.segments.size(), 0,
                                replica.coupled.path.size());
    point.length_of_slab += segment * static_cast<double>(replica.slab.segments.size());
    point.length_of_dynamics += static_cast<double>(segments) * replica.step *
                                static_cast<double>(steps_of_lags * windows_in_segment);
  }
  point.traces = traces_of(data);
  point.curves = curves_of(data);
  for (MeasuredCurve& curve : spectrum_of_heat_flux(data)) point.curves.push_back(std::move(curve));
  point.profiles = slab_profiles(data);
  point.distributions = distributions(data);
  return point;
}

}  // namespace polhode
