// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/memory.hpp"
#include "base/suggest.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// Maximum number of lags. A curve needs fewer lags, and this number can be stored for every body.
constexpr double max_lags = 1e6;

// Number of frames that are read before any is processed: at least two, to determine the interval.
std::size_t batch_size(const Workers& workers) {
  return std::max<std::size_t>(2, static_cast<std::size_t>(workers.threads()));
}

// Reads the next frames and skips frames before `from`. At the end of the file, there are fewer
// frames than requested.
std::size_t read(FrameReader& reader, std::vector<Frame>& batch, double from) {
  std::size_t count = 0;
  while (count < batch.size() && reader.next(batch[count]))
    if (batch[count].time >= from) ++count;
  return count;
}

// Names the atoms of a frame without names according to the topology, with or without massless
// sites.
void name_atoms(Frame& frame, const Topology& topology) {
  if (frame.kinds.size() != 1 || !frame.kinds.front().name.empty()) return;
  for (const MasslessSites massless : {MasslessSites::keep, MasslessSites::omit}) {
    if (atom_count(topology, massless) != frame.atoms.size()) continue;
    frame.kinds = atom_kinds(topology, massless);
    std::size_t atom = 0;
    std::uint32_t first_kind = 0;
    int residue = 0;
    for (const auto& [molecule, count] : topology.parts) {
      const Topology one{{{molecule, 1}}};
      const auto sites = static_cast<std::uint32_t>(atom_count(one, massless));
      for (std::size_t copy = 0; copy < count; ++copy) {
        ++residue;
        for (std::uint32_t k = 0; k < sites; ++k, ++atom) {
          frame.atoms[atom].kind = first_kind + k;
          frame.atoms[atom].residue = residue;
        }
      }
      first_kind += sites;
    }
    return;
  }
  throw Error(
      fmt::format("the file has {} atoms without names, but the molecules have {} sites ({} with "
                  "mass); give the molecules in the order of the file, or a file with atom names",
                  frame.atoms.size(), atom_count(topology),
                  atom_count(topology, MasslessSites::omit)),
      frame.source);
}

constexpr double bytes_of_lag = 30;  // memory per lag of a body in each TimeCorrelation [bytes]

class Assembly {
 public:
  Assembly(Analysis& result, const AnalysisSettings& settings)
      : result_(result), settings_(settings) {}

  // Creates the observables, once the first frames have been read.
  void begin(const std::vector<FittedState>& states) {
    const State& first = states.front().state;
    result_.first = first.time;
    result_.box = first.box;
    result_.has_velocities = states.front().has_velocities;
    result_.conditions.emplace(result_.topology);
    if (settings_.step_errors) {
      result_.fixed = settings_.step_errors->fixed;
      errors_.emplace(*settings_.step_errors, result_.topology);
    }
    FirstFrames frames{result_, settings_};
    std::string no_times;  // reason why correlations in time cannot be computed
    for (const ObservableKind& kind : observables()) {
      if (!settings_.what.empty() && !settings_.what.contains(kind.name)) continue;
      if (kind.correlates_times && frames.lags == 0 && no_times.empty()) {
        no_times = no_interval(states);
        if (no_times.empty()) frames.lags = lags();
      }
      const std::string why =
          kind.correlates_times && !no_times.empty() ? no_times : kind.why_not(frames);
      if (!why.empty()) {
        leave_out(kind.name, why);
        continue;
      }
      timed_ = timed_ || kind.correlates_times;
      moving_ = moving_ || kind.needs_velocities;
      result_.observables.push_back(kind.begin(frames));
    }
  }

  void add(const FittedState& fitted, Workers& workers) {
    const State& state = fitted.state;
    if (timed_) check_time(state.time);
    result_.deviation = std::max(result_.deviation, fitted.deviation);
    check_velocities(fitted.has_velocities);
    result_.conditions->add(state, result_.has_velocities && fitted.has_velocities);
    std::optional<StepError> error;
    if (errors_) error = errors_->at(state, fitted.has_velocities);
    if (error) ++result_.frames_with_step_error;
    for (const auto& observable : result_.observables) observable->add(state, error, workers);
    result_.last = state.time;
    ++result_.frames;
  }

  void end() {
    if (frames_without_velocities_ > 0)
      result_.notes.push_back(
          fmt::format("the temperature is the mean of the {} frames with velocities",
                      result_.frames - frames_without_velocities_));
    if (errors_) check_step_errors();
    if (timed_ && !settings_.interval)  // the mean interval has a smaller round-off error than the
                                        // first interval
      result_.interval = (result_.last - result_.first) / static_cast<double>(result_.frames - 1);
    if (timed_ && settings_.window) check_window(*settings_.window);
  }

 private:
  // Lags are limited to half of the frames, which serve as time origins. The default window gets no
  // note, because nobody asked for it.
  void check_window(double window) {
    const std::size_t lags = result_.frames / 2;
    const double longest = static_cast<double>(lags) * result_.interval;
    if (window < 0.99 * result_.interval)
      result_.notes.push_back(
          fmt::format("the window of {:g} ps is shorter than the interval between frames, so the "
                      "only lag is {:.4g} ps",
                      window, result_.interval));
    if (window > longest + result_.interval / 2)
      result_.notes.push_back(
          fmt::format("the window of {:g} ps is longer than half of the trajectory, so the lags "
                      "end at {:.4g} ps",
                      window, longest));
  }

  void leave_out(const std::string& name, const std::string& why) {
    if (settings_.what.contains(name))
      throw Error(fmt::format("'{}' cannot be computed: {}; leave it out", name, why));
    result_.notes.push_back(fmt::format("no {}: {}", name, why));
  }

