// SPDX-License-Identifier: MIT
// polhode energy [FILE]: single-point energies, and forces and torques on all bodies as CSV.
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/instruction_set.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/system.hpp"
#include "system_notes.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file;
  bool forces = false, gradient = false, json = false;
};

/// The terms of the energy besides the sums over pairs within the cutoff [kJ/mol].
std::vector<std::pair<std::string, double>> terms_of(const ForceField& forces, const Load& load) {
  const ConstantTerms& constant = forces.constant_terms();
  std::vector<std::pair<std::string, double>> terms;
  if (forces.settings().dispersion_correction) terms.emplace_back("LJ tail", constant.dispersion);
  const bool mesh = forces.settings().mesh.has_value();
  if (!mesh && constant.self == 0) return terms;
  terms.emplace_back(mesh ? "real space" : "pairs", load.coulomb - load.mesh - constant.coulomb());
  if (mesh) terms.emplace_back("mesh", load.mesh);
  terms.emplace_back("self", constant.self);
  terms.emplace_back("intramolecular", constant.intramolecular);
  if (mesh) terms.emplace_back("background", constant.background);
  return terms;
}

void print_csv(const System& system, const Load& load, const Load* slope) {
  fmt::print("body,molecule,fx,fy,fz,taux,tauy,tauz{}\n",
             slope ? ",dfx,dfy,dfz,dtaux,dtauy,dtauz" : "");
  const auto print = [](const Vec3<double>& v) {
    fmt::print(",{:.17g},{:.17g},{:.17g}", v.x, v.y, v.z);
  };
  for (std::size_t i = 0; i < system.state.size(); ++i) {
    fmt::print("{},{}", i + 1, system.topology.parts[system.bodies.part[i]].molecule.name);
    print(load.f[i]);
    print(load.tau[i]);
    if (slope) {
      print(slope->f[i]);
      print(slope->tau[i]);
    }
    fmt::print("\n");
  }
}

int energy(const Options& o) {
  const Config config = o.file.empty() ? default_config() : read_config(o.file);
  const System system = build_system(config);
  note_molecules(system);
  note_forces(system);
  ForceField forces(system.topology, system.forces, system.state.box);
  Load load;
  forces(system.state, load);

  const Mat3<double> pressure = pressure_tensor(system.state, system.bodies, load);
  const double bar = unit("bar", Dimension::pressure);
  const auto tensor = [&](std::size_t i, std::size_t k) { return pressure[i][k] / bar; };
  nlohmann::json terms, tensor_json;
  for (const auto& [name, value] : terms_of(forces, load)) terms[name] = value;
  for (std::size_t i = 0; i < 3; ++i)
    tensor_json.push_back({tensor(i, 0), tensor(i, 1), tensor(i, 2)});
  std::string text;
  if (o.json) {
    text += fmt::format(
        "{}\n", nlohmann::json{{"molecules", system.topology.size()},
                               {"lennard_jones_kJ_per_mol", load.lennard_jones},
                               {"coulomb_kJ_per_mol", load.coulomb},
                               {"terms_kJ_per_mol", terms},
                               {"potential_kJ_per_mol", load.potential()},
                               {"pressure_tensor_bar", tensor_json},
                               {"pressure_bar", (tensor(0, 0) + tensor(1, 1) + tensor(2, 2)) / 3},
                               {"instruction_set", name(current_instruction_set())}}
                    .dump(2));
  } else {
    text += fmt::format("molecules         {}\n", system.topology.size());
    text += fmt::format("Lennard-Jones     {:.17g} kJ/mol\n", load.lennard_jones);
    text += fmt::format("Coulomb           {:.17g} kJ/mol\n", load.coulomb);
    for (const auto& [name, value] : terms_of(forces, load))
      text += fmt::format("  {:<16}{:.17g} kJ/mol\n", name, value + 0.0);
    text += fmt::format("potential         {:.17g} kJ/mol\n", load.potential());
    text += fmt::format("pressure          {:.10g} bar\n",
                        (tensor(0, 0) + tensor(1, 1) + tensor(2, 2)) / 3);
    for (std::size_t i = 0; i < 3; ++i)
      text += fmt::format("  {}             {:14.6f} {:14.6f} {:14.6f} bar\n", "xyz"[i],
                          tensor(i, 0), tensor(i, 1), tensor(i, 2));
  }
  std::fputs(text.c_str(), o.forces || o.gradient ? stderr : stdout);
  if (!o.forces && !o.gradient) return 0;
  if (!o.gradient) {
    print_csv(system, load, nullptr);
    return 0;
  }
  Vec3Column dq, dtheta;
  gradient_direction(system.state, system.bodies, load, dq, dtheta);
  Load slope;
  forces.directional_derivative(system.state, dq, dtheta, slope);
  print_csv(system, load, &slope);
  return 0;
}

}  // namespace

Action energy_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_flag("--forces", o->forces,
               "print force [kJ/mol/nm] and torque [kJ/mol] of every body as CSV; energies go to "
               "standard error");
  app.add_flag("--gradient", o->gradient,
               "add the directional derivative of force and torque along the displacement (f/m, "
               "J^-1 S tau) of the gradient kick; implies --forces");
  app.add_flag("--json", o->json, "print the energies as JSON");
  return [o] { return energy(*o); };
}

}  // namespace polhode::cli
