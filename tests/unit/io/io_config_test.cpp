// SPDX-License-Identifier: MIT
#include "polhode/io/settings/config.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "io/settings/config_parts.hpp"

using namespace polhode;

namespace {

const std::string system_table =
    "[system]\nmolecules = [{ model = \"tip4p\", count = 2 }]\ndensity = \"1 g/cm3\"\n";

// The lines of `more` begin at line 4.
void check_config(const std::string& more, std::initializer_list<const char*> parts) {
  check_error([&] { parse_config(system_table + more, "water.toml"); }, parts);
}
void check_system(const std::string& lines, std::initializer_list<const char*> parts) {
  check_error([&] { parse_config("[system]\n" + lines, "water.toml"); }, parts);
}
const std::string two = "molecules = [{ model = \"tip4p\", count = 2 }]\n";

}  // namespace

TEST_CASE("the default run is the paper's system") {
  const Config config = default_config();
  CHECK(config.source == "default");
  CHECK(config.system.molecules.front().model == "tip4p");
  CHECK(config.system.molecules.front().count == 512);
  CHECK(config.system.initial_configuration == "w512");
  CHECK(config.system.temperature == 297);
  CHECK(config.integrator.scheme == "hoa2");
  CHECK(config.integrator.step == 4 * 1e-3);
  CHECK(config.run.length == 15);
  CHECK(config.forces.switch_from == 0.85);
}

namespace {

// Values that differ from the defaults.
constexpr const char* all_tables = R"([system]
molecules = [{ model = "tip4p", count = 100 }]
box = ["3 nm", "3 nm", "40 A"]
temperature = "310 K"
seed = 7
[forces]
truncation = "site-switch"
cutoff = "1.2 nm"
switch = "1.1 nm"
smoothness = 3
mixing = "geometric"
dielectric = "infinite"
skin = "0.2 nm"
[integrator]
scheme = "gier4"
step = "5 fs"
lambda = 1e-3
[run]
equilibrate = "1 ps"
length = "2 ns"
sample = "10 fs"
[output]
prefix = "a/b"
trajectory_every = "1 ps"
formats = ["gro"]
plot = "png"
[study]
schemes = ["hoa2"]
steps = ["1 fs", "2 fs"]
runs = 3
length = "4 ps"
decorrelate = "5 ps"
configurational_sample = "40 fs"
[[pair]]
sites = ["tip4p.OW", "tip4p.OW"]
sigma = "0.3 nm"
epsilon = "100 K"
)";

}  // namespace

TEST_CASE("every key of a system and its forces is read") {
  const Config config = parse_config(all_tables, "x.toml");
  CHECK(config.system.box->z == 4);
  CHECK(config.system.temperature == 310);
  CHECK(config.system.seed == 7);
  CHECK(config.forces.truncation == Truncation::site_switch);
  CHECK(config.forces.cutoff == 1.2);
  CHECK(config.forces.switch_from == 1.1);
  CHECK(config.forces.smoothness == 3);
  CHECK(config.forces.mixing.rule == MixingRule::geometric);
  CHECK(config.forces.mixing.pairs.front().sigma == 0.3);
  CHECK(std::isinf(config.forces.dielectric));
  CHECK(config.forces.skin == 0.2);
}

TEST_CASE("every key of an integrator, a run, its output and a study is read") {
  const Config config = parse_config(all_tables, "x.toml");
  CHECK(config.integrator.scheme == "gier4");
  CHECK(config.integrator.step == 5 * 1e-3);
  CHECK(config.integrator.lambda == 1e-3);
  CHECK(config.run.equilibrate == 1);
  CHECK(config.run.length == 2000);
  CHECK(config.run.sample == 10 * 1e-3);
  CHECK(config.output.prefix == "a/b");
  CHECK(config.output.trajectory_every == 1);
  CHECK(config.output.formats == std::vector<std::string>{"gro"});
  CHECK(config.output.plot == "png");
  CHECK(config.study.schemes == std::vector<NamedScheme>{"hoa2"});
  CHECK(config.study.steps == std::vector<double>{1 * 1e-3, 2 * 1e-3});
  CHECK(config.study.runs == 3);
  CHECK(config.study.length == 4);
  CHECK(config.study.decorrelate == 5);
  CHECK(config.study.configurational_sample == doctest::Approx(0.04));
}

