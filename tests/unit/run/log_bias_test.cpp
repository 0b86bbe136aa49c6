// SPDX-License-Identifier: MIT
// The time-step bias from logs: series with a known covariance, and logs as other programs write
// them.
#include "run/bias/log_bias.hpp"

#include <doctest/doctest.h>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

constexpr double kT = units::boltzmann * 300;  // [kJ/mol]

/// A correlated Gaussian series of variance 1 whose correlation decays with `time` samples.
class Correlated {
 public:
  explicit Correlated(double time) : keep_(std::exp(-1 / time)) {}
  double next(Random& random) {
    value_ = started_ ? keep_ * value_ + std::sqrt(1 - keep_ * keep_) * random.normal()
                      : random.normal();
    started_ = true;
    return value_;
  }

 private:
  double keep_, value_ = 0;
  bool started_ = false;
};

/// A log with cov(potential, total) = `covariance`, a line through the total energy, and a kinetic
/// energy for which the heat capacity is three times its kinetic part.
EngineLog made_up(std::uint64_t seed, int samples, double covariance, double slowness = 60) {
  Random random(seed);
  Correlated fast(8), slow(slowness);
  EngineLog log{"made up",
                "CSV file",
                {{"time", "ps", {}},
                 {"total", "kJ/mol", {}},
                 {"potential", "kJ/mol", {}},
                 {"temperature", "K", {}}},
                1,
                {}};
  constexpr double kinetic = 900,
                   spread = std::sqrt(2.0 / 3 * kT * kinetic);  // var(U) = kT K (1 - 1/3)
  for (int k = 0; k < samples; ++k) {
    const double e = fast.next(random);
    const double potential =
        covariance * e + std::sqrt(spread * spread - covariance * covariance) * slow.next(random);
    log.columns[0].values.push_back(0.01 * k);
    log.columns[1].values.push_back(kinetic - 5000 + e + 1e-3 * (k - samples / 2));
    log.columns[2].values.push_back(potential - 5000);
    log.columns[3].values.push_back(300);
  }
  return log;
}

const ColumnBias& column(const LogBias& b, const std::string& name) {
  for (const ColumnBias& c : b.columns)
    if (c.name == name) return c;
  throw Error("no column " + name);
}

// 400 rows like those of LAMMPS in units real, of the same made-up energies.
std::string lammps_log(const EngineLog& of, const std::string& head = "units           real\n") {
  std::string text = "LAMMPS (22 Jul 2025)\n" + head +
                     "Per MPI rank memory allocation (min/avg/max) = 3 | 3 | 3 Mbytes\n   Step     "
                     "     Temp          PotEng         TotEng    \n";
  for (std::size_t k = 0; k < of.samples(); ++k)
    text += fmt::format("{:7d} {:14.6f} {:14.8f} {:14.8f}\n", k, of.columns[3].values[k],
                        of.columns[2].values[k] / 4.184, of.columns[1].values[k] / 4.184);
  return text +
         "Loop time of 1.2 on 1 procs for 400 steps with 500 atoms\n\nPerformance: 3 ns/day\n";
}

}  // namespace

TEST_CASE("the bias of a log is the covariance with the total energy over kT") {
  constexpr double covariance = 2;
  int outside = 0, outside_corrected = 0;
  constexpr int seeds = 1000;
  for (int seed = 0; seed < seeds; ++seed) {
    const LogBias b = log_bias(made_up(static_cast<std::uint64_t>(seed), 4000, covariance), {});
    const SeriesEstimate& bias = column(b, "potential").bias;
    REQUIRE(bias.known == Known::yes);
    if (std::abs(bias.value - covariance / kT) > interval_factor(bias, 0.99) * bias.error)
      ++outside;
    const SeriesEstimate& corrected = column(b, "potential").corrected;
    if (std::abs(corrected.value + 5000 + covariance / kT) >
        interval_factor(corrected, 0.99) * corrected.error)
      ++outside_corrected;
  }
  // 10 of 1000 expected; the binomial distribution gives fewer than 2 or more than 21 in 0.1 %.
  CAPTURE(outside);
  CHECK(outside >= 2);
  CHECK(outside <= 21);
  CHECK(outside_corrected >= 2);
  CHECK(outside_corrected <= 21);
}

TEST_CASE(
    "at constant temperature the bias of the potential energy is larger by the ratio of the heat "
    "capacities") {
  double sum = 0, square = 0;
  constexpr int seeds = 30, samples = 40'000;
  for (int seed = 0; seed < seeds; ++seed) {
    const LogBias b = log_bias(made_up(static_cast<std::uint64_t>(seed), samples, 2, 10), {});
    const double ratio = b.at_constant_temperature->value / column(b, "potential").bias.value;
    sum += ratio;
    square += ratio * ratio;
  }
  const double mean = sum / seeds, error = std::sqrt((square / seeds - mean * mean) / seeds);
  CAPTURE(mean);
  CAPTURE(error);
  // C/C_K = 1/(1 − x) = 3, with x = 2/3. A finite run lowers x by 2 τ/n = 0.05 %, and so the ratio
  // by 0.3 %. The variance of x, 4 τ/n x² = 0.0004, raises the ratio by 0.0004/(1 − x)² of 3, 0.4
  // %.
  CHECK(std::abs(mean - 3) < 4 * error + 3 * (0.003 + 0.004));
  // 3 · 0.021/(1 − x) = 0.19 of one run.
  CHECK(error * std::sqrt(seeds) < 2 * 0.19);
}

