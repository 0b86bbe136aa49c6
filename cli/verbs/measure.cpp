// SPDX-License-Identifier: MIT
// polhode measure SYSTEM PROPERTY [ERROR] ...: properties of a model, each to a requested error.
// polhode merge, with the same options: what the records of all shards have.
#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "run/properties/measure_request.hpp"

namespace polhode::cli {
namespace {

using MeasureOptions = RequestOptions<MeasureRequest>;

int measure(const MeasureOptions& o, const std::string& command, bool only_evaluate) {
  MeasureSettings settings = o.request.settings();
  settings.command = command;
  settings.only_evaluate = only_evaluate;
  Workers workers = o.workers();
  const MeasureReport report = polhode::measure(settings, console(), workers);
  print_results(quantities(report), o);
  if (report.interrupted) log("interrupted; the same command resumes\n");
  if (report.out_of_time) log("the time limit is reached; the same command resumes\n");
  return report.interrupted ? 130 : report.failed ? 1 : 0;
}

Action declare(Command& command, bool only_evaluate) {
  auto o = std::make_shared<MeasureOptions>();
  command.add_option("SYSTEM", o->request.system,
                     "run file, molecule file, name of a model, a mixture: \"spce 488, na-spce 12, "
                     "cl-spce 12\", or files of GROMACS or LAMMPS: topol.top conf.gro run.mdp, "
                     "system.data",
                     required);
  command.add_option("PROPERTIES", o->request.properties, properties_help());
  o->declare_threads(command, "simultaneous replicas");
  command.add_flag("--json", o->json, "print JSON instead of text");
  command.add_request(o->request);
  return [o, command, only_evaluate] { return measure(*o, command.typed(), only_evaluate); };
}

}  // namespace

Action measure_verb(Command& command) { return declare(command, false); }
Action merge_verb(Command& command) { return declare(command, true); }

}  // namespace polhode::cli
