// SPDX-License-Identifier: MIT
#include "forces/pairs/pair_engine.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/blocks.hpp"

namespace polhode {
namespace {

std::size_t max_sites_of(const Topology& topology) {
  std::size_t max_sites = 0;
  for (const auto& part : topology.parts)
    max_sites = std::max(max_sites, InteractionSites(part.molecule).size());
  return max_sites;
}

/// The number of pairs in a pack.
template <class T>
std::size_t lanes() {
  return POLHODE_CURRENT_OVERLOAD(pair_lanes, std::size_t(*)(const PairJob<T>*))(nullptr);
}

}  // namespace

template <class T>
PairEngine<T>::PairEngine(const Topology& topology, const ForceSettings& settings, const Box& box,
                          Workers& workers, std::size_t ghost_parts)
    : workers_(workers),
      treatment_(cutoff_treatment(settings)),
      tables_(topology, settings.mixing),
      laws_(settings),
      list_(topology, settings, box, ghost_parts),
      records_(list_.slots().size(), max_sites_of(topology)),
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
void PairEngine<T>::set_box(const Topology& topology, const ForceSettings& settings,
                            const Box& box) {
  list_.set_box(topology, settings, box);
  if (!mesh_) return;
  if (mesh_->settings() == *settings.mesh) {
    mesh_->set_box(box);
  } else {
    mesh_ = std::make_unique<ParticleMesh<T>>(topology, *settings.mesh, box, workers_);
    laws_ = PairLaws<T>(settings);  // the mesh and the pairs split 1/r in the same way
  }
}

template <class T>
void PairEngine<T>::operator()(const State& state, Load& load, bool energies) {
  update(state);
  clear(state, load);
  if (mesh_) {
    const MeshLoad mesh = (*mesh_)(list_.slots(), records_, mesh_sums_.data(), energies);
    load.coulomb = load.mesh = mesh.energy;
    load.virial = mesh.virial;
  }
  sum_pairs(POLHODE_CURRENT_OVERLOAD(pair_forces, PairLoop), energies, nullptr, load);
}

template <class T>
void PairEngine<T>::derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                               Load& slope) {
  if (displacements_.stride == 0) displacements_ = records_before_ = records_;
  if (mesh_) std::swap(records_, records_before_);
  update(state);
  displace(state, dq, dtheta);
  clear(state, slope);
  if (mesh_) {
    const auto now = records_.values.values(), before = records_before_.values.values();
    const bool moved = std::memcmp(now.data(), before.data(), now.size_bytes()) != 0;
    mesh_->derivative(list_.slots(), records_, displacements_, mesh_sums_.data(), moved);
  }
  sum_pairs(POLHODE_CURRENT_OVERLOAD(pair_derivative, PairLoop), false, &displacements_, slope);
}

/// Updates the list and the records for a state.
template <class T>
void PairEngine<T>::update(const State& state) {
  if (list_.width() == lanes<T>() && place(state) < list_.allowed2()) return;
  build_list(state);
  place(state);
}

/// Resets a Load to 0 and adds the contribution of the mesh.
template <class T>
void PairEngine<T>::clear(const State& state, Load& load) {
  if (load.f.size() != state.size()) load = Load(state.size());
  load.van_der_waals = load.coulomb = load.mesh = 0;
  load.virial = {};
  std::fill_n(mesh_sums_.data(), mesh_sums_.size(), T{});
}

/// Adds the sums of the pair loops and of the mesh to a Load.
template <class T>
void PairEngine<T>::sum_pairs(PairLoop loop, bool energies, const SiteRecords<T>* displacements,
                              Load& load) {
  workers_.each(sums_.size(), [&](std::size_t c) { sum_chunk(c, loop, energies, displacements); });
  collect_all(load);
  for (const ChunkSums<T>& sums : sums_) {
    load.van_der_waals += sums.van_der_waals;
    load.coulomb += sums.coulomb;
    for (std::size_t k = 0; k < 3; ++k) load.virial[k] += sums.virial[k];
  }
}

