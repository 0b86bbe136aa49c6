// SPDX-License-Identifier: MIT
// The thermal conductivity from dynamics with the heat flux.
#include <fmt/format.h>

#include <cmath>

#include "polhode/base/units.hpp"
#include "polhode/forces/heat_flux.hpp"
#include "run/properties/chain.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/low_frequency_spectrum.hpp"

namespace polhode {
namespace {

constexpr std::size_t axes = 3;

/// The spectrum of the heat flux times the root of the volume in a segment; nothing if it was
/// stopped.
std::optional<BlockMeans::Block> heat_flux(Chain& chain, double whole_step, std::size_t parts,
                                           std::uint64_t stream) {
  const System& system = chain.system();
  TrajectorySettings t = segment_of_dynamics(chain, whole_step, parts, stream);
  // The flux contains products of two motions. A step is about a tenth of the shortest period, so
  // these products have no spectrum at the sampling frequency, which would be added to that at 0.
  constexpr std::size_t every = 2;
  t.sample = every * whole_step;
  HeatFlux flux(system.topology, chain.force_settings(), system.state.box);
  const double root_of_volume = std::sqrt(system.state.box.volume());
  LowFrequencySpectrum<axes> spectrum(steps_of_lags * windows_in_segment / every, t.sample);
  const auto load = [&](const State& state, const Load&) {
    const Vec3<double> J = flux(state) / root_of_volume;
    spectrum.add({J.x, J.y, J.z});
  };
  if (!chain.run(t, {.load = load})) return std::nullopt;
  return BlockMeans::Block{1, spectrum.means(pressure_bins())};
}

}  // namespace

bool add_conduction(Replica& replica, const ReplicaSettings& settings) {
  DynamicsChain& conduction = replica.conduction;
  Chain chain(settings, replica, conduction.meshes);
  chain.system().state = conduction.state.value_or(replica.state);
  if (!conduction.state) scale_to_mean(chain, replica);
  return extend(conduction, chain, replica.step, conducting, conduction_pairing, heat_flux);
}

double conductivity_per_spectrum(double temperature) {
  return 1 / (2 * units::boltzmann * temperature * temperature * W_per_m_K);
}

void estimate_conduction(MeasuredProperty& m, const Contributions& contributions,
                         const PointData& data) {
  const std::vector<BlockMeans> runs = dynamics_of(contributions, all_sums);
  if (runs.front().empty()) return;
  double segments = 0;
  for (const BlockMeans& run : runs) segments += static_cast<double>(run.blocks().size());
  const ZeroFrequency spectrum(overall(runs), axes * segments, pressure_bins());
  const double per_spectrum = conductivity_per_spectrum(data.at.temperature);
  const auto value = [&](Means means) { return per_spectrum * spectrum.value(means); };
  m.value = pooled_estimate(runs, value);
  constexpr std::size_t min_molecules = 100;
  if (data.topology.size() < min_molecules)
    m.remark = fmt::format("with fewer than {} molecules, the value depends on their number",
                           min_molecules);
  m.step_bound = step_bound(step_difference(contributions, all_sums, value));
  if (m.value.known != Known::yes || spectrum.is_resolved()) return;
  m.longer_helps = false;
  m.obstacle =
      "the heat flux changes too slowly for the length of a segment, so its spectrum at zero "
      "frequency, which gives the thermal conductivity, is not resolved";
}

}  // namespace polhode
