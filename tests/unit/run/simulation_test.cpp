// SPDX-License-Identifier: MIT
// A simulation as front ends use it: step by step in memory, or as a whole with its files.
#include "polhode/run/simulation/simulation.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "../errors.hpp"
#include "../folder.hpp"

using namespace polhode;

namespace {

constexpr const char* argon = R"([system]
molecules = [{ model = "argon", count = 32 }]
density = "0.9 g/cm3"
temperature = "150 K"
[forces]
cutoff = "0.65 nm"
[integrator]
scheme = "hoa2"
step = "5 fs"
[run]
equilibrate = "0.04 ps"
length = "0.2 ps"
sample = "10 fs"
[output]
plot = "none"
trajectory_every = "20 fs"
formats = ["xyz"]
checkpoint_every = "1000 s"
)";

/// 40 steps of 32 argon atoms, after 40 of equilibration.
Config config_in(const Folder& folder, const std::string& text = argon) {
  Config config = parse_config(text, "argon.toml");
  config.output.prefix = folder / "out";
  return config;
}

std::vector<double> numbers(const State& state) {
  std::vector<double> all{state.time};
  for (const auto* v : {&state.q, &state.p, &state.ell})
    for (const auto* column : {&v->x, &v->y, &v->z})
      for (const double x : column->values()) all.push_back(x);
  return all;
}

std::string bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A run's end, and its growing files.
struct Result {
  std::vector<double> state;
  std::string energies, trajectory;
  bool operator==(const Result&) const = default;
};

Result result_in(const Folder& folder, const Simulation& simulation) {
  return {numbers(simulation.state()), bytes(folder / "out-energies.csv"),
          bytes(folder / "out-trajectory.xyz")};
}

Result whole_run() {
  const Folder folder;
  Simulation simulation(config_in(folder));
  CHECK(simulation.run().end == RunEnd::complete);
  return result_in(folder, simulation);
}

}  // namespace

TEST_CASE("a simulation runs to its length, writes its files, and reports how it went") {
  const Folder folder;
  Simulation simulation(config_in(folder));
  std::vector<std::string> messages;
  std::vector<std::size_t> sampled;
  std::vector<Progress> progress;
  const RunResult result =
      simulation.run({ExistingFiles::refuse, "test"},
                     {.progress = [&](const Progress& now) { progress.push_back(now); },
                      .message = [&](const std::string& text) { messages.push_back(text); },
                      .sample =
                          [&](std::size_t step, const State& state, const Energies& energies) {
                            CHECK(state.time == energies.time);
                            sampled.push_back(step);
                          }});
  CHECK(result.end == RunEnd::complete);
  CHECK(simulation.steps() == 40);
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].find("32 molecules, argon.toml, hoa2 in 5 fs steps") != std::string::npos);
  REQUIRE(sampled.size() == 21);  // every second step, with that at the start
  CHECK(sampled.front() == 0);
  CHECK(sampled.back() == 40);
  CHECK(progress.front().job == "equilibrating");
  CHECK(progress.back().job == "running");
  CHECK(progress.back().done == 1);
  REQUIRE(result.report);
  const auto json = nlohmann::json::parse(run_json(*result.report));
  CHECK(json.at("steps") == 40);
  CHECK(json.at("samples") == 21);
  CHECK(json.at("interrupted") == false);
  CHECK(json.at("force_evaluations") == 80);  // two a step; that of the start is a measurement
  for (const auto& file : json.at("files"))
    if (file != json.at("files").back())  // there is no checkpoint before the last one
      CHECK(std::filesystem::exists(file.get<std::string>()));
  CHECK_FALSE(std::filesystem::exists(folder / "out-run.lock"));
}

TEST_CASE("existing outputs are refused, unless they are to be replaced") {
  const Folder folder;
  CHECK(Simulation(config_in(folder)).run().end == RunEnd::complete);
  const std::string energies = bytes(folder / "out-energies.csv");
  check_error([&] { Simulation(config_in(folder)).run(); },
              {"out-checkpoint.bin", "resume it", "start over"});
  std::filesystem::remove(folder / "out-checkpoint.bin");
  check_error([&] { Simulation(config_in(folder)).run(); },
              {"exists and would be overwritten", "delete the file"});
  CHECK(Simulation(config_in(folder)).run({.existing = ExistingFiles::replace}).end ==
        RunEnd::complete);
  CHECK(bytes(folder / "out-energies.csv") == energies);
}

