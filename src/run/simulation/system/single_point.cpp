// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/system/single_point.hpp"

#include <nlohmann/json.hpp>

#include "base/instruction_set.hpp"
#include "forces/pairs/overlap.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/measure/energy.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

std::vector<std::pair<std::string, double>> terms_of(const ForceField& forces, const Load& load) {
  const ConstantTerms& constant = forces.constant_terms();
  std::vector<std::pair<std::string, double>> terms;
  if (forces.settings().dispersion_correction)
    terms.emplace_back("dispersion tail", constant.dispersion);
  const bool mesh = forces.settings().mesh.has_value();
  if (!mesh && constant.self == 0) return terms;
  terms.emplace_back(mesh ? "real space" : "pairs", load.coulomb - load.mesh - constant.coulomb());
  if (mesh) terms.emplace_back("mesh", load.mesh);
  terms.emplace_back("self", constant.self);
  terms.emplace_back("intramolecular", constant.intramolecular);
  if (mesh) terms.emplace_back("background", constant.background);
  return terms;
}

}  // namespace

double SinglePoint::pressure() const {
  const Mat3<double>& P = pressure_tensor;
  return (P[0][0] + P[1][1] + P[2][2]) / 3;
}

SinglePoint single_point(const Config& config, bool derivative, const Callbacks& callbacks) {
  SinglePoint point{build_system(config), {}, {}, {}, {}};
  const System& system = point.system;
  try {
    check_overlap(system.topology, system.state);
  } catch (const Error& e) {
    throw e.at(config.source);
  }
  note_molecules(system, callbacks);
  note_forces(system, callbacks);
  ForceField forces(system.topology, system.forces, system.state.box);
  forces(system.state, point.load);
  point.terms = terms_of(forces, point.load);
  const double bar = unit("bar", Dimension::pressure);
  const Mat3<double> pressure = pressure_tensor(system.state, system.bodies, point.load);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) point.pressure_tensor[i][k] = pressure[i][k] / bar;
  if (!derivative) return point;
  Vec3Column dq, dtheta;
  gradient_direction(system.state, system.bodies, point.load, dq, dtheta);
  point.derivative.emplace();
  forces.directional_derivative(system.state, dq, dtheta, *point.derivative);
  return point;
}

std::string single_point_json(const SinglePoint& point) {
  nlohmann::json terms, tensor;
  for (const auto& [name, value] : point.terms) terms[name] = value;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> row = point.pressure_tensor[i];
    tensor.push_back({row.x, row.y, row.z});
  }
  return nlohmann::json{{"molecules", point.system.topology.size()},
                        {"van_der_waals_kJ_per_mol", point.load.van_der_waals},
                        {"coulomb_kJ_per_mol", point.load.coulomb},
                        {"terms_kJ_per_mol", terms},
                        {"potential_kJ_per_mol", point.load.potential()},
                        {"pressure_tensor_bar", tensor},
                        {"pressure_bar", point.pressure()},
                        {"instruction_set", name(current_instruction_set())}}
      .dump(2);
}

}  // namespace polhode
