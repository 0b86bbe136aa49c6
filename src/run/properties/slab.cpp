// SPDX-License-Identifier: MIT
#include "run/properties/slab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <utility>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/forces/molecular_virials.hpp"
#include "run/properties/chain.hpp"

namespace polhode {
namespace {

/// The middle of a slab: the phase of the longest wave of its mass along z.
double middle_of(const State& state, const Bodies& bodies) {
  const double k = 2 * units::pi / state.box.edge.z;
  std::complex<double> wave = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    wave += bodies.m[i] * std::polar(1.0, k * state.q[i].z);
  return std::arg(wave) / k;
}

/// The density of a quantity in bins of the distance from the middle of the slab [1/nm³].
/// @param of  the quantity of a molecule
template <class Of>
std::vector<double> profile_of(const State& state, const Bodies& bodies, const Of& of) {
  std::vector<double> bins(bins_of_profile);
  const double middle = middle_of(state, bodies), height = height_of_bin(state);
  const double volume = 2 * height * state.box.edge.x * state.box.edge.y;  // of both sides
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double z = state.box.minimum_image({0, 0, state.q[i].z - middle}).z;
    const auto bin = static_cast<std::size_t>(std::abs(z) / height);
    bins[std::min(bin, bins.size() - 1)] += of(i) / volume;
  }
  return bins;
}

/// The tangential pressure of a slab, from virials at the places of their molecules
/// [harasima1958, sonne2005].
class TangentialPressure {
 public:
  TangentialPressure(Chain& chain, double kT)
      : bodies_(chain.system().bodies),
        virials_(chain.system().topology, chain.force_settings(), chain.system().state.box),
        kT_(kT) {}

  /// Adds every fifth state; the first one is the last of the previous segment.
  void add(const State& state) {
    if (samples_++ % samples_of_virials != 0 || samples_ == 1) return;
    const Vec3Column& w = virials_(state);
    const std::vector<double> bins =
        profile_of(state, bodies_, [&](std::size_t i) { return kT_ + (w[i].x + w[i].y) / 2; });
    sums.weight += 1;
    for (std::size_t k = 0; k < bins.size(); ++k) sums.sum[k] += bins[k];
  }

  BlockMeans::Block sums{0, std::vector<double>(bins_of_profile)};

 private:
  const Bodies& bodies_;
  MolecularVirials virials_;
  double kT_;
  std::size_t samples_ = 0;
};

using SlabAverages = std::array<double, slab_averages_count>;

void add_densities(SlabAverages& averages, std::span<const double> bins) {
  const auto mean = [](std::span<const double> x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  };
  averages[liquid_density] = mean(bins.first(bins_of_liquid));
  averages[vapour_density] = mean(bins.last(bins_of_vapour));
}

/// The tension of one of the two surfaces [allen2017, section 14.1]. The kinetic parts of the
/// pressures cancel in the mean, and would only add noise.
double tension_of(const State& state, const Load& load) {
  const Mat3<double>& W = load.virial;
  return (W[2].z - (W[0].x + W[1].y) / 2) / (2 * state.box.edge.x * state.box.edge.y);
}

/// @throws RunError  if the middle of the vapour is nearly as dense as that of the slab
void check_slab(std::span<const double> averages, const StatePoint& at) {
  constexpr double max_ratio = 0.4;
  const double liquid = averages[liquid_density], vapour = averages[vapour_density];
  if (vapour < max_ratio * liquid) return;
  throw RunError(fmt::format(
      "at {}: the slab has evaporated: the vapour has {:.2g} times the density of the middle of "
      "the "
      "slab; give a lower temperature, since near the critical point there is no surface",
      at.text(), vapour / liquid));
}

}  // namespace

void make_slab(System& system) {
  State& state = system.state;
  for (std::size_t i = 0; i < state.size(); ++i) {  // so that no molecule is far from the slab
    const double height = state.box.edge.z, z = state.q[i].z;
    state.q.add(i, {0, 0, -height * std::floor(z / height)});
  }
  stack(system, slab_copies);
  const double thickness = state.box.edge.z;
  for (std::size_t i = 0; i < state.size(); ++i) state.q.add(i, {0, 0, thickness / 2});
  state.box.edge.z = 2 * thickness;
  ForceSettings& forces = system.forces;
  forces.slab_dispersion = forces.slab_dispersion || forces.dispersion_correction;
  forces.dispersion_correction = false;
}

bool add_slab(Replica& replica, const ReplicaSettings& settings) {
  SlabChain& slab = replica.slab;
  Chain chain(settings, replica, slab.meshes);
  if (!begin_copies(chain, replica, slab.state, make_slab, relaxing_slab)) return false;
  System& system = chain.system();
  TrajectorySettings t = sampling_of(chain, replica.compressibility, replica.step,
                                     steps_of_averages, slab_averaging + slab.segments.size());
  t.ensemble.barostat.reset();
  const auto fixed = t.fixed_means();
  SlabSegment segment{.sums = {0, std::vector<double>(slab_averages_count + bins_of_profile)},
                      .response = {}};
  if (!slab.segments.empty()) segment.response.first = slab.segments.front().response.first;
  // All N molecules, because the centre of mass has no momentum, but is anywhere in the box.
  const double kT = units::boltzmann * settings.at.temperature,
               ideal = static_cast<double>(system.state.size()) * kT;
  std::optional<TangentialPressure> pressure;
  if (system.topology.parts.size() == 1) pressure.emplace(chain, kT);
  SlabAverages x{};
  double part = 0;
  constexpr std::size_t samples_of_part = steps_of_averages / steps_of_sample / parts_of_averages;
  const auto load = [&](const State& state, const Load& forces) {
    x[tension] = tension_of(state, forces);
    x[normal_pressure] = (ideal + forces.virial[2].z) / state.box.volume();
    if (pressure) pressure->add(state);
  };
  const auto sample = [&](std::size_t steps, const State& state, const Energies& now) {
    if (steps == 0) return;  // the last sample of the previous segment
    segment.sums.weight += 1;
    const std::vector<double> bins =
        profile_of(state, system.bodies, [&](std::size_t i) { return system.bodies.m[i]; });
    add_densities(x, bins);
    for (std::size_t k = 0; k < x.size(); ++k) segment.sums.sum[k] += x[k];
    for (std::size_t k = 0; k < bins.size(); ++k) segment.sums.sum[x.size() + k] += bins[k];
    part += now.potential() / samples_of_part;
    if (steps % (samples_of_part * steps_of_sample) == 0)
      segment.potentials.push_back(std::exchange(part, 0));
    if (fixed && !std::isnan(now.step_error)) segment.response.add(step_error(now, *fixed, 0), x);
  };
  if (!chain.run(t, {.sample = sample, .load = load})) return false;
  segment.response.blocks = {{segment.response.blocks.means().sum()}, 1};
  if (pressure) segment.tangential = pressure->sums;
  check_slab(segment.sums.sum, settings.at);
  slab.state = system.state;
  slab.segments.push_back(std::move(segment));
  return true;
}

}  // namespace polhode
