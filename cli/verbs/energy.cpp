// SPDX-License-Identifier: MIT
// polhode energy [FILE]: prints single-point energies, and the forces and torques on all bodies as
// CSV.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/run/simulation/system/single_point.hpp"

namespace polhode::cli {
namespace {

struct EnergyOptions : JobOptions {
  bool forces = false, gradient = false;
};

/// Prints forces and torques as CSV, with 17 digits for all numbers.
void print_loads(const SinglePoint& p) {
  fmt::print("body,molecule,fx,fy,fz,taux,tauy,tauz{}\n",
             p.derivative ? ",dfx,dfy,dfz,dtaux,dtauy,dtauz" : "");
  const auto print = [](const Vec3<double>& v) {
    fmt::print(",{:.17g},{:.17g},{:.17g}", v.x, v.y, v.z);
  };
  const System& system = p.system;
  for (std::size_t i = 0; i < system.state.size(); ++i) {
    fmt::print("{},{}", i + 1, system.topology.parts[system.bodies.part[i]].molecule.name);
    print(p.load.f[i]);
    print(p.load.tau[i]);
    if (p.derivative) {
      print(p.derivative->f[i]);
      print(p.derivative->tau[i]);
    }
    fmt::print("\n");
  }
}

int energy(const EnergyOptions& o) {
  const Callbacks notes{.message = [](const std::string& text) { log("{}\n", text); }};
  const SinglePoint point = single_point(o.config(), o.gradient, notes);
  const bool csv = o.forces || o.gradient;
  const std::string text =
      o.json ? json_text(quantities(point)) + "\n" : text_of(quantities(point));
  std::fputs(text.c_str(), csv ? stderr : stdout);
  if (csv) print_loads(point);
  return 0;
}

}  // namespace

Action energy_verb(Command& command) {
  auto o = std::make_shared<EnergyOptions>();
  o->declare_file(command);
  command.add_flag(
      "--forces", o->forces,
      "print force [kJ/mol/nm] and torque [kJ/mol] of every body as CSV; energies go to "
      "standard error");
  command.add_flag("--gradient", o->gradient,
                   "also print the directional derivative of force and torque along the "
                   "gradient-kick displacement (f/m, J^-1 S tau); implies --forces");
  command.add_flag("--json", o->json, "print the energies as JSON");
  return [o] { return energy(*o); };
}

}  // namespace polhode::cli
