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

/// The growing files of a run: energies, trajectories and checkpoints. The files are created at the
/// first sample, after a checkpoint that records their start. Every file is therefore listed in a
/// checkpoint from its creation on.
class RunFiles {
 public:
  /// @param from  checkpoint to resume from; the files are truncated to the lengths in the
  ///   checkpoint
  /// @throws Error  if a file was changed; in this case no file is modified
  RunFiles(const RunFileNames& names, const Topology& topology, const Config& config,
           const Provenance& provenance, const std::string& identity,
           const FoundCheckpoint* from = nullptr);

  /// Stores the noise of the initial forces in every checkpoint.
  void keep(const ForceNoise& noise) { checkpoint_.noise = noise; }
  /// Stores the number of force evaluations of the minimisation in every checkpoint.
  void keep(std::uint64_t minimisation_evaluations) {
    checkpoint_.minimisation_evaluations = minimisation_evaluations;
  }

  /// Keeps the pressure tensor, if requested, of the state that sample() appends next.
  void load(const State& state, const Bodies& bodies, const Load& load) {
    if (columns_.pressure_tensor) pressure_tensor_ = pressure_tensor(state, bodies, load);
  }
  /// Appends energies, and a frame if it is due.
  /// @throws RunError  if the disk is full
  void sample(std::size_t step, const State& state, const Energies& energies);
  /// Whether the time between two checkpoints has passed.
  bool due() const;
  /// Syncs all files to disk, then writes the checkpoint.
  /// @throws RunError  if the disk is full
  void checkpoint(RunState at);
  /// The step of the last checkpoint; empty before the first checkpoint.
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
  EnergyColumns columns_;
  Mat3<double> pressure_tensor_{};  // of the next sample [kJ/mol/nm³]
  double interval_;                 // wall-clock time between checkpoints [s]
  std::size_t steps_per_frame_;
  bool others_;                    // whether checkpoints of another run may exist
  std::vector<std::string> last_;  // files that are written at the end of the run, unless the run
                                   // starts from them
  Checkpoint checkpoint_;          // the fields that all checkpoints of the run have in common
  std::optional<EnergyFile> energies_;
  std::vector<std::unique_ptr<FrameWriter>> trajectories_;
  std::size_t next_frame_ = 0;
  std::optional<std::size_t> last_checkpoint_step_;
  Stopwatch since_checkpoint_;
};

}  // namespace polhode
