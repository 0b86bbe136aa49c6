// SPDX-License-Identifier: MIT
#include "bench_report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/instruction_set.hpp"
#include "base/suggest.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/integrate/scheme_text.hpp"

namespace polhode::cli {
namespace {

double percent(double x) { return 100 * x; }

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

}  // namespace

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

}  // namespace polhode::cli
