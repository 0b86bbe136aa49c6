// SPDX-License-Identifier: MIT
// polhode prepare [FILE]: makes an equilibrated initial configuration from composition, temperature
// and pressure or density.
#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/run/prepare/preparation.hpp"

namespace polhode::cli {
namespace {

void note_interrupted(const PreparationReport& report) {
  if (report.checkpoint.empty())
    log("interrupted; no file was written, and the same command starts over\n");
  else
    log("interrupted; --resume continues the preparation from the checkpoint '{}'\n",
        report.checkpoint);
}

int prepare(const JobOptions& o) {
  Workers workers = o.workers();
  const PreparationReport report = polhode::prepare(o.config(), o.output(), console(), workers);
  if (!report.properties) note_interrupted(report);
  if (o.json || report.properties) print_results(quantities(report), o);
  return report.properties ? 0 : 130;
}

}  // namespace

Action prepare_verb(Command& command) {
  auto o = std::make_shared<JobOptions>();
  o->declare(command, "threads");
  command.add_settings();
  o->declare_resume(command);
  o->declare_force(command);
  return [o] { return prepare(*o); };
}

}  // namespace polhode::cli