// Interrupted at different moments: while equilibrating, at a sample, and between two.
TEST_CASE("an interrupted run resumes to the same bits") {
  const Result whole = whole_run();
  for (const int asked : {7, 41 + 6, 41 + 13}) {
    CAPTURE(asked);
    const Folder folder;
    int times = 0;
    Simulation first(config_in(folder));
    const RunResult interrupted = first.run({}, {.stop = [&] { return ++times == asked; }});
    CHECK(interrupted.end ==
          (asked < 41 ? RunEnd::interrupted_equilibrating : RunEnd::interrupted));
    CHECK(interrupted.report.has_value() == (asked > 41));
    if (interrupted.report) CHECK(interrupted.report->interrupted);
    CHECK(std::filesystem::exists(folder / "out-checkpoint.bin"));

    Simulation second(config_in(folder));
    const RunResult rest = second.run({.existing = ExistingFiles::resume});
    CHECK(rest.end == RunEnd::complete);
    CHECK(result_in(folder, second) == Result{whole});
  }
}

TEST_CASE("steps taken one by one are those of a run") {
  const Result whole = whole_run();
  const Folder folder;
  Simulation simulation(config_in(folder));
  for (const std::size_t steps : {1u, 1u, 5u, 20u}) {
    simulation.step(steps);
    CHECK(simulation.energies().time == simulation.state().time);  // leaves the trajectory as it is
  }
  CHECK(simulation.steps() == 27);
  CHECK(simulation.state().time == doctest::Approx(27 * 0.005));
  CHECK(simulation.summary().samples == 14);
  simulation.step(13);
  CHECK(numbers(simulation.state()) == whole.state);
  CHECK_FALSE(std::filesystem::exists(folder / "out-energies.csv"));
}

TEST_CASE("an equilibration that was interrupted resumes in memory") {
  const Folder folder;
  Simulation simulation(config_in(folder));
  int times = 0;
  CHECK_FALSE(simulation.equilibrate({.stop = [&] { return ++times == 33; }}));
  CHECK(simulation.equilibrate());
  simulation.step(40);
  CHECK(numbers(simulation.state()) == whole_run().state);
}

// A last sample between two intervals is taken at the end of a run only.
TEST_CASE("steps after a run continue it") {
  const std::string odd = replaced(argon, "0.2 ps", "0.135 ps");
  const Folder folder;
  Simulation simulation(config_in(folder, odd));
  CHECK(simulation.run().report->summary.samples == 15);  // 14, and the last one
  simulation.step(13);
  CHECK(simulation.steps() == 40);
  CHECK(simulation.summary().samples == 21);
  CHECK(numbers(simulation.state()) == whole_run().state);
}

TEST_CASE("a simulation saved after a run has no last sample either") {
  const Folder folder;
  Simulation first(config_in(folder, replaced(argon, "0.2 ps", "0.135 ps")));
  CHECK(first.run().report->summary.samples == 15);
  first.save(folder / "saved.bin");
  Simulation second(config_in(folder));
  second.resume(folder / "saved.bin");
  second.step(13);
  CHECK(second.summary().samples == 21);
  CHECK(numbers(second.state()) == whole_run().state);
}

TEST_CASE("a run continues from steps already taken") {
  const Folder folder;
  Simulation simulation(config_in(folder));
  simulation.step(15);
  const RunResult result =
      simulation.run({}, {.sample = [&](std::size_t, const State&, const Energies&) {
                       CHECK(std::filesystem::exists(folder / "out-checkpoint.bin"));
                     }});
  CHECK(result.end == RunEnd::complete);
  CHECK(result.report->summary.samples == 21);
  CHECK(numbers(simulation.state()) == whole_run().state);
  simulation.step(1);
  check_error([&] { simulation.run({.existing = ExistingFiles::replace}); },
              {"0.2 ps", "0.205 ps", "already simulated"});
}

