// SPDX-License-Identifier: MIT
// Energies and forces of pairs of atoms with other laws than Lennard-Jones, compared with mpmath:
// laws/make.py made laws/expected.json.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "instruction_sets.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;

// The models are read from their files and the forces come from the pair loops, so that everything
// between parameters and forces is included. Powers err by exponent times rounding, a few 1e-14 of
// a term, and attraction and repulsion cancel; the spline of argon errs by 5/384 h⁴ u⁗ with h =
// 0.002 nm and u⁗ some (40/nm)⁴ of the repulsion, 1e-6 of it, its force by 1/24 h³ u⁗/40, 1e-5.
TEST_CASE("energies and forces of all laws are those of their formulas") {
  const std::string folder = std::string(POLHODE_TEST_DATA) + "/laws/";
  const auto rows = nlohmann::json::parse(std::ifstream(folder + "expected.json"));
  for (const auto& row : rows) {
    const std::string first = row["first"], second = row["second"];
    const double r = row["r"], u = row["u"], f = row["f"];
    CAPTURE(first);
    CAPTURE(second);
    CAPTURE(r);
    Topology topology{{{read_molecule(first), 1}}};
    if (first == second)
      topology.parts.front().count = 2;
    else
      topology.parts.push_back({read_molecule(second), 1});
    State state(2, Box{{5, 5, 5}});
    state.q.set(1, {r, 0, 0});
    const bool table = first == "argon-ab-initio";
    for (const Precision precision : {Precision::double_precision, Precision::mixed})
      for_each_instruction_set([&] {
        ForceSettings settings{.cutoff = 1.5, .switch_from = 1.4};
        settings.precision = precision;
        ForceField forces(topology, settings, state.box);
        Load load;
        forces(state, load);
        // Float rounds r by 2⁻²⁴, to which a power of 43 responds 43 times.
        const double rounding = precision == Precision::mixed ? 2e-5 : 1e-12;
        const double scale = std::abs(u) + std::abs(f) * r;  // of repulsion and attraction
        CHECK(std::abs(load.van_der_waals - u) < (rounding + (table ? 1e-6 : 0)) * scale);
        CHECK(std::abs(load.f[1].x - f) < (rounding + (table ? 1e-5 : 0)) * 10 * scale / r);
        CHECK(std::abs(load.virial[0][0] - r * load.f[1].x) < 1e-6 * scale);
      });
  }
}
