// SPDX-License-Identifier: MIT
// What a benchmark measured.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/quantities.hpp"
#include "run/benchmark/benchmark.hpp"

namespace polhode {

/// The computer that was measured.
struct Computer {
  std::string processor, instruction_set;
  std::vector<int> threads;
};

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const Benchmark& benchmark, const Computer& computer);

}  // namespace polhode
