// SPDX-License-Identifier: MIT
#include "run/properties/coupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "polhode/base/units.hpp"
#include "run/properties/chain.hpp"

namespace polhode {
namespace {

/// The molecule with its potentials and charges as in a stage.
Molecule at_stage(Molecule molecule, const CouplingStage& stage) {
  for (Site& site : molecule.sites) {
    site.charge *= stage.charge;
    if (stage.size > 0) {
      site.size = stage.size;
    } else {
      site.epsilon = 0;
      site.law = LennardJonesLaw{};
    }
  }
  return molecule;
}

/// Whether a site that a pair of sites names has a short-range potential.
bool has_site(const Topology& topology, const std::string& name) {
  return std::ranges::any_of(topology.parts, [&](const auto& part) {
    return std::ranges::any_of(part.molecule.sites, [&](const Site& site) {
      return site.has_short_range() && part.molecule.name + '.' + site.name == name;
    });
  });
}

/// The acceptance function of the acceptance ratio method [bennett1976].
double fermi(double x) { return 1 / (1 + std::exp(x)); }

/// Potential energies that the states of a run have with the molecule at another stage.
class OtherStage {
 public:
  OtherStage(const System& whole, const CouplingStage& stage)
      : system_(coupled(whole, stage)),
        forces_(system_.topology, system_.forces, whole.state.box),
        load_(system_.bodies.size()) {}
  /// The energy, which is infinite where a potential is not defined because sites are too close.
  double potential(const State& state) {
    forces_(state, load_);
    const double U = load_.potential();
    return std::isnan(U) ? std::numeric_limits<double>::infinity() : U;
  }

 private:
  System system_;
  ForceField forces_;
  Load load_;
};

/// A system with a molecule that can be at any stage. All stages have the same mesh, so that their
/// energies can be compared.
class CoupledChain {
 public:
  CoupledChain(const Replica& replica, const ReplicaSettings& settings, const State& start,
               double compressibility, std::optional<MeshChoice>& meshes)
      : chain_(settings, replica, none_),
        whole_(chain_.system()),
        step_(replica.step),
        compressibility_(compressibility),
        kT_(units::boltzmann * settings.at.temperature) {
    whole_.state = start;
    ForceField forces(whole_.topology, whole_.forces, start.box, Workers::serial(),
                      std::exchange(meshes, std::nullopt));
    whole_.forces.mesh = forces.settings().mesh;
    meshes = forces.mesh_choice();
  }

  const System& whole() const { return whole_; }
  double kT() const { return kT_; }

  /// Runs a stage with new momenta, which also thermalizes a molecule that is not coupled.
  /// @param sample  called for each sample
  /// @return  the state at the end; empty if it was stopped
  std::optional<State> run(const State& start, const CouplingStage& stage, std::size_t steps,
                           std::uint64_t stream,
                           std::function<void(const State&, const Energies&)> sample = {}) {
    chain_.system() = coupled(whole_, stage);
    chain_.system().state = start;
    draw_momenta(chain_.system(), chain_.seed(stream));
    none_.reset();
    TrajectorySettings t = settings(steps, stream);
    Watch watch;
    if (sample)
      watch.sample = [&](std::size_t k, const State& state, const Energies& now) {
        if (k > 0) sample(state, now);
      };
    if (!chain_.run(t, watch)) return std::nullopt;
    return chain_.system().state;
  }
  std::optional<FixedMeans> fixed_means() const { return settings(1, 0).fixed_means(); }

 private:
  TrajectorySettings settings(std::size_t steps, std::uint64_t stream) const {
    TrajectorySettings t = sampling_of(chain_, compressibility_, step_, steps, stream);
    t.sample = t.shadow_sample = step_ * static_cast<double>(steps_of_coupling_sample);
    return t;
  }

  std::optional<MeshChoice> none_;
  Chain chain_;
  System whole_;
  double step_, compressibility_, kT_;
};

/// A stage that may follow, with the weights that it gives to the samples of the present stage.
struct Candidate {
  CouplingStage stage;
  OtherStage energies;
  double sum = 0, sum2 = 0, samples = 0;
  std::optional<State> likely{};  ///< the last state with at least the mean weight

