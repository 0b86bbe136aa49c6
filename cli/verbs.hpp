// SPDX-License-Identifier: MIT
// The verbs of the command line. A verb declares its options on its own subcommand and returns a
// function to call after parsing, whose return value is the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace polhode::cli {

using Action = std::function<int()>;

Action advise_verb(CLI::App& app);
Action analyze_verb(CLI::App& app);
Action bench_verb(CLI::App& app);
Action convert_verb(CLI::App& app);
Action energy_verb(CLI::App& app);
Action molecules_verb(CLI::App& app);
Action new_verb(CLI::App& app);
Action run_verb(CLI::App& app);
Action schemes_verb(CLI::App& app);
Action study_verb(CLI::App& app);
Action top_verb(CLI::App& app);
Action tune_scheme_verb(CLI::App& app);
Action verify_verb(CLI::App& app);

struct Verb {
  const char* name;
  const char* description;
  Action (*declare)(CLI::App&);
};

struct VerbGroup {
  const char* title;
  std::vector<Verb> verbs;
};

/// All verbs, in the order in which they are listed.
const std::vector<VerbGroup>& verb_groups();

std::vector<std::string> verb_names();

/// The list of verbs with three examples.
std::string overview();

}  // namespace polhode::cli
