// SPDX-License-Identifier: MIT
// Writes a commented run file to start from, for a kind of system or from GROMACS run parameters.
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

/// Writes a new run file. GROMACS parameters without a counterpart are listed in notes.
/// @param kind  one of run_file_kinds
/// @param file  path of the file; if empty, KIND.toml
/// @return      path of the file
/// @throws Error  if the kind or ensemble does not exist, or the file already exists
std::string new_run_file(const std::string& kind, const std::string& file,
                         const NewRunFileRequest& request, const Callbacks& callbacks = {});

}  // namespace polhode