TEST_CASE("logs of other programs give the same bias in their units") {
  const EngineLog made = made_up(1, 400, 2);
  const SeriesEstimate expected = column(log_bias(made, {}), "potential").bias;
  SUBCASE("LAMMPS") {
    const EngineLog log = parse_engine_log(lammps_log(made), "log.lammps");
    CHECK(log.format == "LAMMPS log");
    CHECK(log.samples() == 400);
    const LogBias b = log_bias(log, {});
    CHECK(b.energy_unit == "kcal/mol");
    CHECK(log.find({"Temp"})->unit == "K");
    CHECK(b.R > 0);
    CHECK(column(b, "PotEng").bias.value * 4.184 == doctest::Approx(expected.value).epsilon(1e-6));
    CHECK(column(b, "PotEng").bias.error * 4.184 == doctest::Approx(expected.error).epsilon(1e-5));
  }
  SUBCASE("LAMMPS with energies per atom") {
    const EngineLog log =
        parse_engine_log(lammps_log(made, "units real\nthermo_modify norm yes\n"), "log.lammps");
    CHECK(log.divisor == 500);
    CHECK(column(log_bias(log, {}), "PotEng").bias.value * 4.184 ==
          doctest::Approx(500 * expected.value).epsilon(1e-6));
  }
  SUBCASE("the last of several runs of LAMMPS") {
    const EngineLog other = made_up(2, 30, 2);
    const EngineLog log = parse_engine_log(lammps_log(other) + lammps_log(made, ""), "log.lammps");
    CHECK(log.samples() == 400);
    REQUIRE(log.notes.size() == 1);
    CHECK(log.notes[0] == "the log has 2 runs; the last one is used");
  }
  SUBCASE("xvg") {
    std::string text =
        "# gmx energy\n@    title \"GROMACS Energies\"\n@    xaxis  label \"Time (ps)\"\n@    "
        "yaxis  label \"(kJ/mol), (K)\"\n@TYPE xy\n@ s0 legend \"Potential\"\n@ s1 legend \"Total "
        "Energy\"\n@ s2 legend \"Temperature\"\n";
    for (std::size_t k = 0; k < made.samples(); ++k)
      text += fmt::format("{:12.6f} {:14.8f} {:14.8f} {:10.4f}\n", made.columns[0].values[k],
                          made.columns[2].values[k], made.columns[1].values[k], 300.0);
    const LogBias b = log_bias(parse_engine_log(text, "energy.xvg"), {});
    CHECK(b.energy_unit == "kJ/mol");
    CHECK(column(b, "Potential").bias.value == doctest::Approx(expected.value).epsilon(1e-6));
    CHECK(b.notes.at(0).find("md-vv") != std::string::npos);
  }
  SUBCASE("OpenMM") {
    std::string text =
        "#\"Time (ps)\",\"Potential Energy (kJ/mole)\",\"Total Energy (kJ/mole)\",\"Temperature "
        "(K)\"\n";
    for (std::size_t k = 0; k < made.samples(); ++k)
      text += fmt::format("{},{},{},{}\n", made.columns[0].values[k], made.columns[2].values[k],
                          made.columns[1].values[k], 300.0);
    const LogBias b = log_bias(parse_engine_log(text, "openmm.csv"), {});
    CHECK(column(b, "Potential Energy").bias.value ==
          doctest::Approx(expected.value).epsilon(1e-9));
    const LogBias commented =
        log_bias(parse_engine_log("# written by me, 2024\n" + text.substr(1), "mine.csv"), {});
    CHECK(column(commented, "Potential Energy").bias.value ==
          doctest::Approx(expected.value).epsilon(1e-9));
  }
}

TEST_CASE("with a thermostat the conserved energy takes the place of the total energy") {
  EngineLog made = made_up(1, 4000, 15);
  for (std::size_t k = 0; k < made.samples(); ++k)
    made.columns[1].values[k] -= 1e-3 * (static_cast<double>(k) - 2000);
  const SeriesEstimate expected = column(log_bias(made, {}), "potential").bias;
  made.columns.push_back({"Conserved En.", "kJ/mol", made.columns[1].values});
  for (std::size_t k = 0; k < made.samples(); ++k)
    made.columns[1].values[k] += made.columns[2].values[k];
  const LogBias b = log_bias(made, {});
  CHECK(b.has_bath);
  CHECK(b.energy == "Conserved En.");
  CHECK(column(b, "potential").bias.value == expected.value);
  CHECK(!b.at_constant_temperature);
  CHECK(b.warnings.empty());
  // A temperature that follows the conserved energy has a bias, and so the bath is another one.
  for (std::size_t k = 0; k < made.samples(); ++k)
    made.columns[3].values[k] += 10 * made.columns[4].values[k];
  const LogBias other = log_bias(made, {});
  REQUIRE(other.warnings.size() == 1);
  CHECK(other.warnings[0].find("acts on single momenta") != std::string::npos);
}

