// SPDX-License-Identifier: MIT
#include "run/simulation/files/checkpoint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/output_error.hpp"
#include "base/version.hpp"
#include "io/files/write_file.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/files/identity.hpp"

namespace polhode {
namespace {

// Visits the fields of a checkpoint in their order, for both writing and reading.

template <class Archive, class Counter>
void counter(Archive& archive, Counter& n) {
  auto value = static_cast<std::uint64_t>(n);
  archive(value);
  if constexpr (!std::is_const_v<Counter>) n = static_cast<Counter>(value);
}

/// Visits fields one after the other. Integers and enumerations have 64 bits in the file.
template <class Archive, class... Fields>
void each(Archive& archive, Fields&... fields) {
  const auto visit = [&](auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_enum_v<Field> ||
                  (std::is_integral_v<Field> && !std::is_same_v<Field, bool>))
      counter(archive, field);
    else
      archive(field);
  };
  (visit(fields), ...);
}

template <class Archive, class Optional, class Fields>
void optional(Archive& archive, Optional& value, const Fields& fields) {
  bool there = value.has_value();
  archive(there);
  if constexpr (!std::is_const_v<Optional>) {
    value.reset();
    if (there) value.emplace();
  }
  if (there) fields(*value);
}

template <class Archive, class List, class Fields>
void list(Archive& archive, List& values, const Fields& fields) {
  std::size_t count = values.size();
  counter(archive, count);
  for (std::size_t k = 0; k < count; ++k) {
    if constexpr (!std::is_const_v<List>)
      values.resize(k + 1);  // not more values than the file has
    fields(values[k]);
  }
}

template <class Archive, class Of>
void state(Archive& archive, Of& s) {
  each(archive, s.q, s.p, s.orientation, s.ell, s.box.edge, s.time);
}

template <class Archive, class Of>
void memory(Archive& archive, Of& m) {
  auto& load = m.load;
  each(archive, load.f, load.tau, load.van_der_waals, load.coulomb, load.mesh, load.external,
       load.virial[0], load.virial[1], load.virial[2]);
  each(archive, m.current, m.complete, m.steps, m.evaluations, m.derivatives, m.measurements);
}

template <class Archive, class Of>
void blocks(Archive& archive, Of& of) {
  archive(of.samples_per_block);
  list(archive, of.blocks, [&](auto& block) {
    archive(block.weight);
    list(archive, block.sum, [&](auto& x) { archive(x); });
  });
}

template <class Archive, class Of>
void energies(Archive& archive, Of& e) {
  each(archive, e.time, e.van_der_waals, e.coulomb, e.translation, e.rotation[0], e.rotation[1],
       e.rotation[2], e.pressure, e.volume, e.exchanged, e.external);
}

template <class Archive, class Of>
void statistics(Archive& archive, Of& s) {
  for (auto* sums : {&s.energies, &s.at_bath}) {
    counter(archive, sums->samples);
    energies(archive, sums->first);
    blocks(archive, sums->blocks);
  }
  each(archive, s.shadow.samples, s.shadow.first, s.shadow.start);
  blocks(archive, s.shadow.blocks);
  blocks(archive, s.configurational.blocks);
  for (auto* response : {&s.step_bias.response, &s.configurational.response}) {
    list(archive, response->first, [&](auto& x) { archive(x); });
    blocks(archive, response->blocks);
  }
  each(archive, s.stretches.samples, s.stretches.stretches);
  for (auto& x : s.stretches.sums) archive(x);
  each(archive, s.stretches.mean, s.stretches.squares);
}

template <class Archive, class Of>
void ensemble(Archive& archive, Of& e) {
  auto& barostat = e.barostat;
  each(archive, e.heat, barostat.work, barostat.edges, barostat.moves, barostat.accepted,
       barostat.evaluations);
  blocks(archive, barostat.decisions);
  each(archive, barostat.beyond_shape, e.hybrid.work, e.hybrid.trajectories, e.hybrid.accepted);
  blocks(archive, e.hybrid.weights);
}

template <class Archive, class Of>
void run_state(Archive& archive, Of& at) {
  state(archive, at.state);
  optional(archive, at.equilibrated, [&](auto& time) { archive(time); });
  each(archive, at.steps, at.start);
  memory(archive, at.integrator);
  list(archive, at.integrator.inner, [&](auto& within) { memory(archive, within); });
  each(archive, at.list.built_at, at.list.rebuilds, at.near_list.built_at, at.near_list.rebuilds);
  statistics(archive, at.statistics);
  each(archive, at.timings.forces, at.timings.list, at.timings.motion, at.timings.measurement,
       at.timings.near);
  ensemble(archive, at.ensemble);
  each(archive, at.segment.number, at.segment.first_step, at.segment.earlier, at.segment.changes);
}

template <class Archive, class Of>
void mark(Archive& archive, Of& m) {
  each(archive, m.frames, m.bytes, m.checksum);
}

template <class Archive, class Of>
void output_marks(Archive& archive, Of& marks) {
  mark(archive, marks.energies);
  list(archive, marks.frames, [&](auto& file) { mark(archive, file); });
  counter(archive, marks.next_frame);
}

template <class Archive, class Of>
void steepness(Archive& archive, Of& s) {
  each(archive, s.potential, s.force, s.torque);
}

template <class Archive, class Of>
void preparation(Archive& archive, Of& p) {
  each(archive, p.stage, p.step, p.compressibility);
  steepness(archive, p.minimisation.before), steepness(archive, p.minimisation.after);
  each(archive, p.minimisation.steps, p.minimisation.end);
}

template <class Archive, class Of>
void fields(Archive& archive, Of& c) {
  each(archive, c.identity, c.command);
  run_state(archive, c.at);
  each(archive, c.noise.power, c.noise.energy, c.minimisation_evaluations);
  optional(archive, c.outputs, [&](auto& marks) { output_marks(archive, marks); });
  optional(archive, c.preparation, [&](auto& progress) { preparation(archive, progress); });
}

/// The orientations of an initial configuration, and its velocities if given, as text. Random
/// velocities are omitted, because they follow from the seed. Numbers have nine digits: more than
/// in text formats, but few enough to be the same on all processors.
std::string motion_of_start(const Config& config, const System& system) {
  std::string text;
  if (config.system.initial_configuration.empty()) return text;
  const auto add = [&](const Vec3<double>& v) {
    text += fmt::format(" {:.9e} {:.9e} {:.9e}", v.x, v.y, v.z);
  };
  const State& s = system.state;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Quaternion<double> a = s.orientation[i];
    text += fmt::format(" {:.9f}", a.w);
    add({a.x, a.y, a.z});
    if (!system.new_velocities) add(s.p[i]), add(s.ell[i]);
  }
  return text;
}