TEST_CASE("unknown keys and tables get suggestions") {
  check_config("[forces]\ncutof = \"1 nm\"",
               {"no key 'cutof' in forces; did you mean 'cutoff'?", "water.toml:5, forces.cutof"});
  check_config("[integratr]", {"no table 'integratr'; did you mean 'integrator'?", "water.toml:4"});
  check_config("[run]\nfoo = 1", {"no key 'foo' in run", "equilibrate, length, sample"});
}

TEST_CASE("invalid TOML is refused with its line") {
  check_config("[run", {"not TOML", "water.toml:4"});
  check_config("[run]\nlength = 2 ps", {"not TOML", "water.toml:5", "in quotes"});
  check_error([] { read_config("nowhere/water.toml"); }, {"no readable file 'nowhere/water.toml'"});
  check_error([] { read_config("/proc/self/mem"); },
              {"'/proc/self/mem' exists but cannot be read", "permissions"});
}

TEST_CASE("the system is described completely and without contradictions") {
  check_error([] { parse_config("", "water.toml"); }, {"no table [system]", "water.toml"});
  check_system("", {"there are no molecules", "model = \"tip4p\"", "water.toml:1, system"});
  check_system(two + "density = \"1 g/cm3\"\nbox = \"2 nm\"", {"with a box", "water.toml:3"});
  check_system(two + "density = \"1 g/cm3\"\ninitial_configuration = \"w512\"",
               {"density = \"1 g/cm3\" cannot be combined with an initial configuration"});
  check_system(two + "box = \"1 nm\"\ninitial_configuration = \"w512\"",
               {"box = \"1 nm\" cannot be combined with an initial configuration"});
  check_system(two + "box = 2.5", {"box = 2.5 has no unit", "\"2.5 nm\""});
  check_system(two + "box = [\"1 nm\", \"2 nm\"]", {"one edge or a list of three"});
  check_system(two + "box = [\"1 nm\", \"2 nm\", \"0 nm\"]", {"longer than 0 nm"});
  check_system(two + "box = [\"1 nm\", \"2 nm\", \"0 ps\"]", {"box[2]", "is a time"});
  check_system(two + "initial_configuration = \"nowhere.gro\"",
               {"initial_configuration = \"nowhere.gro\" is neither", "w512",
                "water.toml:3, system.initial_configuration"});
  check_system("molecules = [{ model = \"tip4p\" }]\nbox = \"2 nm\"", {"has no count"});
  check_system("molecules = [{ model = \"tip4p\", count = 0 }]\nbox = \"2 nm\"",
               {"count = 0 must be 1 or more", "system.molecules[0].count"});
  check_system("molecules = [{ count = 1 }]\nbox = \"2 nm\"", {"no model"});
  check_system("molecules = [{ model = \"tip4\", count = 1 }]\nbox = \"2 nm\"",
               {"no molecule 'tip4'; did you mean 'tip4p'?", "water.toml:2, system.molecules[0]"});
  check_system(
      "molecules = [{ model = \"tip4p\" }, { model = \"tip4p\" }]\ninitial_configuration = "
      "\"w512\"",
      {"several models"});
  check_system("molecules = 3\nbox = \"2 nm\"", {"must be a list of tables"});
  CHECK(parse_config(
            "[system]\nmolecules = [{ model = \"tip4p\" }]\ninitial_configuration = \"w512\"", "x")
            .system.molecules.front()
            .count == 0);
}

