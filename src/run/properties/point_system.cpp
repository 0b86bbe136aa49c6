// SPDX-License-Identifier: MIT
#include "run/properties/point_system.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/write_file.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "run/properties/phases.hpp"
#include "run/properties/property.hpp"
#include "run/simulation/files/identity.hpp"

namespace polhode {
namespace {

/// The maximum time-step bias: a third of the smallest relative error requested for an average,
/// or 0.1 % if none is requested.
double max_bias(const MeasureSettings& settings) {
  double bound = 0.001;
  for (const RequestedProperty& p : settings.properties)
    if (p.relative && p.property->measured_in == MeasuredIn::averages)
      bound = std::min(bound, p.error / 3);
  return bound;
}

}  // namespace

PointSystem::PointSystem(const MeasureSettings& settings, const StatePoint& at)
    : common{.config = settings.config,
             .at = at,
             .max_bias = max_bias(settings),
             .paired_runs = settings.paired_runs,
             .sampling = settings.sampling,
             .scheme = settings.scheme,
             .given_step = settings.step} {
  Config& config = common.config;
  config.system.temperature = at.temperature;
  topology = build_topology(config.system);
  common.liquid_density = estimated_density(topology);
  check_density(common.liquid_density, at);
  Config built = configuration_of(common);
  built.run.minimise = true;  // as in each replica: molecules overlap on a lattice of this density
  const System system = build_system(built);
  topology = system.topology;
  mixing = system.forces.mixing;
  // More at constant volume, and with another sampling, scheme or step, so that records are never
  // mixed.
  std::vector<double> state{at.temperature, at.constant_volume() ? at.density : at.pressure};
  if (at.constant_volume()) state.push_back(1);
  if (settings.sampling == Sampling::hybrid_monte_carlo) state.push_back(2);
  std::string more = settings.scheme == MeasureSettings{}.scheme ? "" : settings.scheme;
  if (settings.step > 0) more += fmt::format(" {:.9g} ps", settings.step);
  identity = text_hash(polhode::identity(config, system, state) + more);
}

void check_properties(const MeasureSettings& settings, const Topology& topology) {
  for (const RequestedProperty& request : settings.properties) {
    std::string why = why_not(*request.property, topology, settings.config.forces);
    for (const StatePoint& at : settings.points)
      if (why.empty()) why = why_not(*request.property, at);
    if (why.empty() && request.property->measured_in != MeasuredIn::pair &&
        topology.size() < min_of_liquid)
      why = fmt::format("the system has {} molecules; a liquid needs at least {}", topology.size(),
                        min_of_liquid);
    if (!why.empty())
      throw Error(fmt::format("{} cannot be measured: {}", request.property->name, why));
  }
}

}  // namespace polhode
