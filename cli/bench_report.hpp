// SPDX-License-Identifier: MIT
// What a benchmark says: tables, a verdict in words, JSON.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/benchmark.hpp"

namespace polhode::cli {

/// What was measured on.
struct Computer {
  std::string processor, target;
  std::vector<int> threads;
};

void print_benchmark(const Benchmark& benchmark, const Computer& computer);

std::string benchmark_json(const Benchmark& benchmark, const Computer& computer);

/// The numbers that matter, in plain words, a sentence each.
std::vector<std::string> verdict(const Benchmark& benchmark);

}  // namespace polhode::cli
