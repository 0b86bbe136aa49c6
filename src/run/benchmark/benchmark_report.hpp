// SPDX-License-Identifier: MIT
// What a benchmark measured.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/quantities.hpp"
#include "run/benchmark/benchmark.hpp"

namespace polhode {

/// The computer on which the benchmark ran.
struct Computer {
  std::string processor, instruction_set;
  std::vector<int> threads;
};

/// The results of a benchmark as a list, from which text, JSON and the manual are made.
Quantities quantities(const Benchmark& benchmark, const Computer& computer);

}  // namespace polhode
