// SPDX-License-Identifier: MIT
// A force evaluation over the neighbour list in a given precision. The engine places the sites,
// sums the pairs of each chunk, adds the mesh contribution, and adds up the sums of all chunks.
#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "forces/mesh/particle_mesh.hpp"
#include "forces/pairs/neighbours.hpp"
#include "forces/pairs/pair_loops.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Computes the interactions of all pairs of molecules.
/// @tparam T  precision of the pairs: double or float
template <class T>
class PairEngine {
 public:
  /// @param ghost_parts  number of parts at the end of the topology that are ghosts, which do not
  ///   interact with each other
  PairEngine(const Topology& topology, const ForceSettings& settings, const Box& box,
             Workers& workers, std::size_t ghost_parts = 0);

  /// Sets another box, with the topology and settings of the constructor, except that the mesh may
  /// differ.
  /// @throws Error  if the box is too small
  void set_box(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Computes forces and torques of a state, whose box must be the box that was set. If `energies`
  /// is true, energies and virial are also computed; otherwise both are 0. With PME the settings
  /// must contain a mesh. Energy terms that do not depend on positions are not included.
  void operator()(const State& state, Load& load, bool energies);

  /// Computes the derivative of forces and torques along a displacement of all bodies, see
  /// ForceField::directional_derivative(). Energies and virial are set to 0.
  void derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta, Load& slope);

  const NeighbourList& neighbours() const { return list_; }
  /// Builds the neighbour list from the positions of a state.
  void build_list(const State& state);

 private:
  void update(const State& state);
  double place(const State& state);
  void displace(const State& state, const Vec3Column& dq, const Vec3Column& dtheta);
  template <class Body>
  void each_task_of_slots(const Body& body);
  void prepare_sums();
  void clear(const State& state, Load& load);
  using PairLoop = void (*)(const PairJob<T>&);
  void sum_pairs(PairLoop loop, bool energies, const SiteRecords<T>* displacements, Load& load);
  void sum_chunk(std::size_t chunk, PairLoop loop, bool energies,
                 const SiteRecords<T>* displacements);
  void collect(std::size_t part, std::uint32_t first, std::uint32_t end, Load& load) const;
  void collect_all(Load& load);

  Workers& workers_;
  CutoffTreatment treatment_;
  PairTables tables_;
  PairLaws<T> laws_;
  NeighbourList list_;
  std::vector<std::vector<Vec3<double>>> sites_;  // site positions of each part, in the order of
                                                  // InteractionSites
  SiteRecords<T> records_;
  SiteRecords<T> displacements_, records_before_;  // allocated when derivatives are first requested
  std::unique_ptr<ParticleMesh<T>> mesh_;          // null without PME
  Column<T> mesh_sums_;                            // sums of all slots, as in ChunkSums
  std::vector<ChunkSums<T>> sums_;                 // sums of each chunk
  std::vector<double> moved2_;                     // largest squared displacement in each task of
                                                   // place()
};

/// A PairEngine in the precision of the settings.
struct AnyPairEngine {
  std::variant<PairEngine<double>, PairEngine<float>> in_precision;

  template <class T>
  explicit AnyPairEngine(PairEngine<T>&& engine) : in_precision(std::move(engine)) {}

  /// Calls a function with the engine.
  template <class Function>
  decltype(auto) call(Function&& function) {
    return std::visit(function, in_precision);
  }
};

/// Makes a pair engine from the arguments of the PairEngine constructor.
std::unique_ptr<AnyPairEngine> pair_engine(const Topology& topology, const ForceSettings& settings,
                                           const Box& box, Workers& workers,
                                           std::size_t ghost_parts = 0);

}  // namespace polhode
