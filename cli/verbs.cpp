// SPDX-License-Identifier: MIT
#include "verbs.hpp"

#include <fmt/core.h>

namespace polhode::cli {

// Each in verbs/.
Action advise_verb(Command& command);
Action analyze_verb(Command& command);
Action bench_verb(Command& command);
Action bias_verb(Command& command);
Action convert_verb(Command& command);
Action energy_verb(Command& command);
Action export_verb(Command& command);
Action measure_verb(Command& command);
Action merge_verb(Command& command);
Action minimise_verb(Command& command);
Action molecules_verb(Command& command);
Action new_verb(Command& command);
Action prepare_verb(Command& command);
Action run_verb(Command& command);
Action schemes_verb(Command& command);
Action settings_verb(Command& command);
Action study_verb(Command& command);
Action top_verb(Command& command);
Action tune_scheme_verb(Command& command);
Action verify_verb(Command& command);

const std::vector<VerbGroup>& verb_groups() {
  static const std::vector<VerbGroup> groups = {
      {"simulate",
       {{"new", "write a commented run file to start from", new_verb},
        {"prepare", "equilibrate a system by minimisation, NVT and NPT", prepare_verb},
        {"minimise", "minimise the energy of an initial configuration", minimise_verb},
        {"run", "run a simulation and write trajectory, energies and a summary", run_verb},
        {"measure", "compute properties of a model with requested standard errors", measure_verb},
        {"merge", "combine the parts (shards) of a measurement into one result", merge_verb},
        {"energy", "print energies, forces and torques of an initial configuration", energy_verb},
        {"analyze", "compute structure and dynamics from a trajectory: g(r), diffusion, ...",
         analyze_verb},
        {"convert", "convert coordinates and trajectories from one format to another",
         convert_verb},
        {"export", "write a run as LAMMPS input", export_verb}}},
      {"choose a scheme and a step",
       {{"advise", "choose scheme and step for a required accuracy and confirm them by runs",
         advise_verb},
        {"study", "measure accuracy and cost of schemes at several time steps", study_verb},
        {"bias", "compute the time-step bias of averages from the energies of any program",
         bias_verb},
        {"tune-scheme", "optimize the parameters of a scheme for a system and a time step",
         tune_scheme_verb},
        {"verify", "measure the order of a scheme", verify_verb}}},
      {"look up and try out",
       {{"molecules", "list the molecule models, or show one", molecules_verb},
        {"schemes", "list the splitting schemes, or show one", schemes_verb},
        {"settings", "list the settings of run files, or the values in one run file",
         settings_verb},
        {"top", "rotate one free top, or all tops in a table", top_verb},
        {"bench", "measure how fast this computer simulates water, and what limits the speed",
         bench_verb}}}};
  return groups;
}

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  for (const VerbGroup& group : verb_groups())
    for (const Verb& verb : group.verbs) names.emplace_back(verb.name);
  return names;
}

std::string overview() {
  std::string text =
      "polhode: molecular dynamics of rigid molecules with the exact free rotor\n"
      "Usage: polhode VERB [FILE] [options]\n";
  for (const VerbGroup& group : verb_groups()) {
    text += fmt::format("\n{}\n", group.title);
    for (const Verb& verb : group.verbs)
      text += fmt::format("  {:<12} {}\n", verb.name, verb.description);
  }
  return text +
         "\nexamples\n"
         "  polhode run --length \"1 ps\"                 512 TIP4P waters, without a run file\n"
         "  polhode new water                           a run file of your own: water.toml\n"
         "  polhode advise water.toml --accuracy \"1 %\"  the cheapest scheme and step for R = 1 "
         "%\n"
         "\n'polhode help VERB' lists the options of a verb; 'polhode -V' prints the version.\n";
}

}  // namespace polhode::cli