/// Calls body(part, task, first, end) for the slots in each task.
template <class T>
template <class Body>
void PairEngine<T>::each_task_of_slots(const Body& body) {
  for (std::size_t p = 0; p < sites_.size(); ++p) {
    const Slots::Part& part = list_.slots().parts[p];
    const std::size_t slots = blocks(part.count, slot_block) * slot_block;
    each_block(slots, slots_at_once, workers_, [&](std::size_t first, std::size_t end) {
      body(p, (part.first + first) / slot_block, part.first + first, part.first + end);
    });
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
  moved2_.assign(list_.slots().size() / slot_block, 0);
  each_task_of_slots([&](std::size_t part, std::size_t task, std::size_t first, std::size_t end) {
    moved2_[task] = place_sites({state, list_.slots(), sites_[part], first, end, records_});
  });
  return *std::max_element(moved2_.begin(), moved2_.end());
}

/// Fills the records of displacements.
template <class T>
void PairEngine<T>::displace(const State& state, const Vec3Column& dq, const Vec3Column& dtheta) {
  const auto displace_sites =
      POLHODE_CURRENT_OVERLOAD(displace_sites, void (*)(const DisplaceJob<T>&));
  each_task_of_slots([&](std::size_t part, std::size_t, std::size_t first, std::size_t end) {
    displace_sites({state, list_.slots(), sites_[part], first, end, dq, dtheta, displacements_});
  });
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
void PairEngine<T>::sum_chunk(std::size_t c, PairLoop loop, bool energies,
                              const SiteRecords<T>* displacements) {
  const ListChunk& chunk = list_.chunks()[c];
  ChunkSums<T>& sums = sums_[c];
  std::fill_n(sums.values.data(), sums.values.size(), T{});
  sums.van_der_waals = sums.coulomb = 0;
  sums.virial = {};
  const std::size_t with_rows = std::min(sites_.size(), list_.own_parts() + chunk.part);
  for (std::size_t partner = chunk.part; partner < with_rows; ++partner)
    loop({tables_(chunk.part, partner), laws_, treatment_, energies, list_, chunk, partner,
          records_, sums, displacements});
}

/// Adds the forces from all chunks to all slots.
template <class T>
void PairEngine<T>::collect_all(Load& load) {
  workers_.each(sums_.size(), [&](std::size_t c) {
    const ListChunk& chunk = list_.chunks()[c];
    collect(chunk.part, chunk.first, chunk.end, load);
  });
  for (std::size_t part = list_.own_parts(); part < sites_.size(); ++part)
    collect(part, list_.slots().parts[part].first, list_.slots().parts[part].end(), load);
}

/// Adds the forces from all chunks, in a fixed order, to the slots first ≤ s < end of a part.
template <class T>
void PairEngine<T>::collect(std::size_t p, std::uint32_t first, std::uint32_t end,
                            Load& load) const {
  constexpr std::uint32_t block = slot_block;
  constexpr std::size_t stride = ChunkSums<T>::stride;
  const Slots& slots = list_.slots();
  const Slots::Part& part = slots.parts[p];
  const bool turns = std::any_of(sites_[p].begin(), sites_[p].end(),
                                 [](const Vec3<double>& r) { return norm2(r) > 0; });
  for (; first < end; first += block) {
    const std::uint32_t n = std::min(block, end - first);
    std::array<double, block * stride> total{};
    if (mesh_) std::copy_n(&mesh_sums_[first * stride], n * stride, total.begin());
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      // Windows begin at block boundaries, so a block lies either entirely in a window or entirely
      // outside it.
      const SlotWindow& window = list_.chunks()[k].windows[p];
      const std::uint32_t at = first - window.first + (first < window.first ? part.count : 0);
      if (at >= window.count) continue;
      const T* const from = &sums_[k].values[(sums_[k].first[p] + at) * stride];
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

std::unique_ptr<AnyPairEngine> pair_engine(const Topology& topology, const ForceSettings& settings,
                                           const Box& box, Workers& workers,
                                           std::size_t ghost_parts) {
  const auto in = [&]<class T>(std::in_place_type_t<PairEngine<T>>) {
    return std::make_unique<AnyPairEngine>(
        PairEngine<T>(topology, settings, box, workers, ghost_parts));
  };
  return settings.precision == Precision::mixed ? in(std::in_place_type<PairEngine<float>>)
                                                : in(std::in_place_type<PairEngine<double>>);
}

}  // namespace polhode
