// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/system/single_point.hpp"

#include <fmt/core.h>

#include "base/instruction_set.hpp"
#include "forces/pairs/overlap.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/measure/energy.hpp"
#include "run/quantity_lists.hpp"
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
  at_place(config.source, [&] { check_overlap(system.topology, system.state); });
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

Quantities quantities(const SinglePoint& p) {
  const auto energy = [](const char* key, double value, const char* doc, const char* label) {
    return Quantity{key, "kJ/mol", value, doc, label, "", "", 10};
  };
  Quantities terms, tensor_rows;
  for (const auto& [name, value] : p.terms)
    terms.push_back({name, "[kJ/mol]", value + 0.0, "", "  " + name, "", "", 10});
  std::vector<std::vector<double>> tensor;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> along = p.pressure_tensor[i];
    tensor.push_back({along.x, along.y, along.z});
    tensor_rows.push_back(
        {"", "bar", tensor.back(), "", fmt::format("  {}", "xyz"[i]), "", "", 10});
  }
  Quantities list = {
      {"molecules", "", p.system.topology.size(), "number of molecules", "molecules"},
      energy("van_der_waals", p.load.van_der_waals, "van der Waals energy", "van der Waals"),
      energy("coulomb", p.load.coulomb, "Coulomb energy", "Coulomb"),
      {"terms", "kJ/mol", terms.empty() ? Value() : Value(terms),
       "contributions to the Coulomb energy, and the dispersion correction"},
      energy("potential", p.load.potential(), "potential energy", "potential"),
      {"pressure", "bar", p.pressure(), "pressure", "pressure", "", "", 10},
      {"pressure_tensor", "bar", tensor, "pressure tensor"}};
  append(list, tensor_rows);
  list.push_back({"instruction_set", "", name(current_instruction_set()), "instruction set"});
  return list;
}

}  // namespace polhode