/// The contents of trajectories as text: files, sites and names, with or without velocities.
std::string outputs_of(const OutputSettings& output, const Topology& topology) {
  std::string text;
  if (output.trajectory_every == 0) return text;
  for (const std::string& format : output.formats) text += ' ' + format;
  if (!output.massless_sites) text += " without massless sites";
  if (!output.velocities) text += " without velocities";
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites) text += ' ' + site.name + ' ' + site.element;
  return text;
}

/// Whether all blocks read from a file have as many sums as a new object.
bool fit(const TimeBlocks& blocks, const TimeBlocks& fresh) {
  const std::size_t sums = fresh.blocks.front().sum.size();
  return blocks.samples_per_block >= 1 &&
         std::all_of(blocks.blocks.begin(), blocks.blocks.end(), [&](const auto& block) {
           return block.weight > 0 && block.sum.size() == sums;
         });
}

/// Whether a response read from a file is empty, or has as many sums as a new response.
bool fit(const StepResponse& read, const StepResponse& fresh) {
  return read.first.size() == (read.blocks.blocks.empty() ? 0 : fresh.first.size()) &&
         fit(read.blocks, fresh.blocks);
}

bool fit(const EnsembleMemory& read) {
  EnsembleMemory fresh;
  fresh.hybrid.add(0, true);
  fresh.barostat.decisions.add(std::array{1.0});
  return fit(read.hybrid.weights, fresh.hybrid.weights) &&
         fit(read.barostat.decisions, fresh.barostat.decisions);
}

