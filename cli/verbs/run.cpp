// SPDX-License-Identifier: MIT
// polhode run [FILE]: simulates a trajectory, and writes its energies, plots and summary.
#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "polhode/run/simulation/simulation.hpp"

namespace polhode::cli {
namespace {

int run(const JobOptions& o) {
  const OutputOptions output = o.output();
  Workers workers = o.workers();
  Simulation simulation(o.config(), workers);
  try {
    return print_run(simulation.run(output, console()), simulation, o);
  } catch (const RunError&) {
    note_resumable(simulation);
    throw;
  }
}

}  // namespace

Action run_verb(Command& command) {
  auto o = std::make_shared<JobOptions>();
  o->declare(command, "threads");
  o->declare_verbose(command);
  command.add_settings();
  o->declare_resume(command);
  o->declare_force(command);
  return [o] { return run(*o); };
}

}  // namespace polhode::cli
