// SPDX-License-Identifier: MIT
// The verbs of the command line. A verb declares its options on a subcommand, and returns a
// function to call after parsing. The return value of this function is the exit code.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options/command.hpp"

namespace polhode::cli {

using Action = std::function<int()>;

Action advise_verb(Command& command);
Action analyze_verb(Command& command);
Action bench_verb(Command& command);
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

struct Verb {
  const char* name;
  const char* description;
  Action (*declare)(Command&);
};

struct VerbGroup {
  const char* title;
  std::vector<Verb> verbs;
};

/// All verbs, in the order in which help lists them.
const std::vector<VerbGroup>& verb_groups();

std::vector<std::string> verb_names();

/// The list of verbs with three examples.
std::string overview();

}  // namespace polhode::cli
