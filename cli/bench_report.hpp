// SPDX-License-Identifier: MIT
// Results of a benchmark: tables, a summary in words, JSON.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/benchmark/benchmark.hpp"

namespace polhode::cli {

/// The computer that was measured.
struct Computer {
  std::string processor, instruction_set;
  std::vector<int> threads;
};

void print_benchmark(const Benchmark& benchmark, const Computer& computer);

std::string benchmark_json(const Benchmark& benchmark, const Computer& computer);

/// The most important results, one sentence each.
std::vector<std::string> verdict(const Benchmark& benchmark);

}  // namespace polhode::cli
