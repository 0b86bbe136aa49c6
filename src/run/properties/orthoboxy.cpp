// SPDX-License-Identifier: MIT
// Diffusion and viscosity from dynamics in the long box of OrthoBoXY.
#include <string_view>

#include "io/settings/quantity.hpp"
#include "measure/finite_size.hpp"
#include "polhode/base/units.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

/// The diffusion coefficients along the axes [nm²/ps].
Vec3<double> diffusion_of(Means all, double interval, const FitWindow& fit) {
  const auto D = [&](std::size_t axis) {
    return slope_between(all.subspan(axis * lags, lags), interval, fit) / 2;
  };
  return {D(0), D(1), D(2)};
}

/// The mean edges of the long boxes.
Vec3<double> edges_of(const Contributions& contributions) {
  Vec3<double> sum{};
  double count = 0;
  for (const auto& [replica, from] : contributions.all)
    if (const auto& state = replica->elongated.state) sum += state->box.edge, ++count;
  return sum / count;
}

}  // namespace

void estimate_orthoboxy(MeasuredProperty& m, const Contributions& contributions,
                        const PointData& data) {
  const std::vector<BlockMeans> runs = dynamics_of(contributions, all_sums);
  if (runs.front().empty()) return;
  const double interval = lag_interval(*contributions.all.front().replica);
  const bool viscosity = std::string_view(m.request.property->name) == "viscosity-orthoboxy";
  const Vec3<double> taken = image_mobility(edges_of(contributions));
  const double kT = units::boltzmann * data.at.temperature;
  const double unit_of = viscosity ? unit("mPa s", Dimension::viscosity) : nm2_per_ns;
  const auto value = [&](Means all, const FitWindow& fit) {
    const Vec3<double> D = diffusion_of(all, interval, fit);
    if (viscosity) return kT * (2 * taken.z - taken.x - taken.y) / (D.x + D.y - 2 * D.z) / unit_of;
    return (D.x + D.y) / 2 / unit_of;
  };
  const FitWindow window = fit_window(interval);
  estimate_slope(m, runs, interval, value);
  m.step_bound = step_bound(
      step_difference(contributions, all_sums, [&](Means all) { return value(all, window); }));
}

}  // namespace polhode
