// SPDX-License-Identifier: MIT
// polhode analyze TRAJECTORY: structure, dynamics and dielectric constant from its frames.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../terminal/console.hpp"
#include "../terminal/terminal.hpp"
#include "../verbs.hpp"
#include "run/analysis/analysis_request.hpp"

namespace polhode::cli {
namespace {

struct AnalyzeOptions : RequestOptions<AnalysisRequest> {
  std::string trajectory;
};

int analyze(const AnalyzeOptions& o) {
  const AnalysisInput input = analysis_input(o.request, o.trajectory);
  Workers workers = o.workers();
  const AnalysisReport report = run_analysis(input, o.output(), console(), workers);
  if (o.json)
    fmt::print("{}\n", analysis_json(report));
  else
    print_fitted(analysis_text(report));
  return report.analysis.stopped ? 130 : 0;
}

}  // namespace

Action analyze_verb(Command& command) {
  auto o = std::make_shared<AnalyzeOptions>();
  command.add_option("TRAJECTORY", o->trajectory,
                     "trajectory or coordinate file; the format follows from its extension",
                     required);
  command.add_request(o->request);
  o->declare_threads(command, "threads");
  o->declare_force(command);
  command.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return analyze(*o); };
}

}  // namespace polhode::cli
