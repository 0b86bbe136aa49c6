// SPDX-License-Identifier: MIT
// polhode bench: how fast this computer simulates water, and what limits the speed.

#include <fstream>
#include <memory>
#include <string>

#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "base/instruction_set.hpp"
#include "base/threads.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

struct BenchOptions : ResultForm {
  BenchmarkRequest request;
  std::string threads;
  bool quick = false;
};

/// The name of the processor according to the operating system.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon < line.size())
      return line.substr(colon + 2);
  return "unknown processor";
}

int bench(const BenchOptions& o) {
  const BenchmarkSettings settings =
      o.request.settings(o.quick, requested_threads(o.threads, "--threads"));
  const Computer computer{processor(), name(current_instruction_set()), settings.threads};
  const Benchmark result = run_benchmark(settings, console());
  if (result.interrupted) return interrupted(" before everything was measured");
  print_results(quantities(result, computer), o);
  return 0;
}

}  // namespace

Action bench_verb(Command& command) {
  auto o = std::make_shared<BenchOptions>();
  command.add_flag("--quick", o->quick,
                   "measure only 512 waters with fewer and shorter repeats, in a few seconds");
  command.add_request(o->request);
  command.add_option(
      "--threads", o->threads,
      "number of threads, compared with a single thread; default: one for each available core");
  command.add_flag("--json", o->json, "print all numbers as JSON");
  o->declare_verbose(command);
  return [o] { return bench(*o); };
}

}  // namespace polhode::cli
