// SPDX-License-Identifier: MIT
// polhode energy [FILE]: single-point energies, and forces and torques on all bodies as CSV.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "option_values.hpp"
#include "polhode/run/simulation/single_point.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file;
  bool forces = false, gradient = false, json = false;
};

std::string text_of(const SinglePoint& p) {
  std::string text = fmt::format("molecules         {}\n", p.system.topology.size());
  text += fmt::format("van der Waals     {:.10g} kJ/mol\n", p.load.van_der_waals);
  text += fmt::format("Coulomb           {:.10g} kJ/mol\n", p.load.coulomb);
  for (const auto& [name, value] : p.terms)
    text += fmt::format("  {:<16}{:.10g} kJ/mol\n", name, value + 0.0);
  text += fmt::format("potential         {:.10g} kJ/mol\n", p.load.potential());
  text += fmt::format("pressure          {:.10g} bar\n", p.pressure());
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> row = p.pressure_tensor[i];
    text += fmt::format("  {}             {:14.6f} {:14.6f} {:14.6f} bar\n", "xyz"[i], row.x, row.y,
                        row.z);
  }
  return text;
}

void print_csv(const SinglePoint& p) {
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

int energy(const Options& o) {
  const Callbacks notes{.message = [](const std::string& text) { log("{}\n", text); }};
  const SinglePoint point = single_point(read_config_option(o.file), o.gradient, notes);
  const bool csv = o.forces || o.gradient;
  const std::string text = o.json ? single_point_json(point) + "\n" : text_of(point);
  std::fputs(text.c_str(), csv ? stderr : stdout);
  if (csv) print_csv(point);
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
