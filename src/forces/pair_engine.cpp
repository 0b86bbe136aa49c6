// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_engine.hpp"

#include <algorithm>

namespace polhode {
namespace {

std::size_t most_sites_of(const Topology& topology) {
  std::size_t most = 0;
  for (const auto& part : topology.parts)
    most = std::max(most, InteractionSites(part.molecule).size());
  return most;
}

}  // namespace

template <class T>
PairEngine<T>::PairEngine(const Topology& topology, const ForceSettings& settings, const Box& box)
    : truncation_(settings.truncation),
      tables_(topology),
      laws_(settings),
      list_(topology, settings, box),
      records_(list_.slots().size(), most_sites_of(topology), box),
      sums_(list_.chunks().size()) {
  for (const auto& part : topology.parts) {
    sites_.emplace_back();
    for (const Site& site : InteractionSites(part.molecule).sites) sites_.back().push_back(site.r);
  }
}

template <class T>
void PairEngine<T>::operator()(const State& state, Load& load, bool energies) {
  const std::size_t width =
      POLHODE_CURRENT_OVERLOAD(pair_lanes, std::size_t(*)(const PairJob<T>*))(nullptr);
  if (list_.width() != width || !(place(state) < list_.allowed2())) {
    list_.build(state, width);
    place(state);
    prepare_sums();
  }
  if (load.f.size() != state.size()) load = Load(state.size());
  for (std::size_t c = 0; c < sums_.size(); ++c) sum_chunk(c, energies);
  for (std::size_t c = 0; c < sums_.size(); ++c) collect(c, load);
  load.lennard_jones = load.coulomb = 0;
  load.virial = {};
  for (const ChunkSums& sums : sums_) {
    load.lennard_jones += sums.lennard_jones;
    load.coulomb += sums.coulomb;
    for (std::size_t k = 0; k < 3; ++k) load.virial[k] += sums.virial[k];
  }
}

/// The square of the largest displacement since the list was built [nm²].
template <class T>
double PairEngine<T>::place(const State& state) {
  const auto place_sites = POLHODE_CURRENT_OVERLOAD(place_sites, double (*)(const PlaceJob<T>&));
  double moved2 = 0;
  for (std::size_t p = 0; p < sites_.size(); ++p) {
    const Slots::Part& part = list_.slots().parts[p];
    const std::size_t blocks = (part.count + slot_block - 1) / slot_block;
    moved2 = std::max(moved2, place_sites({state, list_.slots(), sites_[p], part.first,
                                           part.first + blocks * slot_block, records_}));
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
    if (sums_[c].values.size() < records * ChunkSums::stride)
      sums_[c].values = Column<double>(records * ChunkSums::stride);
  }
}

template <class T>
void PairEngine<T>::sum_chunk(std::size_t c, bool energies) {
  const ListChunk& chunk = list_.chunks()[c];
  ChunkSums& sums = sums_[c];
  std::fill_n(sums.values.data(), sums.values.size(), 0.0);
  sums.lennard_jones = sums.coulomb = 0;
  sums.virial = {};
  const auto pair_forces = POLHODE_CURRENT_OVERLOAD(pair_forces, void (*)(const PairJob<T>&));
  for (std::size_t partner = chunk.part; partner < sites_.size(); ++partner)
    pair_forces({tables_(chunk.part, partner), laws_, truncation_, energies, list_, chunk, partner,
                 records_, sums});
}

/// Adds what all chunks did to the slots of one of them, in the order of the chunks.
template <class T>
void PairEngine<T>::collect(std::size_t c, Load& load) const {
  const ListChunk& own = list_.chunks()[c];
  const Slots& slots = list_.slots();
  const Slots::Part& part = slots.parts[own.part];
  const std::uint32_t n = own.end - own.first;
  std::vector<double> total(n * ChunkSums::stride, 0.0);
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const SlotWindow& window = list_.chunks()[k].windows[own.part];
    const double* const sums = &sums_[k].values[sums_[k].first[own.part] * ChunkSums::stride];
    // The window's place of this chunk's first slot; from `turn` on the window's slots wrap.
    for (std::uint32_t i = 0; i < n;) {
      const std::uint32_t slot = own.first + i;
      const std::uint32_t at = slot - window.first + (slot < window.first ? part.count : 0);
      std::uint32_t run = 1;
      if (at < window.count) {
        run = std::min(n - i, window.count - at);
        if (slot < window.first) run = std::min(run, window.first - slot);
        double* const to = &total[i * ChunkSums::stride];
        const double* const from = sums + at * ChunkSums::stride;
        for (std::size_t x = 0; x < run * ChunkSums::stride; ++x) to[x] += from[x];
      } else {
        run = slot < window.first ? std::min(n - i, window.first - slot) : n - i;
      }
      i += run;
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const double* const from = &total[i * ChunkSums::stride];
    const std::uint32_t body = slots.body[own.first + i];
    load.f.set(body, {from[0], from[1], from[2]});
    load.tau.set(body, {from[3], from[4], from[5]});
  }
}

template class PairEngine<double>;
template class PairEngine<float>;

}  // namespace polhode
