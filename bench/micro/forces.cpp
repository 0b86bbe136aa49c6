// SPDX-License-Identifier: MIT
// Times one complete force evaluation of 512 TIP4P waters with a valid neighbour list, for every
// instruction set, precision and interaction. Also times a step of HOA2, which adds drifts, kicks
// and list updates. The derivative of the forces is timed in comparison with a force evaluation.
// The results for the molecule switch include the fraction of lanes in use and the time of only the
// pair arithmetic.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/stopwatch.hpp"
#include "forces/pairs/neighbours.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/benchmark/benchmark.hpp"

namespace {

using namespace polhode;

const std::pair<std::string, Truncation> truncations[] = {
    {"molecule_switch", Truncation::molecule_switch},
    {"site_switch", Truncation::site_switch},
    {"site_shift", Truncation::site_shift}};

ForceSettings law(Truncation truncation, Precision precision, double skin) {
  return {truncation, 0.9, 0.765, 2, Electrostatics::reaction_field, 78.5, skin, precision};
}

void force_evaluation(benchmark::State& loop, InstructionSet instruction_set, Truncation truncation,
                      Precision precision, bool energies) {
  force_instruction_set(instruction_set);
  const System water = build_system(default_config());
  ForceField forces(water.topology, law(truncation, precision, 0.04), water.state.box);
  Load load;
  forces(water.state, load);
  for (auto _ : loop) {
    if (energies)
      forces(water.state, load);
    else
      forces.forces_alone(water.state, load);
  }
  const auto lanes = static_cast<double>(forces.neighbours().lanes());
  loop.counters["lanes"] = lanes;
  if (truncation != Truncation::molecule_switch) return;
  const ForceSettings& settings = forces.settings();
  const std::size_t pairs = pairs_within(water.state, settings.cutoff),
                    whole = pairs_within(water.state, settings.switch_from);
  loop.counters["fill"] = static_cast<double>(pairs) / lanes;
  loop.counters["arithmetic_us"] =
      1e6 * measure_limit(precision, 0.05).seconds(whole, pairs - whole, energies);
}

/// Measures the derivative of forces along the direction of a gradient kick, interleaved with force
/// evaluations. Minimum times are used, so that other programs on the computer do not affect the
/// ratio of the two times.
void derivative(benchmark::State& loop, InstructionSet instruction_set, Precision precision,
                const ForceSettings& settings) {
  force_instruction_set(instruction_set);
  const System water = build_system(default_config());
  ForceSettings with_precision = settings;
  with_precision.precision = precision;
  ForceField forces(water.topology, with_precision, water.state.box);
  Load load, slope;
  forces(water.state, load);
  Vec3Column dq, dtheta;
  gradient_direction(water.state, water.bodies, load, dq, dtheta);
  double derivative = 1, evaluation = 1;  // minimum times [s]
  const auto timed = [](double& min_seconds, const auto& work) {
    const double seconds = seconds_of(work);
    min_seconds = std::min(min_seconds, seconds);
    return seconds;
  };
  for (auto _ : loop) {
    timed(evaluation, [&] { forces.forces_alone(water.state, load); });
    loop.SetIterationTime(
        timed(derivative, [&] { forces.directional_derivative(water.state, dq, dtheta, slope); }));
  }
  loop.counters["min_us"] = 1e6 * derivative;
  loop.counters["force_us"] = 1e6 * evaluation;
  loop.counters["ratio"] = derivative / evaluation;
}

void hoa2_step(benchmark::State& loop, InstructionSet instruction_set, Precision precision,
               double skin) {
  force_instruction_set(instruction_set);
  System water = build_system(default_config());
  ForceField forces(water.topology, law(Truncation::molecule_switch, precision, skin),
                    water.state.box);
  Integrator integrator(scheme_of("hoa2"), water.bodies, forces);
  for (auto _ : loop) integrator.advance(water.state, 0.004);
  loop.counters["rebuilds_per_step"] =
      static_cast<double>(forces.neighbours().rebuilds()) / static_cast<double>(loop.iterations());
  loop.counters["list_us_per_step"] =
      1e6 * forces.neighbours().seconds() / static_cast<double>(loop.iterations());
}

}  // namespace

int main(int argc, char** argv) {
  for (const InstructionSet instruction_set : available_instruction_sets())
    for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
      const std::string on =
          std::string(precision == Precision::double_precision ? "/double/" : "/mixed/") +
          name(instruction_set);
      const auto add = [&](const std::string& name, auto... arguments) {
        benchmark::RegisterBenchmark((name + on).c_str(), arguments...)
            ->Unit(benchmark::kMicrosecond);
      };
      for (const bool energies : {false, true}) {
        const std::string what = energies ? "/energies" : "/forces";
        for (const auto& [name, truncation] : truncations)
          add(name + what, force_evaluation, instruction_set, truncation, precision, energies);
      }
      const auto add_derivative = [&](const std::string& name, const ForceSettings& settings) {
        benchmark::RegisterBenchmark(("derivative/" + name + on).c_str(), derivative,
                                     instruction_set, precision, settings)
            ->UseManualTime()
            ->Unit(benchmark::kMicrosecond);
      };
      for (const auto& [name, truncation] : truncations)
        add_derivative(name, law(truncation, precision, 0.04));
      ForceSettings ewald = law(Truncation::site_switch, precision, 0.04);
      ewald.electrostatics = Electrostatics::pme;
      add_derivative("ewald", ewald);
      for (const double skin : {0.03, 0.05, 0.07})
        add("hoa2_step/skin=" + std::to_string(skin).substr(0, 4), hoa2_step, instruction_set,
            precision, skin);
    }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
