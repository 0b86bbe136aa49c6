// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/version.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/settings/output_units.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

constexpr double noisy = 0.1;  // relative spread of timings above which the user is warned

std::string threads_text(int n) { return fmt::format("{} thread{}", n, n == 1 ? "" : "s"); }

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

double percent(double x) { return 100 * x; }

/// Converts a timing to a list of quantities.
Quantities of_timing(const Timing& t, double unit, const char* label = "", const char* in = "") {
  return {{"best", in, unit * t.best, "", label},
          {"median", "", unit * t.median},
          {"spread", "", t.spread()}};
}

Quantities of_limit(const Limit& l) {
  const auto pair = [](const BarePair& p, const char* inside, const char* truncated) {
    return Quantities{{"inside", "", of_timing(p.inside, 1, inside, "[ns]")},
                      {"truncated", "", of_timing(p.truncated, 1, truncated, "[ns]")}};
  };
  return {{"precision", "", std::string(name_of(l.precision)), "precision of pair interactions",
           "precision"},
          {"lanes", "", l.lanes, "number of lanes of a SIMD vector", "lanes"},
          {"multiply_adds_per_ns", "", l.multiply_adds, "", "multiply-adds/ns"},
          {"pair_ns", "",
           Quantities{{"forces", "", pair(l.forces, "pair", "switched")},
                      {"energies", "", pair(l.energies, "with energy", "switched, with energy")}},
           "computing time per pair of waters: best repeat, median, and spread of the repeats"}};
}

Quantities of_evaluation(const EvaluationTiming& e, int threads) {
  constexpr double us = units::us_per_s;
  return {
      {"cutoff", "nm", 0.9, "cutoff"},
      {"switch", "nm", e.switch_from, "distance at which the switching function begins", "switch"},
      {"pairs", "", e.pairs, "number of pairs of molecules within the cutoff", "pairs"},
      {"forces_us", "", of_timing(e.forces, us, "forces", "[us]"), "time of the forces"},
      {"energies_us", "", of_timing(e.energies, us, "and energies", "[us]"),
       "time of forces and energies"},
      {"arithmetic_us", "[us]", us * e.arithmetic / threads, "time of the pair arithmetic only",
       "arithmetic"},
      {"energy_arithmetic_us", "", us * e.energy_arithmetic / threads,
       "time of the pair arithmetic only, with energies"},
      {"share_of_limit", "", share(e, threads),
       "time of the pair arithmetic, divided by the time of a force evaluation", "share"},
      {"fill", "", e.fill, "fraction of SIMD lanes in use", "fill"},
      {"list_us", "", of_timing(e.list, us, "list build", "[us]"),
       "time to build the neighbour list"}};
}

Quantities of_step(const StepTiming& t) {
  Quantities parts;
  for (const auto& [name, time] : {std::pair("forces", t.forces),
                                   {"list", t.list},
                                   {"drift", t.drift},
                                   {"kick", t.kick},
                                   {"rest", t.rest}}) {
    parts.push_back({name, "", units::us_per_s * time});
    parts.push_back({"", "%", time / t.all.best, "", name});
  }
  return {
      {"scheme", "", t.scheme, "scheme", "scheme"},
      {"interactions", "", t.interactions,
       "reaction field (molecule switch), reaction field with a site switch, or Ewald sum (PME)",
       "interactions"},
      {"step", "fs", units::fs_per_ps * t.step, "time step", "step"},
      {"step_us", "", of_timing(t.all, units::us_per_s, "a step", "[us]"), "time of a step"},
      {"parts_us", "", parts, "time of each part of a step"},
      {"non_force_share", "", non_force_share(t),
       "fraction of the time of a step that is not spent on forces"},
      {"rebuilds_per_step", "", t.rebuilds, "number of neighbour-list rebuilds per step"},
      {"ns_per_day", "", t.ns_per_day(), "speed", "ns/day"}};
}

Quantities of_conditions(const SystemTiming& s) {
  return {{"molecules", "", s.molecules, "number of waters", "waters"},
          {"precision", "", std::string(name_of(s.precision)), "precision of pair interactions",
           "precision"},
          {"threads", "", s.threads, "number of threads", "threads"}};
}

/// The timings of all systems in JSON, and as two tables in the text.
Quantities of_systems(const std::vector<SystemTiming>& systems) {
  std::vector<Quantities> all, evaluations, steps;
  const auto add = [&](std::vector<Quantities>& own, std::vector<Quantities>& table,
                       const SystemTiming& s, const Quantities& timing) {
    own.push_back(without_labels(timing));
    table.push_back(of_conditions(s));
    append(table.back(), timing);
  };
  for (const SystemTiming& s : systems) {
    std::vector<Quantities> own_evaluations, own_steps;
    for (const EvaluationTiming& e : s.evaluations)
      add(own_evaluations, evaluations, s, of_evaluation(e, s.threads));
    for (const StepTiming& t : s.steps) add(own_steps, steps, s, of_step(t));
    all.push_back(without_labels(of_conditions(s)));
    append(all.back(), {{"evaluations", "", own_evaluations, "timings of a force evaluation"},
                        {"steps", "", own_steps, "timings of a step"}});
  }
  return {{"systems", "", all, "timings of each system"},
          detail({"", "", evaluations, "", "a force evaluation, cutoff 0.9 nm"}),
          detail({"", "", steps, "", "a step and its parts"})};
}

