// SPDX-License-Identifier: MIT
// What a benchmark prints.
#pragma once

#include "run/benchmark/benchmark_report.hpp"

namespace polhode::cli {

void print_benchmark(const Benchmark& benchmark, const Computer& computer);

}  // namespace polhode::cli
