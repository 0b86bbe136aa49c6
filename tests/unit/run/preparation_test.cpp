// SPDX-License-Identifier: MIT
// From a composition to an equilibrated start, interrupted anywhere, and the run that starts from
// it.
#include "polhode/run/prepare/preparation.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "../errors.hpp"
#include "../folder.hpp"
#include "base/version.hpp"
#include "io/settings/ensemble_names.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run/prepare/compressibility.hpp"
#include "run/simulation/files/checkpoint.hpp"

using namespace polhode;

namespace {

constexpr const char* argon = R"([system]
molecules = [{ model = "argon", count = 64 }]
temperature = "90 K"
density = "1.3 g/cm3"
[forces]
cutoff = "0.5 nm"
[thermostat]
[barostat]
pressure = "10 bar"
[integrator]
scheme = "hoa2"
step = "5 fs"
[prepare]
nvt = "0.4 ps"
npt = "2 ps"
[output]
prefix = "out"
)";

Config config_in(const Folder& folder, const std::string& text = argon) {
  Config config = parse_config(text, folder / "argon.toml");
  config.output.prefix = folder / "out";
  return config;
}

std::string bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What a preparation writes for other programs, and its report.
std::string results(const Folder& folder, const PreparationReport& report) {
  const std::string json = json_text(quantities(report));
  return bytes(folder / "out-prepared.gro") +
         replaced(bytes(folder / "out-prepared.toml"), folder / "out", "out") +
         json.substr(0, json.find("\"files\"")) + json.substr(json.find("\"interrupted\""));
}

bool same_bits(const State& a, const State& b) {
  const auto same = [&](const auto& u, const auto& v) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!(u[i] == v[i])) return false;
    return true;
  };
  bool orientations = true;
  for (std::size_t i = 0; i < a.size(); ++i)
    orientations = orientations && a.orientation.w[i] == b.orientation.w[i] &&
                   a.orientation.x[i] == b.orientation.x[i] &&
                   a.orientation.y[i] == b.orientation.y[i] &&
                   a.orientation.z[i] == b.orientation.z[i];
  return orientations && a.box == b.box && same(a.q, b.q) && same(a.p, b.p) && same(a.ell, b.ell);
}

}  // namespace

TEST_CASE("a preparation that is interrupted anywhere resumes to the same bits") {
  const Folder whole;
  const std::string expected = results(whole, prepare(config_in(whole)));
  // The stop is asked for at each step: about 300 in NVT, 1000 in NPT.
  for (const int asked : {1, 60, 330, 700, 1100}) {
    CAPTURE(asked);
    const Folder folder;
    int times = 0;
    const PreparationReport part =
        prepare(config_in(folder), {}, {.stop = [&] { return ++times >= asked; }});
    CHECK_FALSE(part.properties);
    CHECK_FALSE(std::filesystem::exists(folder / "out-prepared.gro"));
    Workers workers(asked % 2 == 0 ? 1 : 2);
    const PreparationReport rest =
        prepare(config_in(folder), {.existing = ExistingFiles::resume}, {}, workers);
    CHECK(results(folder, rest) == expected);
  }
}

TEST_CASE("a preparation that has ended prints its summary again and leaves its files") {
  const Folder folder;
  const PreparationReport first = prepare(config_in(folder));
  check_error([&] { prepare(config_in(folder)); }, {"out-prepared.bin", "resume it", "start over"});
  std::ofstream(folder / "out-prepared.toml", std::ios::app) << "# edited\n";
  const std::string edited = bytes(folder / "out-prepared.toml");
  const PreparationReport again = prepare(config_in(folder), {.existing = ExistingFiles::resume});
  CHECK(json_text(quantities(again)) == json_text(quantities(first)));
  CHECK(bytes(folder / "out-prepared.toml") == edited);
  check_error(
      [&] {
        prepare(config_in(folder, replaced(argon, "npt = \"2 ps\"", "npt = \"3 ps\"")),
                {.existing = ExistingFiles::resume});
      },
      {"is from another run", "prepare.npt was 2 ps and is now 3 ps"});
}

