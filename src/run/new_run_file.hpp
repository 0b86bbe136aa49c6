// SPDX-License-Identifier: MIT
// A commented run file to start from, of a kind or from the run parameters of GROMACS.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/callbacks.hpp"
#include "run/given.hpp"

namespace polhode {

struct NewRunFileRequest {
  Given ensemble, mdp;

  static std::vector<RequestOption<NewRunFileRequest>> options();
};

/// Writes a run file. Parameters of GROMACS without counterpart are notes.
/// @param kind  one of run_file_kinds
/// @param file  empty: KIND.toml
/// @return      the name of the file
/// @throws Error  if there is no such kind or ensemble, or the file exists
std::string new_run_file(const std::string& kind, const std::string& file,
                         const NewRunFileRequest& request, const Callbacks& callbacks = {});

}  // namespace polhode
