// SPDX-License-Identifier: MIT
// What a benchmark measured, as JSON and in sentences.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "run/benchmark/benchmark.hpp"

namespace polhode {

/// The computer that was measured.
struct Computer {
  std::string processor, instruction_set;
  std::vector<int> threads;
};

/// All numbers as JSON.
std::string benchmark_json(const Benchmark& benchmark, const Computer& computer);

/// What the numbers mean, one sentence each.
std::vector<std::string> verdict(const Benchmark& benchmark);

/// The numbers of molecules that were measured, and the systems of one of them.
std::vector<std::size_t> sizes(const Benchmark& benchmark);
std::vector<SystemTiming> of_size(const Benchmark& benchmark, std::size_t molecules);

/// The bare arithmetic of the pairs relative to the time of the forces.
double share(const EvaluationTiming& evaluation, int threads);
/// The part of a step that is not forces.
double non_force_share(const StepTiming& step);

std::string threads_text(int threads);  ///< "2 threads"
/// A time [s] with three digits and a unit.
std::string duration(double seconds);

}  // namespace polhode
