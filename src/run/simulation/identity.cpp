// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/identity.hpp"

#include <fmt/core.h>

#include <sstream>

namespace polhode {
namespace {

// Of Lennard-Jones: nothing besides σ and ε.
std::string law_identity(const Site& site) {
  if (std::holds_alternative<LennardJonesLaw>(site.law)) return {};
  std::string id =
      std::string(name(site.law)) + ' ' + parameters(site.sigma, site.epsilon, site.law);
  if (const auto* tabulated = std::get_if<TabulatedLaw>(&site.law)) {
    const PotentialTable& table = *tabulated->table;
    for (std::size_t k = 0; k < table.intervals(); ++k)
      id += fmt::format(" {}", table.coefficients<double>()[4 * k]);
  }
  return id + ' ';
}

}  // namespace

std::string identity(const Config& config, const System& system,
                     std::initializer_list<double> numbers) {
  std::ostringstream id;
  id.precision(17);
  for (const auto& [molecule, count] : system.topology.parts) {
    id << molecule.name << ' ' << count << ' ';
    for (const Site& s : molecule.sites)
      id << s.r.x << ' ' << s.r.y << ' ' << s.r.z << ' ' << s.mass << ' ' << s.charge << ' '
         << s.sigma << ' ' << s.epsilon << ' ' << law_identity(s);
  }
  for (std::size_t i = 0; i < system.state.size(); ++i) {
    const Vec3<double> q = system.state.q[i];
    id << fmt::format("{:.9f} {:.9f} {:.9f} ", q.x, q.y, q.z);
  }
  const Vec3<double> edge = system.state.box.edge;
  id << edge.x << ' ' << edge.y << ' ' << edge.z << ' ';
  id << config.system.temperature << ' ' << config.system.seed << ' ';
  const ForceSettings& f = config.forces;
  id << static_cast<int>(f.truncation) << ' ' << static_cast<int>(f.electrostatics) << ' '
     << static_cast<int>(f.precision) << ' ' << f.cutoff << ' ' << f.switch_from << ' '
     << f.smoothness << ' ' << f.dielectric << ' ' << config.integrator.lambda;
  for (const double x : numbers) id << ' ' << x;
  if (f.electrostatics == Electrostatics::pme) id << " pme " << f.pme_accuracy;
  if (f.electrostatics == Electrostatics::damped_shifted_force) id << " damping " << f.damping;
  if (f.dispersion_correction) id << " dispersion";
  if (const std::string mixing = description(system.forces.mixing); !mixing.empty())
    id << ' ' << mixing;
  return id.str();
}

}  // namespace polhode