  std::size_t lags() const {
    const double longest = settings_.window.value_or(default_window),
                 window = longest / result_.interval;
    if (!(window <= max_lags))
      throw Error(
          fmt::format("the window of {:g} ps has {:g} lags of {:g} ps; the maximum is {:g} lags, "
                      "so give a shorter window",
                      longest, window, result_.interval, max_lags));
    const auto lags = static_cast<std::size_t>(std::max(1.0, window + 1e-6)) + 1;
    const auto bodies = static_cast<double>(result_.topology.size());
    require_memory(bytes_of_lag * bodies * static_cast<double>(lags),
                   fmt::format("{} lags of {:.0f} bodies", lags, bodies), "use a shorter window");
    return lags;
  }

  void check_step_errors() {
    const std::size_t known = result_.frames_with_step_error;
    if (known == 0)
      throw Error(
          fmt::format("'{}' has no sample of the shadow energy at the times of the frames, so the "
                      "time-step bias cannot be computed; run a scheme of order 2 with "
                      "shadow_sample equal to trajectory_every, or leave the energies out",
                      settings_.step_errors->energies));
    if (known < result_.frames)
      result_.notes.push_back(fmt::format(
          "the time-step bias uses only {} of {} frames, because the other frames have no sample "
          "of the shadow energy; set shadow_sample equal to trajectory_every to use all frames",
          known, result_.frames));
  }

  // Sets the interval between frames, or returns the reason why it is not defined.
  std::string no_interval(const std::vector<FittedState>& states) {
    if (states.size() < 2) return "time correlations need at least two frames";
    result_.interval = settings_.interval.value_or(states[1].state.time - states[0].state.time);
    if (result_.interval > 0) return {};
    return fmt::format(
        "the first frames are at {:g} and {:g} ps, but times must increase; give the interval "
        "between frames",
        states[0].state.time, states[1].state.time);
  }

  // Velocities may be written less often than positions, as with nstvout of GROMACS.
  void check_velocities(bool has_velocities) {
    if (!result_.has_velocities || has_velocities) return;
    ++frames_without_velocities_;
    if (moving_)
      throw Error(
          fmt::format("frame {} has no velocities, but the first frame has them; correlations of "
                      "velocities need all of them, so choose other observables",
                      result_.frames + 1));
  }

  // In the worst case, files store times as floats, with a relative round-off error of 2⁻²⁴.
  void check_time(double time) const {
    if (settings_.interval) return;
    const double due = result_.first + static_cast<double>(result_.frames) * result_.interval;
    const double rounding = 0x1p-22 * std::abs(time) * (1 + static_cast<double>(result_.frames));
    if (std::abs(time - due) <= 0.01 * result_.interval + rounding) return;
    throw Error(
        fmt::format("frame {} is at {:g} ps instead of {:g} ps, the time expected from the first "
                    "interval, {:g} ps; correlations need evenly spaced frames, so choose other "
                    "observables, or give the interval",
                    result_.frames + 1, time, due, result_.interval));
  }

  Analysis& result_;
  const AnalysisSettings& settings_;
  std::optional<StepErrors> errors_;
  bool timed_ = false, moving_ = false;
  std::size_t frames_without_velocities_ = 0;
};

}  // namespace

const std::vector<std::string>& observable_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const ObservableKind& kind : observables()) all.push_back(kind.name);
    return all;
  }();
  return names;
}

std::string observable(const std::string& name) {
  const std::vector<std::string>& names = observable_names();
  if (std::ranges::find(names, name) == names.end())
    throw Error(fmt::format("there is no observable '{}'{} (there are: {})", name,
                            did_you_mean(name, names), join_names(names)));
  return name;
}

double Analysis::mean_interval() const {
  if (interval > 0) return interval;
  return frames < 2 ? 0 : std::max(0.0, (last - first) / static_cast<double>(frames - 1));
}

namespace {

/// Fits bodies to a frame. Errors in frames after the first give the number of the frame.
FittedState fitted_frame(Frame& frame, const Topology& topology, std::size_t number) try {
  name_atoms(frame, topology);
  FittedState fitted = fit_state(frame, topology);
  fitted.state.time = frame.time;
  return fitted;
} catch (const Error& e) {
  if (number == 1) throw;
  throw Error(fmt::format("in frame {}: {}", number, e.what()), e.where());
}

}  // namespace

Analysis analyze(FrameReader& reader, Topology topology, const AnalysisSettings& settings,
                 const Callbacks& callbacks, Workers& workers) {
  Analysis result;
  result.topology = std::move(topology);
  Assembly assembly(result, settings);
  std::vector<Frame> batch(batch_size(workers));
  std::vector<FittedState> states;
  while (const std::size_t count = read(reader, batch, settings.from)) {
    if (result.frames == 0) result.topology = complete_topology(result.topology, batch.front());
    states.resize(count);
    workers.each(count, [&](std::size_t k) {
      states[k] = fitted_frame(batch[k], result.topology, result.frames + k + 1);
    });
    if (result.frames == 0) assembly.begin(states);
    for (const FittedState& fitted : states) assembly.add(fitted, workers);
    callbacks.report(
        {"reading", {}, fmt::format("{} frames, {:g} ps", result.frames, result.last)});
    result.stopped = callbacks.stopped();
    if (result.stopped || count < batch.size()) break;
  }
  if (result.frames == 0)
    throw Error(fmt::format("there is no frame at {:g} ps or later; give an earlier start time",
                            settings.from));
  assembly.end();
  return result;
}

}  // namespace polhode