bool fit(const TrajectoryStatistics& read) {
  TrajectoryStatistics fresh;
  fresh.energies.add({});
  fresh.shadow.add(0, 0);
  fresh.step_bias.add({}, {});
  fresh.configurational.add({}, StepError{});
  return fit(read.energies.blocks, fresh.energies.blocks) &&
         fit(read.at_bath.blocks, fresh.energies.blocks) &&
         fit(read.shadow.blocks, fresh.shadow.blocks) &&
         fit(read.configurational.blocks, fresh.configurational.blocks) &&
         fit(read.step_bias.response, fresh.step_bias.response) &&
         fit(read.configurational.response, fresh.configurational.response);
}

Checkpoint read_checkpoint_from(CheckpointReader in, const std::string& path) {
  Checkpoint checkpoint;
  fields(in, checkpoint);
  in.end();
  if (!fit(checkpoint.at.statistics) || !fit(checkpoint.at.ensemble))
    throw DamagedCheckpoint(
        fmt::format("the checkpoint '{}' has inconsistent sums over samples", path));
  return checkpoint;
}

}  // namespace

std::string run_identity(const Config& config, const System& system) {
  std::string all =
      identity(config, system,
               {config.integrator.step, config.run.equilibrate, config.run.sample,
                config.run.shadow_sample.value_or(-1), config.run.configurational_sample,
                config.output.trajectory_every, config.forces.skin});
  all += ' ' + text_of(config.integrator.scheme);
  all += motion_of_start(config, system) + outputs_of(config.output, system.topology);
  Config used = config;  // with the mixing rule that molecule files may state
  used.forces.mixing.rule = system.forces.mixing.rule;
  return text_hash(all) + '\n' + settings_text(used);
}

ProgramVersion this_program() { return {version(), name(current_instruction_set())}; }

void write_checkpoint(const CheckpointFiles& files, const Checkpoint& checkpoint,
                      const ProgramVersion& program) {
  write_file(
      files.newest,
      [&](std::ostream& out) {
        CheckpointWriter writer(out, program);
        fields(writer, checkpoint);
        writer.end();
      },
      files.previous);
}

Checkpoint read_checkpoint(const std::string& path, const ProgramVersion& reader) {
  return read_checkpoint_from(CheckpointReader(path, reader), path);
}

State state_of_checkpoint(const std::string& path, const std::string& version) {
  return read_checkpoint(path, {version, any_instruction_set}).at.state;
}

Checkpoint parse_checkpoint(std::string bytes, const std::string& path,
                            const ProgramVersion& reader) {
  return read_checkpoint_from(CheckpointReader(std::move(bytes), path, reader), path);
}

Checkpoint read_checkpoint_of(const std::string& path, const std::string& identity,
                              const ProgramVersion& reader) {
  Checkpoint checkpoint = read_checkpoint(path, reader);
  if (!same_run(checkpoint.identity, identity)) {
    const std::string settings = differences(checkpoint.identity, identity);
    throw OutputError(fmt::format(
        "the checkpoint '{}' is from another run, started with '{}': {}; give the run file and the "
        "options of that run, give another output, or start over",
        path, checkpoint.command,
        settings.empty() ? "molecules, pair parameters, initial configuration or velocities differ"
                         : settings));
  }
  return checkpoint;
}

std::optional<FoundCheckpoint> last_checkpoint(const CheckpointFiles& files,
                                               const std::string& identity,
                                               const ProgramVersion& reader) {
  if (!std::filesystem::exists(files.newest) && !std::filesystem::exists(files.previous))
    return std::nullopt;
  std::string damage;
  try {
    return FoundCheckpoint{read_checkpoint_of(files.newest, identity, reader), {}};
  } catch (const DamagedCheckpoint& e) {
    damage = e.what();
  }
  try {
    return FoundCheckpoint{read_checkpoint_of(files.previous, identity, reader),
                           fmt::format("{}; the run resumes from the previous checkpoint, '{}', "
                                       "which is intact; the results will be the same",
                                       damage, files.previous)};
  } catch (const DamagedCheckpoint& e) {
    throw OutputError(fmt::format("{}, and {}; start over, or start a new run from the last frame",
                                  damage, e.what()));
  }
}

}  // namespace polhode
