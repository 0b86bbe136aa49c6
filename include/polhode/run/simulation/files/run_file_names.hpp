// SPDX-License-Identifier: MIT
// The names of the files of a run.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Paths of the checkpoints of a run: the newest checkpoint, and the previous checkpoint.
struct CheckpointFiles {
  std::string newest, previous;
};

/// Paths of the files of a run, by their purpose.
struct RunFileNames {
  std::string energies, final_state;
  std::string script, plot;  ///< empty if no figure is requested
  std::vector<std::string> trajectories;
  CheckpointFiles checkpoints;

  explicit RunFileNames(const OutputSettings& output);
  std::vector<std::string> all() const;
};

}  // namespace polhode