TEST_CASE("values of another kind or outside a domain of their own are refused with the domain") {
  check_config("temperature = \"0 K\"",
               {"temperature = \"0 K\" must be above 0 K", "water.toml:4"});
  check_config("temperature = 297", {"temperature = 297 has no unit", "\"297 K\""});
  check_config("[forces]\ncutoff = \"0.8 nm\"\nswitch = \"0.9 nm\"",
               {"switch = \"0.9 nm\" must be", "shorter than the cutoff, 0.8 nm"});
  check_config("[forces]\nsmoothness = 2.5", {"must be a whole number"});
  check_config(
      "[forces]\ntruncation = \"site-swich\"",
      {"must be one of: molecule-switch, site-switch, site-shift; did you mean 'site-switch'?"});
  check_config("[forces]\ndielectric = 80", {"no meaning without electrostatics"});
  check_config("[forces]\ntruncation = \"site-switch\"\ndielectric = nan", {"finite"});
  check_config("[integrator]\nstep = 2", {R"(step = 2 has no unit; write for example "2 fs")",
                                          "water.toml:5, integrator.step"});
  check_config("[integrator]\nscheme = \"\"", {"must name a scheme"});
  check_config("[run]\nlength = 15", {R"(write for example "15 ps")"});
  check_config("[output]\nformats = [\"xzy\"]", {"'xzy'; did you mean 'xyz'?"});
  check_config("[output]\nformats = \"xyz\"", {"must be a list of texts"});
  check_config("[output]\nplot = \"pdf\"", {"must be one of: svg, png, none"});
  check_config("[output]\nprefix = \"\"", {"must not be empty"});
  check_config("[study]\nsteps = [\"1 fs\", \"2\"]", {"has no unit", "study.steps"});
  check_config("[study]\nsteps = [\"0 fs\"]", {"longer than 0 fs"});
  check_config("[study]\nschemes = []", {"at least one scheme"});
  check_config("[integrator]\ncandidates = [\"gier5\"]", {"gier5", "integrator.candidates"});
}

TEST_CASE("the default of electrostatics depends on the truncation") {
  const auto electrostatics = [](const std::string& forces) {
    return parse_config(system_table + "[forces]\n" + forces, "x").forces.electrostatics;
  };
  using enum Electrostatics;
  CHECK(electrostatics("") == coulomb);
  CHECK(electrostatics("truncation = \"site-switch\"") == reaction_field);
  CHECK(electrostatics("truncation = \"site-shift\"") == reaction_field);
  CHECK(electrostatics("truncation = \"site-shift\"\nelectrostatics = \"coulomb\"") == coulomb);
  CHECK(electrostatics("electrostatics = \"reaction-field\"\ndielectric = 80") == reaction_field);
  check_config("[forces]\nelectrostatics = \"reaction field\"",
               {"must be one of: coulomb, reaction-field, pme, damped-shifted-force; did you mean "
                "'reaction-field'?"});
  check_config(
      "[forces]\nelectrostatics = \"coulomb\"\ntruncation = \"site-switch\"\ndielectric = 80",
      {"no meaning without electrostatics", "water.toml:7, forces.dielectric"});
}

TEST_CASE("the damped shifted force has a damping, and a site switch for Lennard-Jones") {
  const std::string law = "[forces]\nelectrostatics = \"damped-shifted-force\"\n";
  const ForceSettings forces =
      parse_config(system_table + law + "damping = \"0.15 1/A\"\n", "x").forces;
  CHECK(forces.electrostatics == Electrostatics::damped_shifted_force);
  CHECK(forces.truncation == Truncation::site_switch);
  CHECK(forces.damping == doctest::Approx(1.5).epsilon(1e-15));
  check_config(law + "damping = \"5 1/nm\"", {"from 0 to 3 / cutoff = 3 1/nm"});
  check_config(law + "pme_accuracy = 1e-4", {"no meaning without electrostatics = \"pme\""});
}

