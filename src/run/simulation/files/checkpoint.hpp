// SPDX-License-Identifier: MIT
// Checkpoints of a run: the state of the run, the positions in its files, and the identity of the
// run.
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

/// Positions in the output files of a run.
struct OutputMarks {
  FileMark energies;             ///< number of rows and bytes in the energies file
  std::vector<FileMark> frames;  ///< position in each trajectory file
  std::size_t next_frame = 0;    ///< earliest step at which the next frame is written
};

/// The progress of a preparation, in addition to the RunState of its current stage.
struct PreparationProgress {
  std::size_t stage = 0;       ///< index of the current stage; the number of stages at the end
  double step = 0;             ///< time step of this stage [ps]
  double compressibility = 0;  ///< estimated compressibility for the barostat, or 0
                               ///< [nm³ mol/kJ]
  Minimisation minimisation;
};

struct Checkpoint {
  std::string identity;  ///< identity of the run, see run_identity()
  std::string command;   ///< command with which the run began
  RunState at;
  ForceNoise noise;
  std::uint64_t minimisation_evaluations = 0;  ///< force evaluations before the trajectory
  std::optional<OutputMarks> outputs;  ///< positions in the outputs; empty before they begin
  std::optional<PreparationProgress> preparation;  ///< progress of a preparation; empty for a run
};

/// The identity of a run: a hash, followed by settings_text(). The identity must be the same when
/// the run is resumed. The identity depends on molecules, initial configuration with velocities,
/// forces, scheme, step and equilibration. The identity also depends on the kinds and intervals of
/// outputs, but not on the length of the run.
std::string run_identity(const Config& config, const System& system);

/// This program, as the writer or reader of checkpoints.
ProgramVersion this_program();

/// Writes a checkpoint, completely or not at all. The newest checkpoint so far is kept as the
/// previous checkpoint.
/// @throws RunError  if the file cannot be written
void write_checkpoint(const CheckpointFiles& files, const Checkpoint& checkpoint,
                      const ProgramVersion& program = this_program());

/// Reads a checkpoint.
/// @throws DamagedCheckpoint  if the file is missing, truncated or changed
/// @throws Error              if another program wrote it
Checkpoint read_checkpoint(const std::string& path, const ProgramVersion& reader);
/// Reads a checkpoint from bytes that were already read from the file `path`.
Checkpoint parse_checkpoint(std::string bytes, const std::string& path,
                            const ProgramVersion& reader);

/// Reads only the state from a checkpoint. The checkpoint may be from any run of this version, with
/// any instruction set.
/// @throws Error  if the file is damaged, or of another version
State state_of_checkpoint(const std::string& path, const std::string& version);

/// Reads the checkpoint of a given run.
/// @throws Error  if another run wrote the checkpoint
Checkpoint read_checkpoint_of(const std::string& path, const std::string& identity,
                              const ProgramVersion& reader = this_program());

struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::string note;  ///< reason why the previous checkpoint is used; empty for the newest
};

/// Finds the newest checkpoint of a run, or the previous checkpoint if the newest checkpoint is
/// damaged. If the previous checkpoint is used, the steps after this checkpoint are computed again,
/// with bitwise identical results. The result is empty if there is no checkpoint.
/// @throws Error  if both checkpoints are damaged, or another run, program or instruction set wrote
///   them
std::optional<FoundCheckpoint> last_checkpoint(const CheckpointFiles& files,
                                               const std::string& identity,
                                               const ProgramVersion& reader = this_program());

}  // namespace polhode
