// SPDX-License-Identifier: MIT
#include "run/benchmark/benchmark_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/instruction_set.hpp"
#include "base/version.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/settings/output_units.hpp"

namespace polhode {
namespace {

using nlohmann::json;

constexpr double noisy = 0.1;  // a spread above which the user is warned

double percent(double x) { return 100 * x; }

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

std::string threads_text(int n) { return fmt::format("{} thread{}", n, n == 1 ? "" : "s"); }

std::string duration(double seconds) {
  const double us = units::us_per_s * seconds;
  return us < 1000  ? fmt::format("{:.3g} µs", us)
         : us < 1e6 ? fmt::format("{:.3g} ms", us / 1e3)
                    : fmt::format("{:.3g} s", seconds);
}

double share(const EvaluationTiming& e, int threads) {
  return e.arithmetic / threads / e.forces.best;
}

double non_force_share(const StepTiming& s) { return 1 - s.forces / s.all.best; }

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

}  // namespace polhode
