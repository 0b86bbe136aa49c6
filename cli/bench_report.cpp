// SPDX-License-Identifier: MIT
#include "bench_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "polhode/base/instruction_set.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/base/version.hpp"
#include "polhode/forces/laws/setting_names.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/output_units.hpp"

namespace polhode::cli {
namespace {

using nlohmann::json;

constexpr double noisy = 0.1;  // a spread above which the user is warned

std::string threads_text(int n) { return fmt::format("{} thread{}", n, n == 1 ? "" : "s"); }

/// A time with three digits and a unit.
std::string duration(double seconds) {
  const double us = units::us_per_s * seconds;
  return us < 1000  ? fmt::format("{:.3g} µs", us)
         : us < 1e6 ? fmt::format("{:.3g} ms", us / 1e3)
                    : fmt::format("{:.3g} s", seconds);
}

double percent(double x) { return 100 * x; }

double share(const EvaluationTiming& e, int threads) {
  return e.arithmetic / threads / e.forces.best;
}

double non_force_share(const StepTiming& s) { return 1 - s.forces / s.all.best; }

/// The systems of one size.
std::vector<SystemTiming> of_size(const Benchmark& b, std::size_t molecules) {
  std::vector<SystemTiming> found;
  for (const SystemTiming& s : b.systems)
    if (s.molecules == molecules) found.push_back(s);
  return found;
}

std::vector<std::size_t> sizes(const Benchmark& b) {
  std::vector<std::size_t> found;
  for (const SystemTiming& s : b.systems)
    if (found.empty() || found.back() != s.molecules) found.push_back(s.molecules);
  return found;
}

void print_limits(const std::vector<Limit>& limits) {
  const auto row = [&](const char* text, const auto& value) {
    fmt::print("{:<40}", text);
    for (const Limit& limit : limits) fmt::print("{:>10.4g}", static_cast<double>(value(limit)));
    fmt::print("\n");
  };
  fmt::print("{:<40}", "one core, best of all repeats");
  for (const Limit& limit : limits) fmt::print("{:>10}", name_of(limit.precision));
  fmt::print("\n");
  row("numbers in a pack", [](const Limit& l) { return l.lanes; });
  row("multiply-adds per ns", [](const Limit& l) { return l.multiply_adds; });
  row("ns per pair of waters", [](const Limit& l) { return l.forces.inside.best; });
  row("  within the switching range", [](const Limit& l) { return l.forces.truncated.best; });
  row("  with its energy", [](const Limit& l) { return l.energies.inside.best; });
  row("  within the switching range, with its energy",
      [](const Limit& l) { return l.energies.truncated.best; });
}

void print_evaluations(const std::vector<SystemTiming>& systems) {
  fmt::print("{} waters, {} pairs closer than 0.9 nm; a force evaluation\n", systems[0].molecules,
             systems[0].evaluations[0].pairs);
  fmt::print("{:<9}{:>8}{:>11}{:>10}{:>7}{:>15}{:>12}{:>7}{:>7}{:>12}\n", "precision", "threads",
             "switch[nm]", "forces", "±", "and energies", "arithmetic", "share", "fill",
             "list build");
  for (const SystemTiming& s : systems)
    for (const EvaluationTiming& e : s.evaluations) {
      // fmt pads by display width, so µ counts as one column.
      fmt::print("{:<9}{:>8}{:>11}{:>10}{:>7}{:>15}{:>12}{:>7}{:>7}{:>12}\n", name_of(s.precision),
                 s.threads, e.switch_from, duration(e.forces.best),
                 fmt::format("{:.0f} %", percent(e.forces.spread())), duration(e.energies.best),
                 duration(e.arithmetic / s.threads), fmt::format("{:.2f}", share(e, s.threads)),
                 fmt::format("{:.2f}", e.fill), duration(e.list.best));
    }
}

void print_steps(const std::vector<SystemTiming>& systems) {
  fmt::print("{} waters; a step of hoa2, 4 fs, by part, and ns/day\n", systems[0].molecules);
  fmt::print("{:<9}{:>8}{:>10}{:>9}{:>7}{:>7}{:>7}{:>7}", "precision", "threads", "step", "forces",
             "list", "drift", "kick", "rest");
  for (const StepTiming& t : systems[0].steps)
    fmt::print("{:>22}", fmt::format("{} {:g} fs", t.scheme, units::fs_per_ps * t.step));
  fmt::print("\n");
  for (const SystemTiming& s : systems) {
    const StepTiming& hoa2 = s.steps[0];
    fmt::print("{:<9}{:>8}{:>10}", name_of(s.precision), s.threads, duration(hoa2.all.best));
    fmt::print("{:>9}", fmt::format("{:.0f} %", percent(hoa2.forces / hoa2.all.best)));
    for (const double part : {hoa2.list, hoa2.drift, hoa2.kick, hoa2.rest})
      fmt::print("{:>7}", fmt::format("{:.1f} %", percent(part / hoa2.all.best)));
    for (const StepTiming& t : s.steps) fmt::print("{:>22.4g}", t.ns_per_day());
    fmt::print("\n");
  }
}

json as_json(const Timing& t, double unit) {
  return {{"best", unit * t.best}, {"median", unit * t.median}, {"spread", t.spread()}};
}

json as_json(const Limit& l) {
  const auto pair = [](const BarePair& p) {
    return json{{"inside", as_json(p.inside, 1)}, {"truncated", as_json(p.truncated, 1)}};
  };
  return {{"precision", name_of(l.precision)},
          {"lanes", l.lanes},
          {"multiply_adds_per_ns", l.multiply_adds},
          {"pair_ns", {{"forces", pair(l.forces)}, {"energies", pair(l.energies)}}}};
}

json as_json(const SystemTiming& s) {
  json evaluations = json::array(), steps = json::array();
  for (const EvaluationTiming& e : s.evaluations)
    evaluations.push_back(
        {{"cutoff_nm", 0.9},
         {"switch_nm", e.switch_from},
         {"pairs", e.pairs},
         {"forces_us", as_json(e.forces, 1e6)},
         {"energies_us", as_json(e.energies, 1e6)},
         {"arithmetic_us", units::us_per_s * e.arithmetic / s.threads},
         {"energy_arithmetic_us", units::us_per_s * e.energy_arithmetic / s.threads},
         {"share_of_limit", share(e, s.threads)},
         {"fill", e.fill},
         {"list_us", as_json(e.list, 1e6)}});
  for (const StepTiming& t : s.steps)
    steps.push_back({{"scheme", t.scheme},
                     {"step_fs", units::fs_per_ps * t.step},
                     {"step_us", as_json(t.all, 1e6)},
                     {"parts_us",
                      {{"forces", units::us_per_s * t.forces},
                       {"list", units::us_per_s * t.list},
                       {"drift", units::us_per_s * t.drift},
                       {"kick", units::us_per_s * t.kick},
                       {"rest", units::us_per_s * t.rest}}},
                     {"non_force_share", non_force_share(t)},
                     {"rebuilds_per_step", t.rebuilds},
                     {"ns_per_day", t.ns_per_day()}});
  return {{"molecules", s.molecules},
          {"precision", name_of(s.precision)},
          {"threads", s.threads},
          {"evaluations", evaluations},
          {"steps", steps}};
}

std::string join(const std::vector<std::string>& parts, const char* between = ", ") {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

}  // namespace

std::vector<std::string> verdict(const Benchmark& b) {
  std::vector<std::string> lines;
  for (const std::size_t molecules : sizes(b)) {
    std::vector<std::string> beside, speed_up, speeds;
    for (const SystemTiming& s : of_size(b, molecules)) {
      const EvaluationTiming& e = s.evaluations[0];
      const StepTiming& hoa2 = s.steps[0];
      const std::string_view precision = name_of(s.precision);
      if (s.threads == 1) {
        lines.push_back(fmt::format(
            "{} waters: {} for the forces in {} precision; the arithmetic of the pairs within the "
            "cutoff alone, with all lanes used, would take {}, {:.2f} of that",
            molecules, duration(e.forces.best), precision, duration(e.arithmetic), share(e, 1)));
        beside.push_back(fmt::format("{:.0f} % in {}", percent(non_force_share(hoa2)), precision));
      } else {
        for (const SystemTiming& one : b.systems)
          if (one.molecules == molecules && one.precision == s.precision && one.threads == 1)
            speed_up.push_back(fmt::format(
                "{:.2f} times as much as one for forces, {:.2f} for steps in {} precision",
                one.evaluations[0].forces.best / e.forces.best,
                one.steps[0].all.best / hoa2.all.best, precision));
      }
      speeds.push_back(fmt::format("{:.3g} in {} with {}", hoa2.ns_per_day(), precision,
                                   threads_text(s.threads)));
    }
    lines.push_back(fmt::format(
        "{} waters: everything except the forces takes {} of a step of hoa2, on one thread",
        molecules, join(beside)));
    if (!speed_up.empty())
      lines.push_back(fmt::format("{} waters: {} do {}", molecules,
                                  threads_text(b.systems.back().threads), join(speed_up, "; ")));
    lines.push_back(
        fmt::format("{} waters: ns/day with hoa2 at 4 fs: {}", molecules, join(speeds)));
  }
  const double spread = b.spread();
  lines.push_back(
      spread > noisy
          ? fmt::format(
                "this computer was busy or changed its clock rate: medians are up to {:.0f} % "
                "above the best repeats; measure again before relying on the ratios",
                percent(spread))
          : fmt::format("the computer was otherwise idle: medians are at most {:.1f} % above the "
                        "best repeats",
                        percent(spread)));
  return lines;
}

void print_benchmark(const Benchmark& b, const Computer& computer) {
  std::vector<std::string> instruction_sets, threads;
  for (const InstructionSet instruction_set : available_instruction_sets())
    instruction_sets.emplace_back(name(instruction_set));
  for (const int n : computer.threads) threads.push_back(std::to_string(n));
  fmt::print("processor         {}\n", computer.processor);
  fmt::print("instruction set   {} (available: {})\n", computer.instruction_set,
             join_names(instruction_sets));
  fmt::print("threads           {}\n\n", join_names(threads));
  print_limits(b.limits);
  for (const std::size_t molecules : sizes(b)) {
    fmt::print("\n");
    print_evaluations(of_size(b, molecules));
    fmt::print("\n");
    print_steps(of_size(b, molecules));
  }
  fmt::print("\n");
  for (const std::string& line : verdict(b)) fmt::print("- {}\n", line);
}

std::string benchmark_json(const Benchmark& b, const Computer& computer) {
  json limits = json::array(), systems = json::array(), instruction_sets = json::array();
  for (const InstructionSet instruction_set : available_instruction_sets())
    instruction_sets.push_back(name(instruction_set));
  for (const Limit& limit : b.limits) limits.push_back(as_json(limit));
  for (const SystemTiming& s : b.systems) systems.push_back(as_json(s));
  return json{{"version", version()},
              {"processor", computer.processor},
              {"instruction_set", computer.instruction_set},
              {"instruction_sets", instruction_sets},
              {"threads", computer.threads},
              {"limits", limits},
              {"systems", systems},
              {"spread", b.spread()},
              {"verdict", verdict(b)}}
      .dump(2);
}

}  // namespace polhode::cli
