// SPDX-License-Identifier: MIT
#include "polhode/run/properties/measure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>

#include "base/stopwatch.hpp"
#include "io/files/draft.hpp"
#include "io/files/with_error.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "run/output_files.hpp"
#include "run/properties/coupling.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/expected_time.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica.hpp"
#include "run/properties/replica_file.hpp"
#include "run/properties/schedule.hpp"
#include "run/properties/second_virial.hpp"
#include "run/properties/target.hpp"

namespace polhode {
namespace {

/// Minimum time between two writes of a record [s]; a segment may take only milliseconds.
constexpr double writing_interval = 2;
/// As many steps of hoa2 have the force evaluations of a pilot's preparation.
constexpr double steps_of_pilot(bool step_is_given) {
  return step_is_given ? steps_of_preparation : 15'000;
}

/// Measures a state point.
class PointMeasurement {
 public:
  PointMeasurement(const MeasureSettings& settings, std::size_t point, const Callbacks& callbacks,
                   Workers& workers, const ReplicaExecutor& executor, const Stopwatch& since)
      : settings_(settings),
        point_(point),
        callbacks_(callbacks),
        workers_(workers),
        executor_(executor),
        since_(since),
        system_(settings, settings.points[point]),
        schedule_(settings) {
    system_.common.stop = [this] { return stopped(); };
    std::vector<std::string> files;
    for (std::uint64_t k = settings.shard.index; k < settings.replicas; k += settings.shard.count)
      files.push_back(file_of(k));
    remove_drafts(files);
    for (std::uint64_t k = settings.shard.index; k < settings.replicas; k += settings.shard.count)
      replicas_.push_back(read_replica(file_of(k), k, system_.identity));
    if (settings.only_evaluate) leave_out_missing();
  }

  MeasuredPoint perform();
  bool out_of_time() const {
    return settings_.time_limit > 0 && since_.seconds() > settings_.time_limit;
  }
  std::vector<std::string> files() const;

 private:
  bool stopped() const { return callbacks_.stopped() || out_of_time(); }
  const StatePoint& at() const { return system_.common.at; }
  std::string file_of(std::uint64_t k) const {
    const std::string number = k == pilot ? "pilot" : fmt::format("r{}", k);
    return fmt::format("{}-{}-{}.replica", settings_.prefix, at().file_text(), number);
  }
  bool all_have(const Target& target) const {
    return std::ranges::all_of(replicas_, [&](const Replica& r) { return has(r, target); });
  }
  void leave_out_missing();
  std::optional<double> choose_step();
  bool choose_path();
  void show_plan(const Target& target, std::optional<double> seconds_per_step) const;
  TimeAllowed allowed() const;
  WorkDone work_of(const Target& target) const;
  void show_time(const std::vector<MeasuredProperty>& values, const Target& target);
  void begin(Target& target);
  bool extend_to(Target& target);
  void extend(const Target& target);
  void extend_in_turn(const Target& target);
  std::optional<std::size_t> take_shortest(const Target& target);
  void extend_taken(std::size_t k, const Target& target);
  void execute(const Target& target);
  void write(const Replica& replica) const {
    write_replica(file_of(replica.index), replica, system_.identity);
  }
  void keep(Replica& replica, Replica changed);
  std::vector<Replica> first_of(const Target& target) const;
  std::vector<MeasuredProperty> evaluate(std::span<const Replica> replicas) const;
  void show(const std::vector<MeasuredProperty>& values, const Target& target,
            bool equilibrium) const;
  void warn_of_tension() const;
  PointData data(std::span<const Replica> replicas) const {
    return {system_.topology,
            system_.mixing,
            at(),
            replicas,
            [this] { return stopped(); },
            [this] { return second_virial_of_liquid(); }};
  }
  /// The second virial coefficient of the first kind of molecule, which is computed once.
  Estimate second_virial_of_liquid() const;

