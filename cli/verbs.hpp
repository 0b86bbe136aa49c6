// SPDX-License-Identifier: MIT
// The verbs of the command line. A verb declares its options on a subcommand, and returns a
// function to call after parsing. The return value of the returned function is the exit code.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options/command.hpp"

namespace polhode::cli {

using Action = std::function<int()>;

struct Verb {
  const char* name;
  const char* description;
  Action (*declare)(Command&);
};

struct VerbGroup {
  const char* title;
  std::vector<Verb> verbs;
};

/// All verbs, in the order in which help lists them. The help, the overview, and the indices of the
/// manual and of the Python documentation are generated from this table.
const std::vector<VerbGroup>& verb_groups();

std::vector<std::string> verb_names();

/// Lists the verbs and shows three examples.
std::string overview();

}  // namespace polhode::cli
