// SPDX-License-Identifier: MIT
// polhode analyze TRAJECTORY: structure, dynamics and dielectric constant from its frames.
#include <fmt/core.h>

#include <memory>

#include "analyze_options.hpp"
#include "analyze_report.hpp"
#include "console.hpp"
#include "option_values.hpp"
#include "polhode/base/threads.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

int analyze(const AnalyzeOptions& o) {
  const AnalysisInput input = analysis_input(o);
  Workers workers(requested_threads(o.threads));
  const AnalysisReport report =
      run_analysis(input, {existing_files(false, o.force), analyze_command(o)}, console(), workers);
  if (o.json)
    fmt::print("{}\n", analysis_json(report));
  else
    print_analysis(report);
  return report.analysis.stopped ? 130 : 0;
}

}  // namespace

Action analyze_verb(CLI::App& app) {
  auto o = std::make_shared<AnalyzeOptions>();
  app.add_option("TRAJECTORY", o->trajectory, "file of frames; its ending tells the format")
      ->required();
  app.add_option("--run", o->run, "run file that made it: its molecules and electrostatics");
  app.add_option("--molecules", o->molecules,
                 "in place of a run file: \"tip4p 512, na-tip4p-ew 4\", in the order of the file");
  app.add_option("--names", o->names, "coordinate file with the names of the atoms");
  app.add_option("--what", o->what,
                 "of rdf, msd, rotation, velocity, dielectric, density; without it all that the "
                 "frames allow");
  app.add_option("--output", o->output, "prefix of the output files; without it polhode-analysis");
  app.add_option("--from", o->from, "leaves out frames before: \"10 ps\"");
  app.add_option("--interval", o->interval, "between frames, in place of their times: \"0.1 ps\"");
  app.add_option("--window", o->window, "longest lag of correlations; without it \"10 ps\"");
  app.add_option("--fit", o->fit,
                 "lags of the line that gives D: \"2 ps, 10 ps\"; without it from a fifth of the "
                 "longest lag to that");
  app.add_option("--pairs", o->pairs,
                 "of sites for g(r): \"OW-OW, OW-HW\"; HW names HW1 and HW2; without it all pairs");
  app.add_option("--cutoff", o->cutoff,
                 "of g(r); without it \"1 nm\", or half of the shortest edge");
  app.add_option("--bin", o->bin, "of g(r); without it \"0.002 nm\"");
  app.add_option("--viscosity", o->viscosity,
                 "of the liquid, \"0.855 mPa s\", for what images take from D; without it the "
                 "published one of the model");
  app.add_option("--temperature", o->temperature, "\"298 K\"; without it that of the velocities");
  app.add_option("--electrostatics", o->electrostatics,
                 "in place of a run file's: pme, reaction-field (of 78.5) or coulomb");
  app.add_option("--plot", o->plot, "svg, png or none; without it svg");
  app.add_option("--threads", o->threads,
                 "that share the work; without it: one for each core allowed");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return analyze(*o); };
}

}  // namespace polhode::cli
