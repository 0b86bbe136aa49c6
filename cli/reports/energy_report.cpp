// SPDX-License-Identifier: MIT
#include "energy_report.hpp"

#include <fmt/core.h>

namespace polhode::cli {

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

}  // namespace polhode::cli
