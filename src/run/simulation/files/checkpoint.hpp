// SPDX-License-Identifier: MIT
// Checkpoints of a run: where it stands, where its files stand, and which run it is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files/checkpoint_file.hpp"
#include "polhode/ensemble/minimise.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/run/simulation/files/run_file_names.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// How far the files of a run have come.
struct OutputMarks {
  FileMark energies;             ///< rows of the table and bytes
  std::vector<FileMark> frames;  ///< of each trajectory file
  std::size_t next_frame = 0;    ///< step from which on a sample is written as a frame
};

/// How far a preparation has come, besides the RunState of its current stage.
struct PreparationProgress {
  std::size_t stage = 0;       ///< in progress, from 0; the number of stages once all are done
  double step = 0;             ///< of its dynamics [ps]
  double compressibility = 0;  ///< of its barostat if estimated, otherwise 0 [nm³ mol/kJ]
  Minimisation minimisation;
};

struct Checkpoint {
  std::string identity;  ///< of the run, see run_identity()
  std::string command;   ///< with which it began
  RunState at;
  ForceNoise noise;
  std::uint64_t minimisation_evaluations = 0;      ///< of forces, before the trajectory
  std::optional<OutputMarks> outputs;              ///< nothing before they begin
  std::optional<PreparationProgress> preparation;  ///< only of a preparation
};

/// What must be the same for a run to resume, as a hash and settings_text(): molecules, initial
/// configuration with its velocities, forces, scheme, step, equilibration, and what is written how
/// often; not its length.
std::string run_identity(const Config& config, const System& system);

/// Writes a checkpoint, whole or not at all; the newest one becomes the previous one.
/// @throws RunError  if that cannot be done
void write_checkpoint(const CheckpointFiles& files, const Checkpoint& checkpoint,
                      const ProgramVersion& program);

/// @throws DamagedCheckpoint  if the file is missing, truncated or changed
/// @throws Error              if another program wrote it
Checkpoint read_checkpoint(const std::string& path, const ProgramVersion& reader);
/// The same for bytes that were read from `path`.
Checkpoint parse_checkpoint(std::string bytes, const std::string& path,
                            const ProgramVersion& reader);

/// The state of a checkpoint of any run of this version, written with any instruction set.
/// @throws Error  if the file is damaged, or of another version
State state_of_checkpoint(const std::string& path, const std::string& version);

/// The same for the checkpoint of one run.
/// @throws Error  if another run wrote it
Checkpoint read_checkpoint_of(const std::string& path, const std::string& identity,
                              const ProgramVersion& reader);

struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::string note;  ///< why it is the previous one; empty if it is the newest
};

/// The newest checkpoint of a run, or the previous one where that is damaged: what follows it is
/// computed again, to the same bits. Nothing if there is neither.
/// @throws Error  if both are damaged, or another run, program or instruction set wrote it
std::optional<FoundCheckpoint> last_checkpoint(const CheckpointFiles& files,
                                               const std::string& identity,
                                               const ProgramVersion& reader);

}  // namespace polhode