/// Another timing of a system, such as that with one thread.
const SystemTiming* like(const Benchmark& b, const SystemTiming& s, Precision precision,
                         int threads) {
  const auto found = std::ranges::find_if(b.systems, [&](const SystemTiming& other) {
    return other.molecules == s.molecules && other.precision == precision &&
           other.threads == threads;
  });
  return found == b.systems.end() ? nullptr : &*found;
}

/// Steps of velocity Verlet with all interactions: a row for each system size and precision, with a
/// column for each number of threads.
std::vector<Quantities> table_of_steps(const Benchmark& b, const std::vector<int>& threads) {
  std::vector<Quantities> rows;
  for (const SystemTiming& one : b.systems)
    for (std::size_t k = 0; k < one.steps.size(); ++k) {
      const StepTiming& step = one.steps[k];
      if (one.threads != threads.front() || step.scheme != "velocity-verlet") continue;
      Quantities& cells = rows.emplace_back(
          Quantities{{"", "", one.molecules, "", "waters"},
                     {"", "", step.interactions, "", "interactions"},
                     {"", "", std::string(name_of(one.precision)), "", "precision"}});
      for (const int n : threads) {
        const SystemTiming* const timed = like(b, one, one.precision, n);
        if (!timed) continue;
        const double seconds = timed->steps[k].all.best;
        cells.push_back({"", "[ms]", 1e3 * seconds, "", threads_text(n), "", "", 3});
        if (n != threads.front())
          cells.push_back({"", "", step.all.best / seconds, "", "speed-up", "", "", 3});
      }
    }
  return rows;
}

/// What the timings mean for a user, in sentences.
std::vector<std::string> verdict(const Benchmark& b) {
  std::vector<std::string> lines;
  const auto range = [](const std::vector<double>& x) {
    const auto [least, most] = std::ranges::minmax(x);
    return most - least < 0.05 ? fmt::format("{:.1f}", least)
                               : fmt::format("{:.1f} to {:.1f}", least, most);
  };
  for (const std::size_t molecules : sizes(b)) {
    const auto add = [&](const std::string& sentence) {
      lines.push_back(fmt::format("{} waters: {}", molecules, sentence));
    };
    const std::vector<SystemTiming> systems = of_size(b, molecules);
    const auto ratios = [&](const SystemTiming& slow, const SystemTiming& fast) {
      std::vector<double> all;
      for (std::size_t k = 0; k < fast.steps.size(); ++k)
        all.push_back(slow.steps[k].all.best / fast.steps[k].all.best);
      return all;
    };
    for (const SystemTiming& s : systems) {
      const std::string_view precision = name_of(s.precision);
      const SystemTiming* const one = like(b, s, s.precision, 1);
      const SystemTiming* const in_double = like(b, s, Precision::double_precision, s.threads);
      if (s.threads == 1 && s.precision == Precision::mixed && in_double)
        add(fmt::format("a step in mixed precision is {} times as fast as in double precision",
                        range(ratios(*in_double, s))));
      if (s.threads > 1 && one)
        add(fmt::format("a step on {} is {} times as fast as on one, in {} precision",
                        threads_text(s.threads), range(ratios(*one, s)), precision));
    }
    const SystemTiming& fastest = *std::ranges::min_element(
        systems, {}, [](const SystemTiming& s) { return s.steps[0].all.best; });
    const double speed = fastest.steps[0].ns_per_day();
    add(fmt::format("hoa2 at 4 fs simulates up to {} ns/day, in {} precision on {}",
                    speed < 1000 ? fmt::format("{:.3g}", speed) : fmt::format("{:.0f}", speed),
                    name_of(fastest.precision), threads_text(fastest.threads)));
    add(
        fmt::format("the arithmetic of pairs takes at least {:.0f} % of the time of forces on one "
                    "thread, in {} precision",
                    percent(share(systems[0].evaluations[0], systems[0].threads)),
                    name_of(systems[0].precision)));
  }
  const double spread = b.spread();
  lines.push_back(
      spread > noisy
          ? fmt::format("the computer was busy, or its clock rate changed: median times are up to "
                        "{:.0f} % above the best times; measure again before relying on the ratios",
                        percent(spread))
          : fmt::format("the computer was otherwise idle: median times are at most {:.1f} % above "
                        "the best times",
                        percent(spread)));
  return lines;
}

}  // namespace

Quantities quantities(const Benchmark& b, const Computer& computer) {
  std::vector<std::string> instruction_sets;
  for (const InstructionSet instruction_set : available_instruction_sets())
    instruction_sets.emplace_back(name(instruction_set));
  std::vector<Quantities> limits;
  for (const Limit& limit : b.limits) limits.push_back(of_limit(limit));
  Quantities list = {
      {"version", "", version(), "version of the program"},
      {"processor", "", computer.processor, "name of the processor", "processor"},
      {"instruction_set", "", computer.instruction_set, "instruction set that was measured",
       "instruction set", fmt::format(" (available: {})", fmt::join(instruction_sets, ", "))},
      {"instruction_sets", "", instruction_sets, "instruction sets of this computer"},
      {"threads", "", computer.threads, "numbers of threads"},
      row("threads", fmt::format("{}", fmt::join(computer.threads, ", "))),
      detail({"limits", "", limits, "speed of one core", "one core, best of all repeats"})};
  append(list, of_systems(b.systems));
  const std::vector<Quantities> steps = table_of_steps(b, computer.threads);
  if (!steps.empty())
    list.push_back({"", "", steps, "", "a step of velocity Verlet, 2 fs, without energies"});
  append(list, {{"spread", "", b.spread(), "largest spread of repeated timings"},
                {"verdict", "", verdict(b), "conclusion from the timings", "verdict"}});
  return list;
}

}  // namespace polhode