  const MeasureSettings& settings_;
  std::size_t point_;
  const Callbacks& callbacks_;
  Workers& workers_;
  const ReplicaExecutor& executor_;
  const Stopwatch& since_;
  PointSystem system_;
  Schedule schedule_;
  std::vector<Replica> replicas_;
  std::vector<bool> is_taken_;  // whether a thread extends a replica
  std::vector<Stopwatch> since_written_;
  std::mutex guard_;
  double done_ = 0, planned_ = 0;   // steps of this round: done and planned
  double seconds_ = 0, steps_ = 0;  // of all rounds, as far as they were computed here
  bool has_warned_ = false;
  mutable std::optional<Estimate> second_virial_;
};

Estimate PointMeasurement::second_virial_of_liquid() const {
  if (second_virial_) return *second_virial_;
  constexpr std::size_t orientations = 4096;
  const Estimate B =
      second_virial(system_.topology.parts.front().molecule, system_.mixing, at().temperature,
                    orientations, workers_, [this] { return stopped(); });
  if (std::isfinite(B.value)) second_virial_ = B;
  return B;
}

std::vector<std::string> PointMeasurement::files() const {
  std::vector<std::string> files;
  for (const Replica& replica : replicas_)
    if (replica.prepared()) files.push_back(file_of(replica.index));
  return files;
}

/// Removes replicas without records from the evaluation, and gives a note with their names.
void PointMeasurement::leave_out_missing() {
  std::vector<std::string> missing;
  for (const Replica& replica : replicas_)
    if (!replica.prepared()) missing.push_back(fmt::format("'{}'", file_of(replica.index)));
  if (missing.size() == replicas_.size())
    throw Error(
        fmt::format("there is no record {}; give the same system, state points and output as in "
                    "the measurement",
                    missing.front()));
  if (missing.empty()) return;
  callbacks_.note(fmt::format(
      "{}: {} of {} replicas have no record: {}; run 'polhode measure' with their shards, and "
      "merge again",
      at().text(), missing.size(), replicas_.size(), fmt::join(missing, ", ")));
  std::erase_if(replicas_, [](const Replica& replica) { return !replica.prepared(); });
}

/// Takes the time step from the pilot. A pilot without a record is prepared first.
/// @return  time of the preparation [s]; empty if it was not needed or was stopped
std::optional<double> PointMeasurement::choose_step() {
  const Stopwatch watch;
  Replica first = read_replica(file_of(pilot), pilot, system_.identity);
  const bool is_new = !first.prepared();
  if (is_new) {
    callbacks_.note(fmt::format("{}: a pilot chooses the time step", at().text()));
    if (!prepare(first, system_.common)) return std::nullopt;
    write(first);
  }
  for (const Replica& replica : replicas_)
    if (replica.prepared() && first.prepared() && replica.step != first.step)
      throw Error(fmt::format(
          "'{}' has the time step {:g} fs, and its pilot '{}' {:g} fs; restore the pilot of this "
          "record, or give another prefix of the output files",
          file_of(replica.index), replica.step * units::fs_per_ps, file_of(pilot),
          first.step * units::fs_per_ps));
  system_.common.step = first.step;
  system_.common.path = first.coupled.path;
  return is_new ? std::optional(watch.seconds()) : std::nullopt;
}

/// Takes the stages of a coupling from the pilot, which chooses them first if it has none.
/// @return  false if it was stopped
bool PointMeasurement::choose_path() {
  if (!system_.common.path.empty()) return true;
  callbacks_.note(fmt::format("{}: the pilot chooses the stages of the coupling", at().text()));
  Replica first = read_replica(file_of(pilot), pilot, system_.identity);
  if (!choose_stages(first, system_.common)) return false;
  write(first);
  system_.common.path = first.coupled.path;
  return true;
}

/// Stores a changed replica, and reports the progress of the round.
void PointMeasurement::keep(Replica& replica, Replica changed) {
  const std::lock_guard lock(guard_);
  done_ += steps_of(changed) - steps_of(replica);
  replica = std::move(changed);
  callbacks_.report({"measuring", std::min(1.0, done_ / planned_), at().text()});
}

/// Extends replicas piece by piece, always the one that lacks most. If there is not enough time,
/// all replicas have then nearly the same length, without which no error is known.
void PointMeasurement::extend_in_turn(const Target& target) {
  is_taken_.assign(replicas_.size(), false);
  since_written_.assign(replicas_.size(), {});
  workers_.each(replicas_.size(), [&](std::size_t) {
    while (const std::optional<std::size_t> k = take_shortest(target)) extend_taken(*k, target);
  });
  for (const Replica& replica : replicas_)
    if (replica.prepared() && planned_ > 0) write(replica);
}

/// Takes the replica that lacks most, among replicas that no other thread extends.
/// @return  empty if none lacks anything, or if the measurement is stopped
std::optional<std::size_t> PointMeasurement::take_shortest(const Target& target) {
  const std::lock_guard lock(guard_);
  std::optional<std::size_t> shortest;
  std::size_t most = 0;
  for (std::size_t k = 0; k < replicas_.size(); ++k)
    if (const std::size_t n = missing(replicas_[k], target); n > most && !is_taken_[k])
      shortest = k, most = n;
  if (!shortest || stopped()) return std::nullopt;
  is_taken_[*shortest] = true;
  return shortest;
}

/// Extends a replica by one piece, and writes its record from time to time.
void PointMeasurement::extend_taken(std::size_t k, const Target& target) {
  Replica changed = replicas_[k];
  if (extend_by_one(changed, target, system_.common)) {
    keep(replicas_[k], std::move(changed));
    if (since_written_[k].seconds() > writing_interval) {
      write(replicas_[k]);
      since_written_[k].lap();
    }
  }
  const std::lock_guard lock(guard_);
  is_taken_[k] = false;
}

/// Extends replicas by an executor, a few segments at a time, so that little is lost if the
/// executor is killed.
void PointMeasurement::execute(const Target& target) {
  while (!stopped()) {
    std::vector<ReplicaTask> tasks;
    std::vector<Replica*> of;
    for (Replica& r : replicas_) {
      if (has(r, target)) continue;
      tasks.push_back(next_task(r, target, system_.common, system_.identity));
      tasks.back().point = point_;
      of.push_back(&r);
    }
    if (tasks.empty()) return;
    const std::vector<std::string> records = executor_(tasks);
    if (records.size() != tasks.size())
      throw Error(fmt::format("the executor returned {} records of {} tasks", records.size(),
                              tasks.size()));
    for (std::size_t k = 0; k < records.size(); ++k) {
      keep(*of[k],
           parse_replica(records[k], "a record of the executor", of[k]->index, system_.identity));
      write(*of[k]);
    }
  }
}

void PointMeasurement::extend(const Target& target) {
  done_ = planned_ = 0;
  for (const Replica& r : replicas_) {
    planned_ += steps_missing(r, target, system_.common);
    steps_ -= steps_of(r);
  }
  const Stopwatch watch;
  if (executor_)
    execute(target);
  else
    extend_in_turn(target);
  if (planned_ > 0) seconds_ += watch.seconds();
  for (const Replica& r : replicas_) steps_ += steps_of(r);
}

/// The replicas, cut to the lengths of a target. Decisions are based on these lengths, so a resumed
/// measurement makes the same decisions as an uninterrupted one.
std::vector<Replica> PointMeasurement::first_of(const Target& target) const {
  std::vector<Replica> first = replicas_;
  for (Replica& replica : first)
    for (const MeasuredIn kind : kinds_of_run) shorten(replica, kind, target[kind]);
  return first;
}

std::vector<MeasuredProperty> PointMeasurement::evaluate(std::span<const Replica> replicas) const {
  std::vector<MeasuredProperty> values;
  for (const RequestedProperty& request : settings_.properties)
    values.push_back(estimate(request, data(replicas)));
  return values;
}

void PointMeasurement::show(const std::vector<MeasuredProperty>& values, const Target& target,
                            bool equilibrium) const {
  for (const MeasuredProperty& m : values) {
    const bool known = m.value.known == Known::yes;
    const std::string text = known ? fmt::format("{} {}", with_error(m.value.value, m.value.error),
                                                 m.request.property->unit)
                                   : "not known yet";
    const std::string more =
        !m.obstacle.empty() ? ": " + m.obstacle
        : known && schedule_.continues(m, target)
            ? fmt::format(", continues to ± {:.2g}", schedule_.required_error(m))
            : "";
    callbacks_.note(fmt::format("  {} {}{}", m.request.property->name, text, more));
  }
  if (!equilibrium) callbacks_.note("  a replica is not in equilibrium yet and continues");
}

void PointMeasurement::show_plan(const Target& target,
                                 std::optional<double> seconds_per_step) const {
  const std::size_t at_once =
      std::min(replicas_.size(), static_cast<std::size_t>(workers_.threads()));
  const double steps = static_cast<double>(replicas_.size()) * steps_at(target, system_.common);
  const double seconds = steps * seconds_per_step.value_or(0) / static_cast<double>(at_once);
  callbacks_.note(
      plan_text(system_.common, target, replicas_.size(), system_.topology.size(), seconds));
  if (!allowed().is_limit && seconds > max_time)
    throw Error(fmt::format(
        "the first lengths of {} molecules need about {}; it must be less than a year: give fewer "
        "molecules, or a time limit",
        system_.topology.size(), duration_text(seconds)));
  if (seconds > allowed().seconds)
    callbacks_.note(
        fmt::format("the first lengths need more than {}: no error will be known by then; fewer "
                    "molecules need less time",
                    duration_text(allowed().seconds)));
}

TimeAllowed PointMeasurement::allowed() const {
  if (settings_.time_limit == 0) return {usual_time};
  return {std::max(0.0, settings_.time_limit - since_.seconds()), true};
}

WorkDone PointMeasurement::work_of(const Target& target) const {
  const auto n = static_cast<double>(replicas_.size());
  WorkDone done{.seconds_per_step = steps_ > 0 ? seconds_ / steps_ : 0};
  for (const MeasuredIn kind : kinds_of_run)
    done.steps[kind] = n * steps_of_kind(kind, target[kind], system_.common);
  return done;
}

/// Shows how long it will take; the first time also what takes too long.
/// @throws Error  if that is more than a year
void PointMeasurement::show_time(const std::vector<MeasuredProperty>& values,
                                 const Target& target) {
  const WorkDone done = work_of(target);
  const std::optional<double> time = expected_time(values, schedule_.share(), done);
  if (!time) return;
  callbacks_.note(
      fmt::format("  expected time until all errors are reached: {}", duration_text(*time)));
  if (has_warned_) return;
  has_warned_ = true;
  for (const std::string& warning : time_warnings(values, schedule_.share(), done, allowed()))
    callbacks_.note("warning: " + warning);
}

/// Extends the averages until the other kinds of run may begin with their volume, or until the time
/// limit hardly allows their first lengths.
void PointMeasurement::begin(Target& target) {
  while (!stopped() && !all_have(without_averages(target))) {
    const Target averages = averages_alone(target);
    extend(averages);
    const std::vector<Replica> replicas = first_of(averages);
    const std::string reason = schedule_.why_not_yet(averages, data(replicas));
    const double needed =
        steps_ > 0 ? work_of(without_averages(target)).steps.sum() * seconds_ / steps_ : 0;
    if (stopped() || reason.empty() || (allowed().is_limit && allowed().seconds < 2 * needed))
      return;
    target[MeasuredIn::averages] = longer(target[MeasuredIn::averages]);
    if (!all_have(averages_alone(target))) callbacks_.note("  averages continue: " + reason);
  }
}

/// Extends all runs to a target, and increases the target for properties that need more.
/// @return  whether work is left
bool PointMeasurement::extend_to(Target& target) {
  extend(target);
  if (stopped()) return false;
  const std::vector<Replica> replicas = first_of(target);
  const std::vector<MeasuredProperty> values = evaluate(replicas);
  const bool equilibrium = in_equilibrium(data(replicas));
  const Target reached = target;
  if (!schedule_.next(target, values, equilibrium)) return false;
  if (all_have(target)) return true;  // computed in an earlier call
  show(values, reached, equilibrium);
  show_time(values, reached);
  return true;
}

MeasuredPoint PointMeasurement::perform() {
  Target target = schedule_.first();
  const bool simulates =
      std::ranges::any_of(kinds_of_run, [&](auto kind) { return schedule_.wants(kind); });
  if (simulates && !settings_.only_evaluate) {
    const std::optional<double> seconds = choose_step();
    std::size_t& coupled = target[MeasuredIn::coupling];
    if (coupled > 0 && system_.common.step > 0 && !choose_path()) coupled = 0;
    if (system_.common.step > 0) {
      show_plan(target, seconds ? std::optional(*seconds / steps_of_pilot(settings_.step > 0))
                                : std::nullopt);
      begin(target);
      while (!stopped() && extend_to(target)) {
      }
    }
  }
  MeasuredPoint point = described(data(replicas_));
  point.scheme = text_of(settings_.sampling, settings_.scheme);
  point.properties = evaluate(replicas_);
  if (!at().constant_volume()) {
    point.density = estimate({&property("density")}, data(replicas_)).value;
    point.enthalpy = estimate({&property("enthalpy")}, data(replicas_)).value;
  }
  for (MeasuredProperty& m : point.properties) m.stages = stages_of(m.request, data(replicas_));
  if (at().constant_volume()) warn_of_tension();
  return point;
}

/// Warns of a negative pressure, at which a larger system may separate into two phases.
void PointMeasurement::warn_of_tension() const {
  const SeriesEstimate p = estimate({&property("pressure")}, data(replicas_)).value;
  if (p.known != Known::yes || p.value + three_sigma(p) >= 0) return;
  callbacks_.note(fmt::format(
      "warning: at {} the pressure is negative, {} bar; the liquid is under tension, and a larger "
      "system may separate into two phases",
      at().text(), with_error(p.value, p.error)));
}

}  // namespace

MeasureReport measure(const MeasureSettings& settings, const Callbacks& callbacks, Workers& workers,
                      const ReplicaExecutor& executor) {
  check_prefix(settings.prefix);
  const std::string page = settings.prefix + ".html";
  check_page(page);
  for (const std::string& note : settings.notes) callbacks.note(note);
  const OutputLock lock(fmt::format("{}-{}-of-{}.lock", settings.prefix, settings.shard.index + 1,
                                    settings.shard.count),
                        callbacks);
  const Topology topology = build_topology(settings.config.system);
  check_properties(settings, topology);
  MeasureReport report;
  for (const Topology::Part& part : topology.parts)
    report.system +=
        fmt::format("{}{} {}", report.system.empty() ? "" : ", ", part.count, part.molecule.name);
  const Stopwatch since;
  if (settings.points.size() > 1)  // refuses an unsuitable point before others are simulated
    for (const StatePoint& at : settings.points) PointSystem(settings, at);
  for (std::size_t k = 0; k < settings.points.size(); ++k) {
    try {
      PointMeasurement point(settings, k, callbacks, workers, executor, since);
      report.points.push_back(point.perform());
      for (const std::string& file : point.files()) report.files.push_back(file);
      report.out_of_time = point.out_of_time();
    } catch (const RunError& e) {  // the other points have results nevertheless
      report.missing.push_back({settings.points[k], e.what()});
      report.failed = true;
      if (report.missing.size() == settings.points.size()) throw;
      callbacks.note(fmt::format("error: {}; this state point is left out", e.what()));
    }
    report.interrupted = callbacks.stopped();
    if (report.interrupted) report.out_of_time = false;
    if (!report.interrupted && !report.out_of_time) continue;
    while (++k < settings.points.size())
      report.missing.push_back({settings.points[k], "the measurement ended before it"});
  }
  report.curves = state_curves(report.points);
  write_file(page, [&](std::ostream& out) { out << measure_page(report, settings.command); });
  report.files.push_back(page);
  return report;
}

}  // namespace polhode
