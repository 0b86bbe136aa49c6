// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/files/run_file_names.hpp"

namespace polhode {

RunFileNames::RunFileNames(const OutputSettings& output)
    : energies(output.prefix + "-energies.csv"),
      final_state(output.prefix + "-final.gro"),
      checkpoints{output.prefix + "-checkpoint.bin", output.prefix + "-checkpoint-previous.bin"} {
  if (output.plot != "none") {
    script = output.prefix + "-energies.gp";
    plot = output.prefix + "-energies." + output.plot;
  }
  if (output.trajectory_every > 0)
    for (const std::string& format : output.formats)
      trajectories.push_back(output.prefix + "-trajectory." + format);
}

std::vector<std::string> RunFileNames::all() const {
  std::vector<std::string> files = trajectories;
  files.push_back(energies);
  files.push_back(final_state);
  if (!plot.empty()) files.insert(files.end(), {script, plot});
  files.insert(files.end(), {checkpoints.newest, checkpoints.previous});
  return files;
}

}  // namespace polhode
