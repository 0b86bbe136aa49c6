// SPDX-License-Identifier: MIT
// The files of a run: which there are, and how they grow with it and with its checkpoints.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/run/simulation/checkpoint.hpp"
#include "polhode/run/simulation/energy_file.hpp"

namespace polhode {

/// Names of the files of a run, by their use.
struct RunFileNames {
  std::string energies, final_state;
  std::string script, plot;  ///< empty if no figure is requested
  std::vector<std::string> trajectories;
  CheckpointFiles checkpoints;

  explicit RunFileNames(const OutputSettings& output);
  std::vector<std::string> all() const;
};

/// The files that grow: energies, trajectories, checkpoints. They begin with the first sample,
/// after a checkpoint that says so; nothing is on the disk without a checkpoint that knows of it.
class RunFiles {
 public:
  /// @param from  resumes the files at their lengths then; what was written later is removed
  /// @throws Error  if one of them was changed; then none is modified
  RunFiles(const RunFileNames& names, const Topology& topology, const Config& config,
           const Provenance& provenance, const std::string& identity,
           const FoundCheckpoint* from = nullptr);

  /// Keeps the noise of the forces at the start with every checkpoint.
  void keep(const ForceNoise& noise) { checkpoint_.noise = noise; }

  /// Appends energies, and a frame where one is due.
  /// @throws RunError  if there is no room
  void sample(std::size_t step, const State& state, const Energies& energies);
  /// Whether the time between two checkpoints has passed.
  bool due() const;
  /// Brings all files to the disk, then writes the checkpoint.
  /// @throws RunError  if there is no room
  void checkpoint(RunState at);
  /// Until which step the last checkpoint reaches; nothing before the first.
  std::optional<std::size_t> last_checkpoint_step() const { return last_checkpoint_step_; }
  /// Brings what there is to the disk.
  void flush();

 private:
  void begin();
  void resume(const FoundCheckpoint& from);
  void reopen(const OutputMarks& marks);
  OutputMarks marks();

  RunFileNames names_;
  const Topology& topology_;
  FrameChoice choice_;
  Provenance provenance_;
  double interval_;  // between checkpoints [s]
  std::size_t steps_per_frame_;
  bool others_;            // checkpoints of another run may be there
  Checkpoint checkpoint_;  // what all of them have in common
  std::optional<EnergyFile> energies_;
  std::vector<std::unique_ptr<FrameWriter>> trajectories_;
  std::size_t next_frame_ = 0;
  std::optional<std::size_t> last_checkpoint_step_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace polhode
