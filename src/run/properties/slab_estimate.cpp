// SPDX-License-Identifier: MIT
// The surface tension and the coexistence of liquid and vapour, from the slabs of the replicas.
#include <fmt/format.h>

#include <string_view>

#include "io/settings/quantity.hpp"
#include "polhode/base/units.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/slab.hpp"

namespace polhode {
namespace {

constexpr double mN_per_m = units::avogadro * 1e-24;  // 1 mN/m [kJ/mol/nm²]
const double bar = unit("bar", Dimension::pressure), kg_per_m3 = unit("kg/m3", Dimension::density);

/// The segments of a slab in equilibrium, which its potential energy shows.
std::span<const SlabSegment> slab_in_equilibrium(const Contribution& c) {
  const std::span<const SlabSegment> segments = c.replica->slab.segments;
  std::vector<double> all;
  for (const SlabSegment& segment : segments)
    all.insert(all.end(), segment.potentials.begin(), segment.potentials.end());
  return all.empty() ? segments : segments.subspan(equilibrium_of(all));
}

/// Segments in equilibrium, with a run for each replica, or as one run if they are too short.
std::vector<BlockMeans> runs_of_slab(const Contributions& contributions) {
  return separate_or_joined(runs_of(contributions, slab_in_equilibrium, &SlabSegment::sums));
}

/// Runs of the normal pressure, followed by the tangential pressure in each bin.
std::vector<BlockMeans> pressure_runs_of(const Contributions& contributions) {
  std::vector<BlockMeans> runs;
  for (const Contribution& contribution : contributions.all) {
    std::vector<BlockMeans::Block> run;
    for (const SlabSegment& segment : slab_in_equilibrium(contribution)) {
      const auto& [weight, tangential] = segment.tangential;
      if (weight == 0) continue;
      const BlockMeans::Block& sums = segment.sums;
      BlockMeans::Block block{weight, {weight * sums.sum[normal_pressure] / sums.weight}};
      block.sum.insert(block.sum.end(), tangential.begin(), tangential.end());
      run.push_back(std::move(block));
    }
    if (!run.empty()) runs.emplace_back(std::move(run));
  }
  return separate_or_joined(std::move(runs));
}

double degrees_of_freedom_of_slab(Topology topology) {
  for (Topology::Part& part : topology.parts) part.count *= slab_copies;
  return degrees_of_freedom(topology).all();
}

/// The bins of the profile as densities [kg/m³].
struct Profile {
  double height, width;

  explicit Profile(const State& state) : height(height_of_bin(state)), width(state.box.edge.x) {}
  double at(Means means, std::size_t bin) const {
    return means[slab_averages_count + bin] / kg_per_m3;
  }
  double liquid(Means means) const { return means[liquid_density] / kg_per_m3; }
  double vapour(Means means) const { return means[vapour_density] / kg_per_m3; }
  /// The outermost distance at which the density has fallen to a share of the difference of liquid
  /// and vapour.
  double fall(Means means, double share) const {
    const double level = vapour(means) + share * (liquid(means) - vapour(means));
    for (std::size_t k = bins_of_profile - 1; k > 0; --k)
      if (const double inner = at(means, k - 1), outer = at(means, k); inner >= level)
        return height * (static_cast<double>(k) - 0.5 + (inner - level) / (inner - outer));
    return 0;
  }
  double thickness(Means means) const { return fall(means, 0.1) - fall(means, 0.9); }
};

/// The profile in words.
std::string remark_of(std::span<const BlockMeans> runs, const Profile& profile) {
  const auto text = [&](const Statistic& f, const char* unit) {
    return text_of(pooled_estimate(runs, f), unit);
  };
  return fmt::format("{:.2f} nm wide; {} in the middle, surfaces {} thick (10 to 90 %)",
                     profile.width, text([&](Means all) { return profile.liquid(all); }, "kg/m3"),
                     text([&](Means all) { return profile.thickness(all); }, "nm"));
}

}  // namespace

void estimate_slab(MeasuredProperty& m, const Contributions& contributions, const PointData& data) {
  if (contributions.all.empty()) return;
  const std::vector<BlockMeans> runs = runs_of_slab(contributions);
  if (runs.front().empty()) return;
  const std::string_view name = m.request.property->name;
  const Profile profile(*contributions.all.front().replica->slab.state);
  const auto value = [&](Means means) {
    if (name == "saturation-pressure") return means[normal_pressure] / bar;
    if (name == "saturated-liquid-density") return profile.liquid(means);
    if (name == "saturated-vapour-density") return profile.vapour(means);
    return means[tension] / mN_per_m;
  };
  m.value = pooled_estimate(runs, value);
  if (name == "saturated-vapour-density" && m.value.value == 0) {
    m.value = {0, 0, Known::too_few_samples};
    m.obstacle =
        "no molecule was in the vapour; the vapour pressure from the chemical potential is more "
        "precise";
    m.longer_helps = false;
    return;
  }
  if (name == "surface-tension") {
    constexpr std::size_t wide =
        500;  // molecules; slabs of 200 argon atoms have an error of a tenth
    m.remark = remark_of(runs, profile);
    if (data.topology.size() < wide)
      m.remark += fmt::format(
          "; the tension of so narrow a slab may be wrong by 10 %: give {} molecules or more",
          wide);
  }
  if (m.value.known == Known::yes)
    subtract_bias(
        m, step_bias(responses_of(contributions, slab_in_equilibrium, &SlabSegment::response),
                     degrees_of_freedom_of_slab(data.topology), FixedMeans::kinetic_energy, value));
}

std::vector<MeasuredCurve> slab_profiles(const PointData& data) {
  const Contributions contributions(data, MeasuredIn::slab);
  if (contributions.all.empty()) return {};
  const std::vector<BlockMeans> runs = runs_of_slab(contributions);
  if (runs.front().empty()) return {};
  const Profile profile(*contributions.all.front().replica->slab.state);
  const auto curve = [&](const char* title, const char* unit, double place,
                         const std::vector<BlockMeans>& from, const auto& value) {
    MeasuredCurve c{title, "distance from the middle of the slab (nm)", unit, {}, {}};
    for (std::size_t k = 0; k < bins_of_profile; ++k) {
      c.x.push_back((static_cast<double>(k) + place) * profile.height);
      c.value.push_back(pooled_estimate(from, [&](Means all) { return value(all, k); }));
    }
    return c;
  };
  std::vector<MeasuredCurve> curves{curve(
      "density", "kg/m3", 0.5, runs, [&](Means all, std::size_t k) { return profile.at(all, k); })};
  const std::vector<BlockMeans> of_pressure = pressure_runs_of(contributions);
  if (of_pressure.empty() || of_pressure.front().empty()) return curves;
  curves.push_back(curve("normal minus tangential pressure", "bar", 0.5, of_pressure,
                         [](Means all, std::size_t k) { return (all[0] - all[1 + k]) / bar; }));
  curves.push_back(
      curve("tension within a distance", "mN/m", 1, of_pressure, [&](Means all, std::size_t k) {
        double sum = 0;
        for (std::size_t n = 0; n <= k; ++n) sum += all[0] - all[1 + n];
        return sum * profile.height / mN_per_m;
      }));
  return curves;
}

}  // namespace polhode
