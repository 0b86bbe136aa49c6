// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_engine.hpp"

#include <algorithm>
#include <array>

#include "polhode/base/blocks.hpp"

namespace polhode {
namespace {

constexpr std::size_t slots_at_once = 4 * slot_block;  // placed by one task

std::size_t most_sites_of(const Topology& topology) {
  std::size_t most = 0;
  for (const auto& part : topology.parts)
    most = std::max(most, InteractionSites(part.molecule).size());
  return most;
}

/// The width of packs of pairs.
template <class T>
std::size_t lanes() {
  return POLHODE_CURRENT_OVERLOAD(pair_lanes, std::size_t(*)(const PairJob<T>*))(nullptr);
}

}  // namespace

template <class T>
PairEngine<T>::PairEngine(const Topology& topology, const ForceSettings& settings, const Box& box,
                          Workers& workers)
    : workers_(workers),
      ending_(ending_of(settings)),
      tables_(topology, settings.mixing),
      laws_(settings),
      list_(topology, settings, box),
      records_(list_.slots().size(), most_sites_of(topology)),
      sums_(list_.chunks().size()) {
  for (const auto& part : topology.parts) {
    sites_.emplace_back();
    for (const Site& site : InteractionSites(part.molecule).sites) sites_.back().push_back(site.r);
  }
  if (settings.mesh) {
    mesh_ = std::make_unique<ParticleMesh<T>>(topology, *settings.mesh, box, workers);
    mesh_sums_ = Column<T>(list_.slots().size() * ChunkSums<T>::stride);
  }
}

template <class T>
void PairEngine<T>::operator()(const State& state, Load& load, bool energies) {
  if (list_.width() != lanes<T>() || !(place(state) < list_.allowed2())) {
    build_list(state);
    place(state);
  }
  if (load.f.size() != state.size()) load = Load(state.size());
  load.lennard_jones = load.coulomb = load.mesh = 0;
  load.virial = {};
  if (mesh_) {
    std::fill_n(mesh_sums_.data(), mesh_sums_.size(), T{});
    const MeshLoad mesh = (*mesh_)(list_.slots(), records_, mesh_sums_.data(), energies);
    load.coulomb = load.mesh = mesh.energy;
    load.virial = mesh.virial;
  }
  workers_.each(sums_.size(), [&](std::size_t c) { sum_chunk(c, energies); });
  workers_.each(sums_.size(), [&](std::size_t c) { collect(c, load); });
  for (const ChunkSums<T>& sums : sums_) {
    load.lennard_jones += sums.lennard_jones;
    load.coulomb += sums.coulomb;
    for (std::size_t k = 0; k < 3; ++k) load.virial[k] += sums.virial[k];
  }
}

template <class T>
void PairEngine<T>::build_list(const State& state) {
  list_.build(state, lanes<T>(), workers_);
  prepare_sums();
}

/// The square of the largest displacement since the list was built [nm²].
template <class T>
double PairEngine<T>::place(const State& state) {
  const auto place_sites = POLHODE_CURRENT_OVERLOAD(place_sites, double (*)(const PlaceJob<T>&));
  double moved2 = 0;
  for (std::size_t p = 0; p < sites_.size(); ++p) {
    const Slots::Part& part = list_.slots().parts[p];
    const std::size_t slots = blocks(part.count, slot_block) * slot_block;
    moved2_.resize(std::max(moved2_.size(), blocks(slots, slots_at_once)));
    each_block(slots, slots_at_once, workers_, [&](std::size_t first, std::size_t end) {
      moved2_[first / slots_at_once] = place_sites(
          {state, list_.slots(), sites_[p], part.first + first, part.first + end, records_});
    });
    for (std::size_t k = 0; k < blocks(slots, slots_at_once); ++k)
      moved2 = std::max(moved2, moved2_[k]);
  }
  return moved2;
}

template <class T>
void PairEngine<T>::prepare_sums() {
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    std::size_t records = 0;
    sums_[c].first.clear();
    for (const SlotWindow& window : list_.chunks()[c].windows) {
      sums_[c].first.push_back(records);
      records += window.count;
    }
    if (sums_[c].values.size() < records * ChunkSums<T>::stride)
      sums_[c].values = Column<T>(records * ChunkSums<T>::stride);
  }
}

template <class T>
void PairEngine<T>::sum_chunk(std::size_t c, bool energies) {
  const ListChunk& chunk = list_.chunks()[c];
  ChunkSums<T>& sums = sums_[c];
  std::fill_n(sums.values.data(), sums.values.size(), T{});
  sums.lennard_jones = sums.coulomb = 0;
  sums.virial = {};
  const auto pair_forces = POLHODE_CURRENT_OVERLOAD(pair_forces, void (*)(const PairJob<T>&));
  for (std::size_t partner = chunk.part; partner < sites_.size(); ++partner)
    pair_forces({tables_(chunk.part, partner), laws_, ending_, energies, list_, chunk, partner,
                 records_, sums});
}

/// Adds what all chunks did to the slots of one of them, in the order of the chunks.
template <class T>
void PairEngine<T>::collect(std::size_t c, Load& load) const {
  constexpr std::uint32_t block = slot_block;
  constexpr std::size_t stride = ChunkSums<T>::stride;
  const ListChunk& own = list_.chunks()[c];
  const Slots& slots = list_.slots();
  const Slots::Part& part = slots.parts[own.part];
  const bool turns = std::any_of(sites_[own.part].begin(), sites_[own.part].end(),
                                 [](const Vec3<double>& r) { return norm2(r) > 0; });
  for (std::uint32_t first = own.first; first < own.end; first += block) {
    const std::uint32_t n = std::min(block, own.end - first);
    std::array<double, block * stride> total{};
    if (mesh_) std::copy_n(&mesh_sums_[first * stride], n * stride, total.begin());
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      // Windows begin at blocks, so that a block lies in one piece in a window or not at all.
      const SlotWindow& window = list_.chunks()[k].windows[own.part];
      const std::uint32_t at = first - window.first + (first < window.first ? part.count : 0);
      if (at >= window.count) continue;
      const T* const from = &sums_[k].values[(sums_[k].first[own.part] + at) * stride];
      for (std::size_t x = 0; x < n * stride; ++x) total[x] += from[x];
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const double* const sum = &total[i * stride];
      const std::uint32_t body = slots.body[first + i];
      load.f.set(body, {sum[0], sum[1], sum[2]});
      load.tau.set(body, turns ? Vec3<double>{sum[3], sum[4], sum[5]} : Vec3<double>{});
    }
  }
}

template class PairEngine<double>;
template class PairEngine<float>;

}  // namespace polhode
