// SPDX-License-Identifier: MIT
#include "run/simulation/files/run_files.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "io/files/checksum.hpp"
#include "io/files/disk.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {
namespace {

/// The energies that are written to trajectories in addition to the atoms.
std::vector<FrameNumber> observables(const Energies& e) {
  return {{"potential_energy", "kJ mol-1", e.potential()},
          {"kinetic_energy", "kJ mol-1", e.kinetic()},
          {"total_energy", "kJ mol-1", e.total()}};
}

/// The columns of the energies file. At constant energy the file has no column of time-step errors,
/// because the errors follow from the total energy.
EnergyColumns columns_of(const Config& config) {
  const TrajectorySettings settings = trajectory_settings(config);
  return {settings.shadow_sample > 0 && !settings.ensemble.constant_energy(),
          config.output.pressure_tensor};
}

/// The files that a run writes at the end, except for files that the run also reads. Existing files
/// are removed, because they belong to an earlier run and would remain if this run blew up.
std::vector<std::string> last_files(const RunFileNames& names, const SystemSettings& inputs) {
  std::vector<std::string> files;
  for (const std::string& file : {names.final_state, names.plot}) {
    std::error_code unknown;
    if (!file.empty() &&
        !std::filesystem::equivalent(file, inputs.initial_configuration, unknown) &&
        !std::filesystem::equivalent(file, inputs.topology.file, unknown))
      files.push_back(file);
  }
  return files;
}

}  // namespace

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

RunFiles::RunFiles(const RunFileNames& names, const Topology& topology, const Config& config,
                   const Provenance& provenance, const std::string& identity,
                   const FoundCheckpoint* from)
    : names_(names),
      topology_(topology),
      choice_(config.output.choice()),
      provenance_(provenance),
      columns_(columns_of(config)),
      interval_(config.output.checkpoint_every),
      steps_per_frame_(static_cast<std::size_t>(
          std::max(1.0, config.output.trajectory_every / config.integrator.step + 1e-9))),
      others_(from == nullptr),
      last_(last_files(names, config.system)),
      checkpoint_{.identity = identity, .command = provenance.command} {
  if (from) resume(*from);
}

void RunFiles::resume(const FoundCheckpoint& from) {
  const Checkpoint& then = from.checkpoint;
  checkpoint_.noise = then.noise;
  checkpoint_.minimisation_evaluations = then.minimisation_evaluations;
  checkpoint_.command = provenance_.command = then.command;
  last_checkpoint_step_ = then.at.steps;
  if (then.outputs) {
    const OutputMarks& marks = *then.outputs;
    check_crc64(names_.energies, 0, marks.energies.bytes, marks.energies.checksum);
    for (std::size_t k = 0; k < marks.frames.size(); ++k)
      check_frames(names_.trajectories[k], marks.frames[k]);
    check_energies(names_.energies, columns_, marks.energies);
    reopen(marks);
  }
  remove_last();
  // The intact checkpoint replaces the damaged newest checkpoint, which must not become the
  // previous checkpoint.
  if (!from.note.empty())
    std::filesystem::rename(names_.checkpoints.previous, names_.checkpoints.newest);
}

void RunFiles::remove_last() const {
  for (const std::string& file : last_) remove_output(file);
}

void RunFiles::reopen(const OutputMarks& marks) try {
  energies_.emplace(names_.energies, topology_, columns_, marks.energies);
  for (std::size_t k = 0; k < marks.frames.size(); ++k)
    trajectories_.push_back(
        resume_frames(names_.trajectories[k], topology_, marks.frames[k], choice_));
  next_frame_ = marks.next_frame;
} catch (const Error& e) {  // files have been truncated, so the failure must be reported
  throw RunError(e.what());
}

void RunFiles::begin() try {
  energies_.emplace(names_.energies, topology_, columns_, provenance_);
  for (const std::string& path : names_.trajectories)
    trajectories_.push_back(create_frames(path, topology_, choice_));
} catch (const Error& e) {  // a checkpoint exists, so the run can be resumed when there is disk
                            // space
  throw RunError(e.what());
}

void RunFiles::sample(std::size_t step, const State& state, const Energies& energies) {
  if (!energies_) begin();
  energies_->add(energies, pressure_tensor_);
  if (trajectories_.empty() || step < next_frame_) return;
  for (const auto& trajectory : trajectories_) trajectory->write(state, observables(energies));
  next_frame_ = step + steps_per_frame_;
}

bool RunFiles::due() const { return since_checkpoint_.seconds() >= interval_; }

OutputMarks RunFiles::marks() {
  OutputMarks marks{.energies = energies_->mark(), .next_frame = next_frame_};
  for (const auto& trajectory : trajectories_) marks.frames.push_back(trajectory->mark());
  return marks;
}

void RunFiles::checkpoint(RunState at) {
  if (std::exchange(others_, false)) {
    for (const std::string& file : {names_.checkpoints.newest, names_.checkpoints.previous})
      remove_output(file);
    remove_last();
  }
  checkpoint_.at = std::move(at);
  if (energies_) checkpoint_.outputs = marks();
  write_checkpoint(names_.checkpoints, checkpoint_);
  last_checkpoint_step_ = checkpoint_.at.steps;
  checkpoint_.at = {};
  since_checkpoint_ = Stopwatch();
}

void RunFiles::flush() {
  if (energies_) marks();
}

}  // namespace polhode