TEST_CASE("runs of two preparations of one run file have different outputs") {
  const Folder folder;
  Config config = config_in(folder);
  config.output.prefix = folder / "second";
  prepare(config);
  CHECK(read_config(folder / "second-prepared.toml").output.prefix == folder / "second");
}

TEST_CASE("a run starts from the prepared state to the last bit") {
  const Folder folder;
  prepare(config_in(folder));
  const std::string checkpoint = folder / "out-prepared.bin";
  const State prepared = state_of_checkpoint(checkpoint, version());
  const Config config = read_config(folder / "out-prepared.toml");
  CHECK(same_bits(Simulation(config).state(), prepared));

  // Without the checkpoint the start has the digits of the coordinate file.
  Config rounded = config;
  rounded.system.checkpoint.clear();
  CHECK_FALSE(same_bits(Simulation(rounded).state(), prepared));

  // New velocities, the same positions.
  Config drawn = config;
  drawn.system.new_velocities = true;
  const Simulation simulation(drawn);
  CHECK(simulation.state().q[0] == prepared.q[0]);
  CHECK_FALSE(simulation.state().p[0] == prepared.p[0]);
}

TEST_CASE("the checkpoint of another configuration is refused, and so is one without any") {
  const Folder folder;
  prepare(config_in(folder));
  std::string text = bytes(folder / "out-prepared.toml");
  const std::string gro = bytes(folder / "out-prepared.gro");
  const auto first = gro.find('.', gro.find("Ar"));
  std::string moved = gro;
  moved[first + 2] = gro[first + 2] == '5' ? '4' : '5';  // by at least 0.01 nm
  std::ofstream(folder / "out-prepared.gro") << moved;
  check_error([&] { Simulation(read_config(folder / "out-prepared.toml")); },
              {"molecule 1 ", "0.002 nm", "leave the checkpoint out", "system.checkpoint"});
  check_error(
      [&] {
        parse_config(replaced(argon, "density", "checkpoint = \"out-prepared.bin\"\ndensity"),
                     folder / "run.toml");
      },
      {"initial_configuration", "there is no initial configuration", "system.checkpoint"});
  check_error(
      [&] { parse_config(replaced(text, "out-prepared.bin", "no.bin"), folder / "run.toml"); },
      {"is not a file", "no.bin"});
}

// 1 ps of NPT is half a time constant of the barostat, 40 ps are 80. At 10 bar argon with so short
// a cutoff boils in that time; 1000 bar keep it liquid. The value is tested with volumes of a known
// compressibility (compressibility_test.cpp).
TEST_CASE("the compressibility of a preparation is measured, or not known yet") {
  const double per_bar = unit("1/bar", Dimension::compressibility);
  const Folder folder, longer, other;
  const PreparationReport brief = prepare(config_in(folder));
  CHECK(brief.properties->compressibility.known != Known::yes);
  CHECK(brief.compressibility >= default_compressibility());
  CHECK(compressibility_text(brief.properties->compressibility, 1e-4 * per_bar) ==
        "not known yet; the barostat assumes 100 1e-6/bar");
  const PreparationReport report = prepare(
      config_in(longer, replaced(replaced(argon, "npt = \"2 ps\"", "npt = \"80 ps\""), "\"10 bar\"",
                                 "\"1000 bar\"\ntime_constant = \"0.5 ps\"")));
  const SeriesEstimate& found = report.properties->compressibility;
  REQUIRE(found.known == Known::yes);
  CHECK(compressibility_text(found, 0).find("1e-6/bar, from the fluctuations") !=
        std::string::npos);
  CHECK(report.compressibility == found.value);
  CHECK(read_config(longer / "out-prepared.toml").ensemble.barostat->compressibility ==
        doctest::Approx(found.value).epsilon(0.05));  // two digits
  const Config given = config_in(
      other, replaced(argon, "[integrator]", "compressibility = \"2e-4 1/bar\"\n[integrator]"));
  CHECK(prepare(given).compressibility == 0);
  const Config after = read_config(other / "out-prepared.toml");
  CHECK(after.ensemble.barostat->compressibility == doctest::Approx(2e-4 * per_bar));
}