TEST_CASE("the last brackets of a title contain the unit") {
  const EngineLog log = log_of_columns("made up", {"time [ps]", "LJ (SR) (kJ/mol)", "total"},
                                       {{0, 1}, {2, 3}, {4, 5}});
  CHECK(log.columns[1].name == "LJ (SR)");
  CHECK(log.columns[1].unit == "kJ/mol");
  CHECK(log.columns[2].unit.empty());
}

TEST_CASE("logs from which no bias follows are refused with the reason") {
  EngineLog made = made_up(1, 400, 2);
  SUBCASE("a thermostat, seen by the potential energy") {
    made.columns[1].values = made.columns[2].values;
    check_error([&] { log_bias(made, {}); }, {"thermostat or barostat changed the energy",
                                              "print the conserved energy", "constant energy"});
  }
  SUBCASE("too few digits") {
    for (double& e : made.columns[1].values) e = std::round(e / 10) * 10;
    check_error([&] { log_bias(made, {}); }, {"too few digits", "-dp"});
  }
  SUBCASE("an unknown column") {
    BiasRequest request;
    request.total = {"totl", "--total"};
    check_error([&] { log_bias(made, request); }, {"--total = \"totl\"", "did you mean 'total'"});
  }
  SUBCASE("no temperature") {
    made.columns.pop_back();
    check_error([&] { log_bias(made, {}); }, {"no temperature", "\"298 K\""});
  }
  SUBCASE("an unknown unit") {
    made.columns[1].unit = "erg";
    check_error([&] { log_bias(made, {}); }, {"'erg', which is not known", "energy unit"});
  }
  SUBCASE("a log of LAMMPS without the step") {
    check_error([] { parse_engine_log("LAMMPS (22 Jul 2025)\nTime Temp\n0 1\n", "log"); },
                {"thermo_style custom step"});
  }
  SUBCASE("an incomplete row") {
    check_error([] { parse_engine_log("time,total,potential\n1,2,3\n1,2\n", "a.csv"); },
                {"2 fields; it must have 3", "a.csv:3"});
  }
  SUBCASE("a total energy with a gap") {
    const EngineLog log =
        parse_engine_log("# made by hand\ntime,total,potential\n1,2,3\n2,,3\n", "a.csv");
    CHECK(log.columns.front().name == "time");
    check_error([&] { log_bias(log, {}); },
                {"no column has a known name", "empty fields are left out: total"});
  }
  SUBCASE("no rows") {
    check_error([] { parse_engine_log("", "a.csv"); }, {"no rows of energies"});
  }
  SUBCASE("a binary file") {
    check_error([] { read_engine_log("x.edr"); }, {"gmx energy"});
  }
}

TEST_CASE("logs whose units, names or rows contradict each other are refused") {
  EngineLog made = made_up(1, 400, 2);
  SUBCASE("two units") {
    made.columns[2].unit = "kcal/mol";
    check_error([&] { log_bias(made, {}); }, {"'potential' is in kcal/mol", "convert one of them"});
  }
  SUBCASE("a unit that contradicts the log") {
    BiasRequest request;
    request.energy_unit = {"kcal/mol", "--energy-unit"};
    check_error([&] { log_bias(made, request); }, {"contradicts the unit of 'total'", "kJ/mol"});
    request = {};
    request.total = {"total [eV]", "--total"};
    check_error([&] { log_bias(made, request); }, {"the unit of 'total' there is kJ/mol"});
  }
  SUBCASE("a temperature in degrees Celsius") {
    made.columns.back().unit = "C";
    check_error([&] { log_bias(made, {}); }, {"is in C", "298 K"});
  }
  SUBCASE("two columns of one name") {
    made.columns.push_back(made.columns[1]);
    check_error([&] { log_bias(made, {}); }, {"several columns are called 'total'"});
  }
  SUBCASE("rows that are not in the order of time") {
    std::swap(made.columns[0].values[5], made.columns[0].values[9]);
    check_error([&] { log_bias(made, {}); }, {"sort the rows by time"});
  }
  SUBCASE("few rows") {
    for (LogColumn& column : made.columns) column.values.resize(2);
    check_error([&] { log_bias(made, {}); }, {"the log has 2 rows", "at least 10"});
  }
}

TEST_CASE("a share of rounding in the energy is a warning") {
  EngineLog made = made_up(1, 4000, 2);
  for (double& e : made.columns[1].values) e = std::round(e / 0.6) * 0.6;
  const LogBias b = log_bias(made, {});
  // 0.6² / 12 of the variance 1 and the rounding itself: 2.9 %.
  REQUIRE(!b.warnings.empty());
  CHECK(b.warnings[0].find("rounding makes 3 %") != std::string::npos);
}
