// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "polhode/base/error.hpp"
#include "polhode/base/memory.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/model/dipole.hpp"

namespace polhode {
namespace {

// More than any curve needs, but few enough to be stored for every pair of sites and every body.
constexpr double max_bins = 1e5, max_lags = 1e6;

// Frames read before they are processed: at least two, to determine the interval.
std::size_t batch_size(const Workers& workers) {
  return std::max<std::size_t>(2, static_cast<std::size_t>(workers.threads()));
}

// The next frames, skipping those before `from`. Fewer than requested at the end of the file.
std::size_t read(FrameReader& reader, std::vector<Frame>& batch, double from) {
  std::size_t count = 0;
  while (count < batch.size() && reader.next(batch[count]))
    if (batch[count].time >= from) ++count;
  return count;
}

// Names the atoms of a frame without names after the topology, with or without massless sites.
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
      fmt::format(
          "there are {} atoms without names, and the molecules have {} sites, {} of them with "
          "mass; give the molecules in the order of the file, or a file with the names of the "
          "atoms",
          frame.atoms.size(), atom_count(topology), atom_count(topology, MasslessSites::omit)),
      frame.source);
}

constexpr double bytes_of_lag = 30;  // of a body, in each TimeCorrelation

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
    result_.density = requested(Observable::density);
    if (settings_.step_errors) {
      result_.fixed = settings_.step_errors->fixed;
      errors_.emplace(*settings_.step_errors, result_.topology);
    }
    if (requested(Observable::rdf)) begin_radial();
    if (requested(Observable::dielectric)) begin_dipole();
    if (!(requested(Observable::msd) || requested(Observable::rotation) ||
          requested(Observable::velocity)))
      return;
    if (const std::string why = no_interval(states); !why.empty()) {
      leave_out({Observable::msd, Observable::rotation, Observable::velocity}, why);
      return;
    }
    const double window = settings_.window / result_.interval;
    if (!(window <= max_lags))
      throw Error(
          fmt::format("the window of {:g} ps has {:g} lags of {:g} ps; the maximum is {:g}, so "
                      "give a shorter one",
                      settings_.window, window, result_.interval, max_lags));
    const auto lags = static_cast<std::size_t>(std::max(1.0, window + 1e-6)) + 1;
    const auto bodies = static_cast<double>(result_.topology.size());
    require_memory(bytes_of_lag * bodies * static_cast<double>(lags),
                   fmt::format("{} lags of {:.0f} bodies", lags, bodies), "use a shorter window");
    if (requested(Observable::msd) && result_.topology.size() == 1)
      leave_out({Observable::msd},
                "displacements are relative to the centre of mass of all molecules, and there is "
                "only one molecule");
    else if (requested(Observable::msd))
      result_.displacement.emplace(result_.topology, lags);
    if (requested(Observable::rotation)) result_.reorientation.emplace(result_.topology, lags);
    if (!requested(Observable::velocity)) return;
    if (result_.has_velocities)
      result_.velocity.emplace(result_.topology, lags);
    else
      leave_out({Observable::velocity}, "the frames have no velocities");
  }

  void add(const FittedState& fitted, Workers& workers) {
    const State& state = fitted.state;
    if (timed()) check_time(state.time);
    result_.deviation = std::max(result_.deviation, fitted.deviation);
    result_.conditions->add(state, result_.has_velocities);
    std::optional<StepError> error;
    if (errors_) error = errors_->at(state, fitted.has_velocities);
    if (error) ++result_.frames_with_step_error;
    if (result_.radial) result_.radial->add(state, workers, error);
    if (result_.dipole) result_.dipole->add(state, error);
    if (result_.displacement) result_.displacement->add(state, workers);
    if (result_.reorientation) result_.reorientation->add(state, workers);
    if (result_.velocity) result_.velocity->add(state, workers);
    result_.last = state.time;
    ++result_.frames;
  }

  void end() {
    if (errors_) check_step_errors();
    if (timed() && !settings_.interval)  // the mean interval has a smaller rounding error than the
                                         // first one
      result_.interval = (result_.last - result_.first) / static_cast<double>(result_.frames - 1);
    if (result_.displacement && result_.displacement->max_step() > safe_step)
      result_.notes.push_back(
          fmt::format("centres of mass moved by up to {:.2f} of an edge between frames; beyond "
                      "{:g} their paths across periodic boundaries are uncertain and displacements "
                      "may be too short: write frames more often",
                      result_.displacement->max_step(), safe_step));
    if (result_.velocity && result_.interval > 0.02)
      result_.notes.push_back(fmt::format(
          "frames {:g} fs apart are too far apart for velocities of light molecules, which reverse "
          "within 20 fs: their spectra beyond {:.3g} THz are folded back",
          units::fs_per_ps * result_.interval, 0.5 / result_.interval));
  }

 private:
  bool requested(Observable what) const {
    return settings_.what.empty() || settings_.what.contains(what);
  }

  bool timed() const { return result_.displacement || result_.reorientation || result_.velocity; }

  void leave_out(std::initializer_list<Observable> whats, const std::string& why) {
    for (const Observable what : whats) {
      if (!requested(what)) continue;
      const std::string& name = observable_names()[static_cast<std::size_t>(what)];
      if (settings_.what.contains(what))
        throw Error(fmt::format("there is no '{}': {}; leave it out", name, why));
      result_.notes.push_back(fmt::format("no {}: {}", name, why));
    }
  }

  void begin_radial() {
    result_.pairs = settings_.pairs.empty() ? site_pairs(result_.topology) : settings_.pairs;
    if (result_.pairs.empty()) {
      leave_out({Observable::rdf}, "no two molecules have sites with mass");
      return;
    }
    for (const SitePair& pair : result_.pairs) check_pair(pair);
    note_pooled();
    const double half = result_.box.shortest_edge() / 2;
    const double cutoff = settings_.cutoff.value_or(std::min(default_rdf_cutoff, half));
    if (!(cutoff / settings_.bin <= max_bins))
      throw Error(
          fmt::format("bins of {:g} nm make {:g} bins up to {:g} nm; the maximum is {:g}, so give "
                      "wider ones",
                      settings_.bin, cutoff / settings_.bin, cutoff, max_bins));
    result_.radial.emplace(result_.topology, RadialSettings{result_.pairs, cutoff, settings_.bin});
  }

  /// @throws Error  if only one molecule has the sites of a pair; RadialDistribution knows names
  ///                that do not exist
  void check_pair(const SitePair& pair) const {
    for (const std::string& word : pair)
      if (molecules_with(result_.topology, word).empty()) return;
    if (count_pairs(result_.topology, pair) > 0) return;
    throw Error(fmt::format(
        "there is no g(r) of '{}-{}': only one molecule has these sites, and a pair is of two "
        "molecules; leave it out",
        pair[0], pair[1]));
  }

  void check_step_errors() {
    const std::size_t known = result_.frames_with_step_error;
    if (known == 0)
      throw Error(fmt::format(
          "no frame has a sample of the shadow energy in '{}', from which the bias of the step "
          "follows with a thermostat; run with a scheme of order 2 and a shadow_sample equal to "
          "trajectory_every, or leave the energies out",
          settings_.step_errors->energies));
    if (known < result_.frames)
      result_.notes.push_back(fmt::format(
          "the bias of the step is from {} of {} frames, those at samples of the shadow energy; a "
          "shadow_sample equal to trajectory_every makes it all",
          known, result_.frames));
  }

  // Sites of several kinds of molecules in one selection.
  void note_pooled() {
    std::set<std::string> noted;
    for (const SitePair& pair : result_.pairs)
      for (const std::string& word : pair) {
        const std::vector<std::string> kinds = molecules_with(result_.topology, word);
        if (kinds.size() < 2 || !noted.insert(word).second) continue;
        result_.notes.push_back(
            fmt::format("g(r) of '{0}' is of the sites of {1} together; '{2}:{0}' selects those of "
                        "one",
                        word, join_names(kinds), kinds.front()));
      }
  }

  void begin_dipole() {
    const auto& parts = result_.topology.parts;
    const auto charged = std::find_if(parts.begin(), parts.end(), [](const auto& part) {
      return std::abs(part.molecule.charge()) > 1e-6;
    });
    if (charged != parts.end())
      leave_out({Observable::dielectric},
                fmt::format("'{}' has a charge of {:g} e, and the dipole of a periodic box with "
                            "mobile ions is not defined",
                            charged->molecule.name, charged->molecule.charge()));
    else if (std::none_of(parts.begin(), parts.end(),
                          [](const auto& part) { return has_dipole(part.molecule); }))
      leave_out({Observable::dielectric}, "no molecule has a dipole");
    else
      result_.dipole.emplace(result_.topology);
  }

  // Sets the interval between frames, or returns the reason why there is none.
  std::string no_interval(const std::vector<FittedState>& states) {
    if (states.size() < 2) return "time correlations need at least two frames";
    result_.interval = settings_.interval.value_or(states[1].state.time - states[0].state.time);
    if (result_.interval > 0) return {};
    return fmt::format(
        "the first frames have the times {:g} and {:g} ps; give the interval between them",
        states[0].state.time, states[1].state.time);
  }

  // At worst, files store times as floats: a relative rounding error of 2⁻²⁴.
  void check_time(double time) const {
    if (settings_.interval) return;
    const double due = result_.first + static_cast<double>(result_.frames) * result_.interval;
    const double rounding = 0x1p-22 * std::abs(time) * (1 + static_cast<double>(result_.frames));
    if (std::abs(time - due) <= 0.01 * result_.interval + rounding) return;
    throw Error(
        fmt::format("frame {} is at {:g} ps instead of {:g} ps, the first two being {:g} ps apart: "
                    "correlations need evenly spaced frames; choose other observables, or give "
                    "the interval between frames",
                    result_.frames + 1, time, due, result_.interval));
  }

  Analysis& result_;
  const AnalysisSettings& settings_;
  std::optional<StepErrors> errors_;
};

}  // namespace

