// SPDX-License-Identifier: MIT
// polhode study [FILE]: compares the accuracy and cost of schemes, as in the figure of the paper.
#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

using StudyOptions = RequestOptions<StudyRequest>;

int study(const StudyOptions& o) {
  Workers workers = o.workers();
  return perform_study(o.config(o.request.quick), o.request, o.output(), console(), workers,
                       [&](const auto& report) {
                         return finish_study(report, StudyFiles(o.request.prefix()).runs, o);
                       });
}

}  // namespace

Action study_verb(Command& command) {
  auto o = std::make_shared<StudyOptions>();
  o->declare(command, "simultaneous runs");
  o->declare_verbose(command);
  command.add_flag("--quick", o->request.quick,
                   "small study, which takes one to three minutes on two cores");
  command.add_settings();
  command.add_request(o->request);
  o->declare_force(command);
  return [o] { return study(*o); };
}

}  // namespace polhode::cli
