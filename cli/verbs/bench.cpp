// SPDX-License-Identifier: MIT
// polhode bench: how fast this computer simulates water, and what limits it.
#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "base/instruction_set.hpp"
#include "base/threads.hpp"
#include "run/benchmark/benchmark_report.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::vector<std::size_t> sizes;
  std::string precision, threads;
  bool quick = false, json = false;
};

/// The processor's name according to the operating system.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon < line.size())
      return line.substr(colon + 2);
  return "unknown processor";
}

BenchmarkSettings make_settings(const Options& o) {
  BenchmarkSettings settings;
  settings.quick = o.quick;
  if (o.quick) settings.sizes = {512};
  if (!o.sizes.empty()) settings.sizes = o.sizes;
  if (!o.precision.empty())
    settings.precisions = {named_option<Precision>(o.precision, "--precision")};
  const int threads = requested_threads(o.threads, "--threads");
  if (threads > 1) settings.threads.push_back(threads);
  return settings;
}

int bench(const Options& o) {
  const BenchmarkSettings settings = make_settings(o);
  const Computer computer{processor(), name(current_instruction_set()), settings.threads};
  const Benchmark result = run_benchmark(settings, console());
  if (result.interrupted) {
    log("interrupted before everything was measured\n");
    return 130;
  }
  print_results(quantities(result, computer), o.json);
  return 0;
}

}  // namespace

Action bench_verb(Command& command) {
  auto o = std::make_shared<Options>();
  command.add_flag("--quick", o->quick,
                   "512 waters only, fewer and shorter repeats: a few seconds");
  command
      .add_option(
          "--sizes", o->sizes,
          fmt::format("numbers of waters; default: {}", fmt::join(BenchmarkSettings{}.sizes, ",")))
      .separated_by(',')
      .in_range(1, 100'000'000);
  command.add_option("--precision", o->precision,
                     "precision of pair interactions, double or mixed; default: both");
  command.add_option("--threads", o->threads,
                     "number of threads, compared with one; default: one for each available core");
  command.add_flag("--json", o->json, "print all numbers as JSON");
  return [o] { return bench(*o); };
}

}  // namespace polhode::cli