const std::vector<std::string>& observable_names() {
  static const std::vector<std::string> names = {"rdf",      "msd",        "rotation",
                                                 "velocity", "dielectric", "density"};
  return names;
}

Observable observable(const std::string& name) {
  const std::vector<std::string>& names = observable_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(fmt::format("there is no observable '{}'{} (there are: {})", name,
                            did_you_mean(name, names), join_names(names)));
  return static_cast<Observable>(found - names.begin());
}

double Analysis::mean_interval() const {
  if (interval > 0) return interval;
  return frames < 2 ? 0 : std::max(0.0, (last - first) / static_cast<double>(frames - 1));
}

Analysis analyze(FrameReader& reader, Topology topology, const AnalysisSettings& settings,
                 const Callbacks& callbacks, Workers& workers) {
  Analysis result;
  result.topology = std::move(topology);
  Assembly observables(result, settings);
  std::vector<Frame> batch(batch_size(workers));
  std::vector<FittedState> states;
  while (const std::size_t count = read(reader, batch, settings.from)) {
    if (result.frames == 0) result.topology = complete_topology(result.topology, batch.front());
    states.resize(count);
    workers.each(count, [&](std::size_t k) {
      name_atoms(batch[k], result.topology);
      states[k] = fit_state(batch[k], result.topology);
      states[k].state.time = batch[k].time;
    });
    if (result.frames == 0) observables.begin(states);
    for (const FittedState& fitted : states) observables.add(fitted, workers);
    callbacks.report(
        {"reading", {}, fmt::format("{} frames, {:g} ps", result.frames, result.last)});
    result.stopped = callbacks.stopped();
    if (result.stopped || count < batch.size()) break;
  }
  if (result.frames == 0)
    throw Error(
        fmt::format("there is no frame at {:g} ps or later; give an earlier time", settings.from));
  observables.end();
  return result;
}

}  // namespace polhode