TEST_CASE("a change of the step begins a segment, which a run with its files reports") {
  const Folder folder;
  Simulation simulation(config_in(folder));
  simulation.step(16);  // 80 fs
  Config to = simulation.config();
  to.integrator.step = 0.002;
  simulation.change(to.integrator, to.ensemble);
  CHECK(simulation.steps_left() == 60);  // the 120 fs that remain of 200 fs
  const RunResult result = simulation.run({ExistingFiles::refuse, "test"});
  CHECK(simulation.steps() == 76);
  CHECK(simulation.state().time == doctest::Approx(0.2).epsilon(1e-12));
  const auto json = nlohmann::json::parse(run_json(*result.report));
  CHECK(json.at("steps") == 60);
  CHECK(json.at("samples") == 13);  // every fifth step, with that at the start
  CHECK(json.at("force_evaluations") == 120);
  CHECK(json.at("segment").at("number") == 2);
  CHECK(json.at("segment").at("first_step") == 16);
  CHECK(json.at("segment").at("changes") == "integrator.step was 5 fs and is now 2 fs");
  CHECK(bytes(folder / "out-energies.csv")
            .find("# command: test (segment 2 from step 16: integrator.step was 5 fs and is now 2 "
                  "fs)") != std::string::npos);

  to.ensemble.hybrid_monte_carlo.emplace();
  check_error([&] { simulation.change(to.integrator, to.ensemble); }, {"hybrid Monte Carlo"});
  to.ensemble.hybrid_monte_carlo.reset();
  to.ensemble.temperature = 160;
  check_error([&] { simulation.change(to.integrator, to.ensemble); }, {"160 K", "constant energy"});
}

TEST_CASE("a saved simulation resumes to the same bits") {
  const Result whole = whole_run();
  const Folder folder;
  for (const std::size_t steps : {0u, 1u, 17u}) {  // before the equilibration, and after it
    CAPTURE(steps);
    Simulation first(config_in(folder));
    if (steps > 0) first.step(steps);
    first.save(folder / "saved.bin");
    Simulation second(config_in(folder));
    second.resume(folder / "saved.bin");
    CHECK(second.steps() == steps);
    CHECK(numbers(second.state()) == numbers(first.state()));
    second.step(40 - steps);
    CHECK(numbers(second.state()) == whole.state);
  }
  Simulation other(config_in(folder, replaced(argon, "150 K", "151 K")));
  check_error([&] { other.resume(folder / "saved.bin"); }, {"saved.bin", "another run"});
  check_error([&] { other.resume(folder / "none.bin"); }, {"none.bin"});
}

TEST_CASE("settings that do not fit are refused with their place") {
  const Folder folder;
  const auto refused = [&](const std::string& from, const std::string& to,
                           std::initializer_list<const char*> parts) {
    CAPTURE(to);
    check_error([&] { Simulation simulation(config_in(folder, replaced(argon, from, to))); },
                parts);
  };
  refused("0.2 ps", "0.001 ps",
          {"the step of 5 fs is longer than the length of 1 fs", "argon.toml"});
  refused("0.65 nm", "1.2 nm", {"argon.toml:6", "forces.cutoff"});
  check_error(
      [&] {
        Config config = config_in(folder);
        config.integrator.scheme = "gier4";
        config.run.shadow_sample = 0.01;
        Simulation simulation(config);
      },
      {"shadow_sample is 10 fs", "gier4", "argon.toml"});
  Simulation unchosen(config_in(folder, replaced(argon, "step = \"5 fs\"", "accuracy = \"1 %\"")));
  check_error([&] { unchosen.step(); }, {"1 %", "argon.toml", "choose"});
  check_error([&] { unchosen.summary(); }, {"no trajectory", "advance by at least one step"});
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a run that blows up says so and keeps its energies") {
  const Folder folder;
  Simulation simulation(
      config_in(folder, replaced(replaced(argon, "5 fs", "1 ps"), "0.2 ps", "20 ps")));
  std::vector<std::string> messages;
  CHECK_THROWS_AS(
      simulation.run({}, {.message = [&](const std::string& text) { messages.push_back(text); }}),
      RunError);
  CHECK(messages.back() ==
        "the energies before the blow-up are in " + (folder / "out-energies.csv"));
  CHECK_FALSE(simulation.resumable_step());
}

