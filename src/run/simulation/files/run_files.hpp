// SPDX-License-Identifier: MIT
// The files of a run: created or resumed, appended to at samples, synced at checkpoints.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "polhode/run/simulation/files/energy_file.hpp"
#include "run/simulation/files/checkpoint.hpp"

namespace polhode {

/// The files that grow: energies, trajectories, checkpoints. They begin with the first sample,
/// after a checkpoint that records this; no file exists without a checkpoint that refers to it.
class RunFiles {
 public:
  /// @param from  checkpoint to resume from: the files are truncated to their lengths in it
  /// @throws Error  if one of them was changed; then none is modified
  RunFiles(const RunFileNames& names, const Topology& topology, const Config& config,
           const Provenance& provenance, const std::string& identity,
           const FoundCheckpoint* from = nullptr);

  /// Stores the noise of the initial forces in every checkpoint.
  void keep(const ForceNoise& noise) { checkpoint_.noise = noise; }
  /// Likewise the number of force evaluations of the minimisation.
  void keep(std::uint64_t minimisation_evaluations) {
    checkpoint_.minimisation_evaluations = minimisation_evaluations;
  }

  /// Appends energies, and a frame where one is due.
  /// @throws RunError  if there is no room
  void sample(std::size_t step, const State& state, const Energies& energies);
  /// Whether the time between two checkpoints has passed.
  bool due() const;
  /// Syncs all files to disk, then writes the checkpoint.
  /// @throws RunError  if there is no room
  void checkpoint(RunState at);
  /// The step of the last checkpoint; nothing before the first.
  std::optional<std::size_t> last_checkpoint_step() const { return last_checkpoint_step_; }
  /// Syncs all files to disk.
  void flush();

 private:
  void begin();
  void resume(const FoundCheckpoint& from);
  void reopen(const OutputMarks& marks);
  void remove_last() const;
  OutputMarks marks();

  RunFileNames names_;
  const Topology& topology_;
  FrameChoice choice_;
  Provenance provenance_;
  bool step_errors_;
  double interval_;  // between checkpoints [s]
  std::size_t steps_per_frame_;
  bool others_;                    // checkpoints of another run may exist
  std::vector<std::string> last_;  // files of the end of a run, unless it starts from them
  Checkpoint checkpoint_;          // the fields that are the same in all of them
  std::optional<EnergyFile> energies_;
  std::vector<std::unique_ptr<FrameWriter>> trajectories_;
  std::size_t next_frame_ = 0;
  std::optional<std::size_t> last_checkpoint_step_;
  Stopwatch since_checkpoint_;
};

}  // namespace polhode
