// SPDX-License-Identifier: MIT
// The observables of a small trajectory compared with MDAnalysis and mdtraj, whose results are in
// analysis/expected.json; analysis/make.py made them.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../analysis_curves.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "run/analysis/analysis_summary.hpp"

using namespace polhode;

namespace {

const std::string analysis_data = std::string(POLHODE_TEST_DATA) + "/analysis/";

nlohmann::json expected() {
  return nlohmann::json::parse(std::ifstream(analysis_data + "expected.json"));
}

Analysis analysed() {
  AnalysisSettings settings;
  settings.window = 2;
  settings.pairs = {{"OW", "OW"}, {"OW", "HW"}, {"HW", "HW"}};
  settings.cutoff = 0.4;
  settings.bin = 0.02;
  const auto reader = open_frames(analysis_data + "spce24.gro");
  return analyze(*reader, {{{read_molecule("spce"), 24}}}, settings);
}

}  // namespace

// Counts are integers. Both programs store positions as floats, and half a unit in the last place
// of 0.96 nm is 3e-8 nm: none of about 10⁴ pairs may be that close to the edge of a bin of 0.02 nm,
// or it changes bins. MDAnalysis counts ordered pairs and normalizes by all of them except those
// within a molecule.
TEST_CASE("radial distributions equal those of MDAnalysis and mdtraj") {
  const AnalysisSummary a = summary(analysed(), {});
  const nlohmann::json numbers = expected();
  const char* names[] = {"OO", "OH", "HH"};
  const char* pairs[] = {"g OW-OW", "g OW-HW", "g HW-HW"};
  for (std::size_t p = 0; p < 3; ++p) {
    const std::vector<double> g = numbers["rdf"][names[p]];
    const std::vector<double> found = column(a, "rdf", pairs[p]);
    REQUIRE(g.size() == found.size());
    for (std::size_t k = 0; k < g.size(); ++k) {
      CAPTURE(names[p]);
      CAPTURE(k);
      CHECK(found[k] == doctest::Approx(g[k]).epsilon(1e-5));
    }
  }
  const std::vector<double> g = numbers["rdf_mdtraj_OO"];
  for (std::size_t k = 0; k < g.size(); ++k)
    CHECK(column(a, "rdf", "g OW-OW")[k] == doctest::Approx(g[k]).epsilon(1e-5));
}

// Positions in the file have six decimals, and the fitted centre differs by up to 1e-6 nm from that
// of the atoms; floats add a relative 3e-7. Displacements are 0.08 nm and more.
TEST_CASE("displacements and reorientation equal those of MDAnalysis") {
  const AnalysisSummary a = summary(analysed(), {});
  const nlohmann::json numbers = expected();
  const std::vector<double> msd = numbers["msd"];
  const std::vector<double> squared = column(a, "msd", "msd");
  for (std::size_t lag = 0; lag < msd.size(); ++lag)
    CHECK(squared[lag] == doctest::Approx(msd[lag]).epsilon(2e-5));
  // The error of a direction is 1e-6 nm / 0.06 nm.
  const auto P2 = [&](const char* name) { return column(a, "rotation", name)[1]; };
  CHECK(P2("P2 dipole") == doctest::Approx(double(numbers["P2"]["dipole"])).epsilon(1e-4));
  // The axis of the smallest moment of water is parallel to the line between its hydrogens.
  CHECK(P2("P2 axis 1") == doctest::Approx(double(numbers["P2"]["HH"])).epsilon(1e-4));
}

// Both use the formula for conducting boundary conditions. Charges and constants agree to six
// digits.
TEST_CASE("dielectric constant and density equal those of MDAnalysis and mdtraj") {
  const Analysis a = analysed();
  const nlohmann::json numbers = expected();
  const AnalysisSummary s = summary(a, {.temperature = 298, .surroundings_permittivity = tin_foil});
  const nlohmann::json found = numbers_of(s)["dielectric"]["constant"];
  const double constant =
      found.contains("unconverged_estimate") ? found["unconverged_estimate"] : found["value"];
  CHECK(constant == doctest::Approx(double(numbers["dielectric"]["MDAnalysis"])).epsilon(1e-5));
  CHECK(constant == doctest::Approx(double(numbers["dielectric"]["mdtraj"])).epsilon(1e-5));
  CHECK(a.conditions->density().value / units::gram_per_cm3 ==
        doctest::Approx(double(numbers["density"]) / 1000).epsilon(1e-6));
}
