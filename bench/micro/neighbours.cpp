// SPDX-License-Identifier: MIT
// Times the construction of the neighbour list of liquid water for every instruction set, and
// separately the sorting of the bodies. The time per body should hardly depend on the number of
// bodies.
#include <benchmark/benchmark.h>

#include <string>

#include "base/instruction_set.hpp"
#include "forces/pairs/neighbours.hpp"
#include "waters.hpp"

namespace {

using namespace polhode;
using bench::waters;

void build(benchmark::State& loop, InstructionSet instruction_set, Truncation truncation,
           std::size_t copies, std::size_t width) {
  force_instruction_set(instruction_set);
  const System water = waters(copies);
  NeighbourList list(water.topology,
                     {.truncation = truncation, .cutoff = 0.9, .switch_from = 0.765, .skin = 0.05},
                     water.state.box);
  for (auto _ : loop) list.build(water.state, width);
  const auto bodies = static_cast<double>(water.state.size());
  loop.counters["ns_a_body"] = benchmark::Counter(
      bodies / 1e9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  loop.counters["lanes_a_body"] = static_cast<double>(list.lanes()) / bodies;
}

void sort(benchmark::State& loop, std::size_t copies) {
  const System water = waters(copies);
  Slots slots(water.topology);
  for (auto _ : loop) slots.sort(water.state, Workers::serial());
}

void register_all() {
  for (const std::size_t copies : {1u, 2u, 4u}) {
    const std::string waters = std::to_string(512 * copies * copies * copies) + "-waters";
    benchmark::RegisterBenchmark(("sort/" + waters).c_str(), sort, copies)
        ->Unit(benchmark::kMicrosecond);
    for (const InstructionSet set : available_instruction_sets())
      for (const auto& [law, truncation] : {std::pair{"molecules", Truncation::molecule_switch},
                                            std::pair{"sites", Truncation::site_switch}})
        benchmark::RegisterBenchmark(("build/" + waters + "/" + law + "/" + name(set)).c_str(),
                                     build, set, truncation, copies, 16)
            ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
