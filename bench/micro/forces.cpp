// SPDX-License-Identifier: MIT
// One complete force evaluation of 512 TIP4P waters, list valid, on every instruction set and for
// both truncations; and a step of HOA2, which adds drifts, kicks and the upkeep of the list.
#include <benchmark/benchmark.h>

#include <string>

#include "polhode/base/target.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/system.hpp"

namespace {

using namespace polhode;

void force_evaluation(benchmark::State& loop, Target target, Truncation truncation, double cutoff) {
  force_target(target);
  const System water = assembled(default_config());
  ForceField forces(water.topology, {truncation, cutoff, cutoff - 0.15, 2, 78.5, 0.1},
                    water.state.box);
  Load load;
  forces(water.state, load);
  for (auto _ : loop) forces(water.state, load);
  loop.counters["pairs_in_list"] = static_cast<double>(forces.neighbours().pairs());
}

void hoa2_step(benchmark::State& loop, Target target) {
  force_target(target);
  System water = assembled(default_config());
  ForceField forces(water.topology, water.forces, water.state.box);
  Integrator integrator(scheme_of("hoa2"), water.bodies, forces);
  for (auto _ : loop) integrator.advance(water.state, 0.004);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Target target : available_targets()) {
    const std::string on = std::string("/") + name(target);
    for (const double cutoff : {1.0, 0.9})
      for (const auto truncation : {Truncation::molecule_switch, Truncation::reaction_field}) {
        const std::string law =
            truncation == Truncation::molecule_switch ? "molecule_switch" : "reaction_field";
        benchmark::RegisterBenchmark((law + "/" + std::to_string(cutoff).substr(0, 3) + on).c_str(),
                                     force_evaluation, target, truncation, cutoff)
            ->Unit(benchmark::kMicrosecond);
      }
    benchmark::RegisterBenchmark(("hoa2_step" + on).c_str(), hoa2_step, target)
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