TEST_CASE("a table of own schemes gives names to texts") {
  const std::string own = system_table + "[schemes]\nmine = \"b = 1/2; B(b) A(1) B(b)\"\n";
  const auto scheme = [&](const std::string& text) {
    return parse_config(own + "[integrator]\nscheme = \"" + text + "\"\n", "x").integrator.scheme;
  };
  CHECK(scheme("mine") == "mine: b = 1/2; B(b) A(1) B(b)");
  CHECK(scheme("hoa2") == "hoa2");
  CHECK(scheme("mine / mine x 2 within 0.5 nm") ==
        "mine: b = 1/2; B(b) A(1) B(b) / mine: b = 1/2; B(b) A(1) B(b) x 2 within 0.5 nm");
  CHECK(parse_config(own + "[study]\nschemes = [\"hoa2\", \"mine\"]\n", "x").study.schemes[1] ==
        "mine: b = 1/2; B(b) A(1) B(b)");
  check_config("[schemes]\nmine = \"B(1/2) A(1)\"", {"sum to 1", "schemes.mine"});
  check_config("[schemes]\nhoa2 = \"B(1) A(1)\"", {"built-in scheme", "schemes.hoa2"});
  check_config("[schemes]\nmine = 1", {"text in quotes", "schemes.mine"});
}

TEST_CASE("PME has an accuracy, and a site switch for Lennard-Jones") {
  const ForceSettings pme =
      parse_config(system_table + "[forces]\nelectrostatics = \"pme\"\npme_accuracy = 1e-5\n", "x")
          .forces;
  CHECK(pme.electrostatics == Electrostatics::pme);
  CHECK(pme.truncation == Truncation::site_switch);
  CHECK(pme.pme_accuracy == 1e-5);
  CHECK(!pme.dispersion_correction);
  CHECK(parse_config(system_table + "[forces]\ndispersion_correction = true", "x")
            .forces.dispersion_correction);
  const std::string with_pme = "[forces]\nelectrostatics = \"pme\"\n";
  check_config(with_pme + "pme_accuracy = \"high\"", {"forces.pme_accuracy", "number"});
  CHECK(!pme.coulomb_cutoff);
  CHECK(parse_config(system_table + with_pme + "coulomb_cutoff = \"0.7 nm\"", "x")
            .forces.coulomb_cutoff == 0.7);
  check_config("[forces]\ncoulomb_cutoff = \"0.7 nm\"",
               {"no meaning without electrostatics = \"pme\""});
  check_config("[forces]\npme_accuracy = 1e-5", {"no meaning without electrostatics = \"pme\""});
  check_config(with_pme + "dielectric = 80", {"no meaning without electrostatics"});
  check_config(with_pme + "truncation = \"molecule-switch\"",
               {"cannot be combined with electrostatics = \"pme\"", "use \"site-switch\"",
                "forces.truncation"});
  check_config("[forces]\ndispersion_correction = 1", {"must be true or false"});
  check_config("[forces]\ntruncation = \"site-shift\"\ndispersion_correction = true",
               {"shifts the potential at all distances"});
}

