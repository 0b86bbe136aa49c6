// SPDX-License-Identifier: MIT
// polhode analyze TRAJECTORY: structure, dynamics and dielectric constant from its frames.
#include <fmt/core.h>

#include <memory>

#include "../options/analyze_options.hpp"
#include "../options/option_values.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "base/suggest.hpp"
#include "base/threads.hpp"

namespace polhode::cli {
namespace {

int analyze(const AnalyzeOptions& o) {
  const AnalysisInput input = analysis_input(o);
  Workers workers(requested_threads(o.threads, "--threads"));
  const AnalysisReport report =
      run_analysis(input, {existing_files(false, o.force), analyze_command(o)}, console(), workers);
  fmt::print("{}", o.json ? analysis_json(report) + "\n" : analysis_text(report));
  if (!o.json) print_files(report.files);
  return report.analysis.stopped ? 130 : 0;
}

}  // namespace

Action analyze_verb(Command& command) {
  auto o = std::make_shared<AnalyzeOptions>();
  const AnalysisSettings defaults;
  command
      .add_option("TRAJECTORY", o->trajectory,
                  "trajectory or coordinate file; the format follows from its extension")
      .required();
  command.add_option("--run", o->run,
                     "run file of the trajectory, for its molecules and electrostatics");
  command.add_option(
      "--energies", o->energies,
      "energies file of the run, for the bias of the step in g(r) and the dielectric "
      "constant; needs --run");
  command.add_option(
      "--molecules", o->molecules,
      "instead of a run file: \"tip4p 512, na-tip4p-ew 4\", in the order of the file");
  command.add_option("--names", o->names, "coordinate file with the names of the atoms");
  command.add_option(
      "--what", o->what,
      fmt::format("any of {}; default: all that the frames allow", join_names(observable_names())));
  command.add_option("--output", o->output, "prefix of the output files").show_default();
  command.add_option("--from", o->from, "ignore frames before this time: \"10 ps\"");
  command.add_option("--interval", o->interval,
                     "time between frames, instead of the times in the file: \"0.1 ps\"");
  command.add_option(
      "--window", o->window,
      fmt::format("maximum lag of correlations; default: \"{}\"", time_text(defaults.window)));
  command.add_option(
      "--fit", o->fit,
      "range of lags of the line fitted for D: \"2 ps, 10 ps\"; default: from a fifth "
      "of the maximum lag to the maximum lag");
  command.add_option(
      "--pairs", o->pairs,
      "site pairs of g(r): \"OW-OW, OW-HW\"; HW means HW1 and HW2; default: all pairs");
  command.add_option(
      "--cutoff", o->cutoff,
      fmt::format("maximum distance of g(r); default: \"{:g} nm\", or half of the shortest edge",
                  default_rdf_cutoff));
  command.add_option("--bin", o->bin,
                     fmt::format("bin width of g(r); default: \"{:g} nm\"", defaults.bin));
  command.add_option("--viscosity", o->viscosity,
                     "viscosity of the liquid, \"0.855 mPa s\", for the Yeh-Hummer finite-size "
                     "correction of D; default: the published value of the model");
  command.add_option("--temperature", o->temperature,
                     "\"298 K\"; default: the temperature of the velocities, or of the run file");
  command.add_option(
      "--electrostatics", o->electrostatics,
      fmt::format("instead of the run file's: pme, reaction-field (of {:g}) or coulomb",
                  ForceSettings{}.dielectric));
  command.add_option("--plot", o->plot, "svg, png or none").show_default();
  command.add_option("--threads", o->threads,
                     "number of threads; default: one for each available core");
  command.add_flag("--force", o->force, "overwrite output files that exist");
  command.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return analyze(*o); };
}

}  // namespace polhode::cli