TEST_CASE("energies of a simulation contain the heat and work received so far") {
  const Folder folder;
  const std::string npt =
      std::string(argon) + "[thermostat]\n[barostat]\npressure = \"100 bar\"\nevery = \"20 fs\"\n";
  std::vector<Energies> sampled;
  Simulation whole(config_in(folder, npt));
  whole.run({}, {.sample = [&](std::size_t, const State&, const Energies& now) {
              sampled.push_back(now);
            }});
  CHECK(whole.energies().exchanged == sampled.back().exchanged);
  CHECK(whole.energies().exchanged != 0);

  Simulation steps(config_in(folder, npt));
  CHECK(steps.energies().exchanged == 0);
  steps.step(20);
  CHECK(steps.energies().exchanged == sampled[10].exchanged);
  // Potentials of a separate evaluation have another order of sums.
  CHECK(steps.energies().conserved() == doctest::Approx(sampled[10].conserved()).epsilon(1e-9));
  steps.save(folder / "after-20.bin");
  Simulation resumed(config_in(folder, npt));
  resumed.resume(folder / "after-20.bin");
  CHECK(resumed.energies().exchanged == sampled[10].exchanged);
}

TEST_CASE("a summary counts the force evaluations of moves of the box and of the minimisation") {
  const std::string npt = replaced(argon, "[run]\n", "[run]\nminimise = true\n") +
                          "[thermostat]\n[barostat]\npressure = \"100 bar\"\nevery = \"20 fs\"\n";
  const Folder folder;
  Simulation simulation(config_in(folder, npt));
  simulation.step(20);
  const RunSummary half = simulation.summary();
  CHECK(half.ensemble.barostat->moves == 5);
  CHECK(half.ensemble.barostat->evaluations == 5);
  CHECK(half.minimisation_evaluations >= 1);
  simulation.save(folder / "half.bin");
  Simulation resumed(config_in(folder, npt));
  resumed.resume(folder / "half.bin");
  resumed.step(20);
  const RunSummary all = resumed.summary();
  CHECK(all.ensemble.barostat->evaluations == 10);
  CHECK(all.minimisation_evaluations == half.minimisation_evaluations);
  CHECK(all.force_evaluations == 80);  // of the scheme alone
}

// Velocity Verlet cannot follow a collision of argon atoms in so long a step: the energy it makes
// is finite, and beyond all that dynamics at constant energy, or a bath between two samples, can
// give.
TEST_CASE("a resumed run knows the minimisation that came before it in memory") {
  const Folder folder;
  const Config config = config_in(folder, replaced(argon, "[run]\n", "[run]\nminimise = true\n"));
  Simulation in_memory(config);
  CHECK(in_memory.step(4));
  const std::uint64_t minimisation = in_memory.summary().minimisation_evaluations;
  CHECK(minimisation > 0);
  std::size_t samples = 0;
  const auto some = [&] { return ++samples > 10; };
  CHECK(in_memory.run({ExistingFiles::refuse}, {.stop = some}).end == RunEnd::interrupted);
  Simulation resumed(config);
  const RunResult result = resumed.run({ExistingFiles::resume});
  REQUIRE(result.report);
  CHECK(result.report->summary.minimisation_evaluations == minimisation);
}

TEST_CASE("a run whose energy explodes ends at the sample that shows it") {
  std::string text = argon;
  const auto change = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change("hoa2", "velocity-verlet");
  change("\"5 fs\"", "\"120 fs\"");
  change("0.04 ps", "0 ps");
  change("0.2 ps", "1000 ps");
  change("sample = \"10 fs\"", "sample = \"120 fs\"");
  Simulation alone(parse_config(text, "argon.toml"));
  CHECK_THROWS_WITH_AS(alone.step(8000), doctest::Contains("the total energy changed from"),
                       RunError);
  Simulation in_bath(parse_config(text + "[thermostat]\ntype = \"langevin\"\n", "argon.toml"));
  CHECK_THROWS_WITH_AS(in_bath.step(8000), doctest::Contains("between two samples"), RunError);
}