TEST_CASE("the mixing rule is read, and pairs are given by molecule and site") {
  const auto mixing = [](const std::string& more) {
    return parse_config(system_table + more, "x").forces.mixing;
  };
  const std::string pair = "[[pair]]\nsites = [\"tip4p.OW\", \"tip4p.OW\"]\n";
  const std::string numbers = "sigma = \"3.2 A\"\nepsilon = \"0.5 kJ/mol\"\n";
  CHECK(mixing("").rule == MixingRule::lorentz_berthelot);
  CHECK(mixing("[forces]\nmixing = \"lorentz-berthelot\"").rule == MixingRule::lorentz_berthelot);
  CHECK(mixing("[forces]\nmixing = \"geometric\"").rule == MixingRule::geometric);
  CHECK(mixing("").pairs.empty());
  const Mixing given = mixing(pair + numbers);
  REQUIRE(given.pairs.size() == 1);
  CHECK(given.pairs[0].first == "tip4p.OW");
  CHECK(given.pairs[0].second == "tip4p.OW");
  CHECK(given.pairs[0].sigma == doctest::Approx(0.32).epsilon(1e-15));
  CHECK(given.pairs[0].epsilon == 0.5);

  const Mixing other = mixing(
      pair +
      "law = \"buckingham\"\nA = \"1e6 kJ/mol\"\nB = \"37 1/nm\"\nC = \"6e-3 kJ/mol nm6\"\n");
  CHECK(other.pairs.at(0).law == ShortRangeLaw(BuckinghamLaw{1e6, 37, 6e-3}));

  check_config("[forces]\nmixing = \"geometrical\"",
               {"must be one of: lorentz-berthelot, geometric; did you mean 'geometric'?"});
  check_config("[[pair]]\n" + numbers, {"a pair has no sites", "water.toml:4, pair[0].sites"});
  check_config("[[pair]]\nsites = [\"tip4p.OW\"]\n" + numbers, {"must be two", "water.toml:5"});
  check_config("[[pair]]\nsites = \"tip4p.OW\"\n" + numbers, {"must be a list of texts"});
  check_config(pair + "sigma = \"3 A\"", {"a pair has no epsilon", "\"0.8 kJ/mol\""});
  check_config(pair + "epsilon = \"0 K\"", {"a pair has no sigma", "\"0.33 nm\""});
  check_config(pair + "sigma = 0.5", {"sigma = 0.5 has no unit", "water.toml:6, pair[0].sigma"});
  check_config(pair + "sigma = \"-3 A\"\nepsilon = \"0 K\"",
               {"sigma = \"-3 A\" must be 0 or more"});
  check_config(pair + "sigma = \"3 A\"\nepsilon = \"-1 K\"",
               {"epsilon = \"-1 K\" must be 0 or more"});
  check_config(pair + "sigma = \"0 A\"\nepsilon = \"1 K\"",
               {"needs both", "water.toml:5, pair[0]"});
  check_config(pair + numbers + "charge = \"1 e\"", {"there is no key 'charge' in pair[0]"});
  check_config("[[pair]]\nsites = [\"tip4.OW\", \"tip4p.OW\"]\n" + numbers,
               {"no site 'tip4.OW' in this system; did you mean 'tip4p.OW'?",
                "water.toml:5, pair[0].sites"});
  check_config("[[pair]]\nsites = [\"tip4p.OW\", \"tip4p.HW1\"]\n" + numbers,
               {"'tip4p.HW1' has no short-range potential"});
  check_config(pair + numbers + pair + numbers, {"is given twice", "water.toml:9, pair[1].sites"});
}

TEST_CASE("the default of lambda in mixed precision is 1") {
  const auto read = [](const std::string& more) { return parse_config(system_table + more, "x"); };
  const std::string mixed = "[forces]\nprecision = \"mixed\"\n";
  CHECK(read("").forces.precision == Precision::double_precision);
  CHECK(read("").integrator.lambda == 1e-4);
  CHECK(read("[forces]\nprecision = \"double\"").integrator.lambda == 1e-4);
  CHECK(read(mixed).forces.precision == Precision::mixed);
  CHECK(read(mixed).integrator.lambda == 1);
  CHECK(read(mixed + "[integrator]\nlambda = 0.1").integrator.lambda == 0.1);
  check_config(mixed + "[integrator]\nlambda = 0.09",
               {"lambda = 0.09 is below 0.1", "leave lambda out", "precision = \"double\"",
                "water.toml:7, integrator.lambda"});
  check_config("[forces]\nprecision = \"single\"", {"must be one of: double, mixed"});

  Config config = read("");  // an option instead of the key
  set_precision(config, Precision::mixed);
  CHECK(config.forces.precision == Precision::mixed);
  CHECK(config.integrator.lambda == 1);
  set_precision(config, Precision::double_precision);
  CHECK(config.forces.precision == Precision::double_precision);
  CHECK(config.integrator.lambda == 1e-4);
  Config given = read("[integrator]\nlambda = 1e-3");
  check_error([&] { set_precision(given, Precision::mixed); },
              {"lambda = 0.001 is below 0.1", "x:5, integrator.lambda"});
}

TEST_CASE("a run file truncated anywhere gives an error with its line, or is complete") {
  const std::string whole = default_config().text;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      parse_config(whole.substr(0, length), "water.toml");
    } catch (const Error& e) {
      CAPTURE(e.what());
      CHECK(e.where().find("water.toml") == 0);
    }
  }
}
