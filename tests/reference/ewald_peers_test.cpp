// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "polhode/base/target.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/forces/mesh_choice.hpp"
#include "reference/peers_scene.hpp"

using namespace polhode;
using namespace peers;

namespace {

double rms_off(const Vec3Column& of, const json& exact) {
  double sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) sum += norm2(of[i] - vec3(exact[i]));
  return std::sqrt(sum / double(exact.size()));
}

void compare(const std::string& name) {
  const json file = read(name);
  const json from = file.contains("scene") ? read(file["scene"]) : file;
  const Scene scene = rebuild(from, {vec3(from["box"])});
  const json& r = file["results"][0];
  double charges = 0, arms2 = 0;
  for (const auto& part : scene.topology.parts)
    for (const Site& s : part.molecule.sites)
      if (s.charge != 0) charges += part.count, arms2 += part.count * norm2(s.r);
  const double N = scene.state.size(), F = r["rms_electric_force"];
  ForceSettings s{Truncation::site_switch, r["law"]["cutoff"], r["law"]["switch_from"], r["law"]["smoothness"], Electrostatics::ewald};
  for (auto [precision, accuracy] : {std::pair{Precision::full, 1e-3}, {Precision::full, 1e-4}, {Precision::full, 1e-5},{Precision::full, 1e-6},{Precision::full, 1e-7}, {Precision::mixed, 1e-4}}) {
    s.precision = precision, s.accuracy = accuracy, s.mesh.reset();
    ForceField forces(scene.topology, s, scene.state.box);
    Load load(scene.state.size());
    forces(scene.state, load);
    const double unit = accuracy * F;
    const auto& m = *forces.settings().mesh;
    std::printf("%s %g %s mesh %zu %d %d F/typ %.2f | f %.3f tau %.3f | lj %.1e | U %+.4f | trace %+.4f xyz", name.c_str(), accuracy, precision == Precision::mixed ? "mixed" : "", m.points[0], m.order, m.exponent, F / typical_force(scene.topology, scene.state.box),
      rms_off(load.f, r["force"]) / unit / std::sqrt(charges / N), rms_off(load.tau, r["torque"]) / unit / std::sqrt(arms2 / N + 1e-30),
      load.lennard_jones / r["energy"]["lennard_jones"].get<double>() - 1, (load.coulomb - r["energy"]["coulomb"].get<double>()) / unit / std::sqrt(charges),
      (load.virial[0][0] + load.virial[1][1] + load.virial[2][2] - [&] { double t = 0; for (int d = 0; d < 3; ++d) t += r["virial"]["coulomb"][d].get<double>() + r["virial"]["lennard_jones"][d].get<double>(); return t; }()) / unit / std::sqrt(charges));
    for (int d = 0; d < 3; ++d) std::printf(" %+.4f", (load.virial[d][d] - r["virial"]["coulomb"][d].get<double>() - r["virial"]["lennard_jones"][d].get<double>())/ unit / std::sqrt(charges));
    std::printf("\n");
    if (r.contains("dispersion") && accuracy == 1e-4) {
      s.dispersion_correction = true;
      ForceField f2(scene.topology, s, scene.state.box);
      const double d = r["dispersion"];
      std::printf("   tail %.10g %.10g\n", f2.constant_terms().dispersion, d);
      s.dispersion_correction = false;
    }
  }
}

}  // namespace

TEST_CASE("all") {
  for (const char* n : {"ewald-tip4p", "ewald-mixture", "ewald-nacl-spce", "ewald-co2", "ewald-benzene"}) compare(n);
}