  void add(const State& state, double difference) {
    const double weight = std::exp(-difference);
    sum += weight, sum2 += weight * weight, samples += 1;
    if (weight * samples >= sum && weight > 0) likely = state;
  }
  /// The effective share of samples.
  double share() const { return sum2 > 0 ? sum * sum / (sum2 * samples) : 0; }
};

/// The farthest candidate up to which each one has enough effective samples; the first if none has.
std::size_t farthest(const std::vector<Candidate>& candidates) {
  constexpr double min_share = 0.25;
  std::size_t chosen = 0;
  for (std::size_t k = 1; k < candidates.size() && candidates[k].share() >= min_share; ++k)
    chosen = k;
  return chosen;
}

/// Relaxes all stages, each from the state of the next one, in which the molecule is larger.
bool relax(CoupledChain& chain, CoupledChains& chains) {
  chains.states.assign(chains.path.size(), chain.whole().state);
  for (std::size_t k = chains.path.size(); k-- > 0;) {
    const State& from = chains.states[std::min(k + 1, chains.path.size() - 1)];
    const auto end = chain.run(from, chains.path[k], steps_of_relaxation, coupling + k);
    if (!end) return false;
    chains.states[k] = *end;
  }
  return true;
}

/// A segment at a stage.
std::optional<StageSegment> segment_at(CoupledChain& chain, CoupledChains& chains, std::size_t k,
                                       std::uint64_t stream) {
  const CouplingPath& path = chains.path;
  std::optional<OtherStage> before, after;
  if (k > 0) before.emplace(chain.whole(), path[k - 1]);
  if (k + 1 < path.size()) after.emplace(chain.whole(), path[k + 1]);
  StageSegment segment{.sums = {0, std::vector<double>(coupling_sums)}, .response = {}};
  if (!chains.segments.empty()) segment.response.first = chains.segments.front()[k].response.first;
  const auto fixed = chain.fixed_means();
  const auto sample = [&](const State& state, const Energies& now) {
    const auto reduced = [&](OtherStage& other) {
      return (other.potential(state) - now.potential()) / chain.kT();
    };
    const std::array<double, coupling_sums> x{
        before ? fermi(reduced(*before) + path[k - 1].next) : 0,
        after ? fermi(reduced(*after) - path[k].next) : 0, k == 0 ? 1 / now.volume : now.volume};
    segment.sums.weight += 1;
    for (std::size_t s = 0; s < coupling_sums; ++s) segment.sums.sum[s] += x[s];
    if (fixed && !std::isnan(now.step_error)) segment.response.add(step_error(now, *fixed, 0), x);
  };
  const auto end = chain.run(chains.states[k], path[k], steps_of_coupling, stream, sample);
  if (!end) return std::nullopt;
  segment.response.blocks = {{segment.response.blocks.means().sum()}, 1};
  chains.states[k] = *end;
  return segment;
}

}  // namespace

CouplingPath possible_stages(const Molecule& molecule) {
  constexpr int sizes = 32, charges = 16, first_size = 6;
  CouplingPath all{{}};
  for (int k = first_size; k <= sizes; ++k) all.push_back({k / static_cast<double>(sizes), 0});
  if (has_charges(molecule))
    for (int k = 1; k <= charges; ++k) all.push_back({1, k / static_cast<double>(charges)});
  return all;
}

System coupled(const System& whole, const CouplingStage& stage) {
  System system = whole;
  std::vector<Topology::Part>& parts = system.topology.parts;
  parts.insert(parts.begin() + 1, {at_stage(parts.front().molecule, stage), 1});
  if (--parts.front().count == 0) parts.erase(parts.begin());
  system.bodies = Bodies(system.topology);
  std::erase_if(system.forces.mixing.pairs, [&](const PairOverride& pair) {
    return !has_site(system.topology, pair.first) || !has_site(system.topology, pair.second);
  });
  if (!has_charges(system.topology)) {  // a mesh would have nothing to compute
    system.forces.electrostatics = Electrostatics::coulomb;
    system.forces.mesh.reset();
    system.forces.coulomb_cutoff.reset();
  }
  return system;
}

bool choose_stages(Replica& pilot, const ReplicaSettings& settings) {
  constexpr std::size_t at_once = 8, steps_to_relax = 500, steps_to_choose = 2500;
  CoupledChain chain(pilot, settings, pilot.state, pilot.compressibility, pilot.meshes);
  const CouplingPath all = possible_stages(chain.whole().topology.parts.front().molecule);
  CouplingPath path{all.front()};
  std::size_t at = 0;
  std::uint64_t stream = choosing_stages;
  State state = pilot.state;
  while (at + 1 < all.size()) {
    const auto relaxed = chain.run(state, all[at], steps_to_relax, stream++);
    if (!relaxed) return false;
    std::vector<Candidate> candidates;
    for (std::size_t k = at + 1; k < std::min(all.size(), at + 1 + at_once); ++k)
      candidates.push_back({all[k], OtherStage(chain.whole(), all[k])});
    const auto sample = [&](const State& now, const Energies& energies) {
      for (Candidate& c : candidates)
        c.add(now, (c.energies.potential(now) - energies.potential()) / chain.kT());
    };
    const auto end = chain.run(*relaxed, all[at], steps_to_choose, stream++, sample);
    if (!end) return false;
    const std::size_t next = farthest(candidates);
    const Candidate& chosen = candidates[next];
    state = chosen.likely.value_or(*end);
    path.back().next = -std::log(std::max(chosen.sum / chosen.samples, 1e-12));
    path.push_back(chosen.stage);
    at += 1 + next;
  }
  pilot.coupled.path = path;
  return true;
}

bool add_coupling(Replica& replica, const ReplicaSettings& settings) {
  CoupledChains chains = replica.coupled;
  if (chains.states.empty()) {
    chains.path = settings.path;
    chains.compressibility = compressibility_of_moves(replica, settings.at);
  }
  const State& start = chains.states.empty() ? replica.state : chains.states.back();
  CoupledChain chain(replica, settings, start, chains.compressibility, chains.meshes);
  if (chains.states.empty()) {
    if (!relax(chain, chains)) return false;
    replica.coupled = std::move(chains);
    return true;
  }
  const std::size_t stages = chains.path.size();
  std::vector<StageSegment> segment;
  for (std::size_t k = 0; k < stages; ++k) {
    const std::uint64_t stream = coupling + (chains.segments.size() + 1) * stages + k;
    const auto at_stage = segment_at(chain, chains, k, stream);
    if (!at_stage) return false;
    segment.push_back(*at_stage);
  }
  chains.segments.push_back(std::move(segment));
  replica.coupled = std::move(chains);
  return true;
}

}  // namespace polhode
