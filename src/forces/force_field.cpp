// SPDX-License-Identifier: MIT
#include "polhode/forces/force_field.hpp"

#include <utility>

#include "forces/constant_terms.hpp"
#include "forces/laws/check_settings.hpp"
#include "forces/laws/law_range.hpp"
#include "forces/laws/slab_dispersion.hpp"
#include "forces/pairs/pair_engine.hpp"
#include "polhode/base/error.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {
namespace {

/// The force settings, with a mesh chosen for the box unless a mesh was given.
ForceSettings with_mesh(ForceSettings s, const Topology& topology, const Box& box,
                        std::optional<MeshChoice>& choice) {
  check_tables(topology, s);
  const bool has_mesh = s.mesh && (!s.mesh_chosen_for || *s.mesh_chosen_for == box);
  if (s.electrostatics != Electrostatics::pme || has_mesh) return s;
  check_edges(box);
  if (!choice) choice.emplace(topology, s);
  s.mesh = (*choice)(box);
  s.mesh_chosen_for = box;
  return s;
}

const ForceSettings& without_other_mesh(const ForceSettings& settings) {
  if (settings.ewald_alpha)
    throw Error(
        "ewald_alpha is only for DomainForces, where another program computes the mesh part of the "
        "Ewald sum; leave ewald_alpha out");
  return settings;
}

}  // namespace

ForceField::ForceField(const Topology& topology, const ForceSettings& settings, const Box& box,
                       Workers& workers, std::optional<MeshChoice> choice)
    : workers_(workers),
      topology_(topology),
      bodies_(topology),
      mesh_choice_(std::move(choice)),
      settings_(with_mesh(checked(without_other_mesh(settings)), topology, box, mesh_choice_)),
      box_(box),
      tail_(tail_of(topology, settings_)),
      constant_(constant_terms_of(topology, settings_, box, tail_)),
      engine_(pair_engine(topology, settings_, box, workers)) {
  set_slab(box);
}

ForceField::ForceField(ForceField&&) noexcept = default;
ForceField::~ForceField() = default;

const NeighbourList& ForceField::neighbours() const {
  return engine_->call([](const auto& e) -> const NeighbourList& { return e.neighbours(); });
}

std::size_t ForceField::list_rebuilds() const {
  return neighbours().rebuilds() + earlier_rebuilds_;
}

/// If the box has changed, recomputes everything that depends on the box.
void ForceField::set_box(const Box& box) {
  if (box_ == box) return;
  box_.reset();
  settings_ = with_mesh(settings_, topology_, box, mesh_choice_);
  engine_->call([&](auto& engine) { engine.set_box(topology_, settings_, box); });
  constant_ = constant_terms_of(topology_, settings_, box, tail_);
  set_slab(box);
  box_ = box;
}

void ForceField::set_slab(const Box& box) {
  if (settings_.slab_dispersion)
    slab_ = std::make_unique<SlabDispersion>(topology_, settings_, box);
}

void ForceField::evaluate(const State& state, Load& load, bool energies) {
  set_box(state.box);
  ++evaluations_;
  engine_->call([&](auto& engine) { engine(state, load, energies); });
  if (settings_.mesh) remove_net_force(load, bodies_, workers_);
  if (slab_) slab_->add(state, load, energies);
  load.external = 0;
  if (settings_.external) settings_.external->add(state, load);
  if (!energies) {
    load.external = 0;
    load.virial = {};
    return;
  }
  load.van_der_waals += constant_.dispersion;
  load.coulomb += constant_.coulomb();
  for (std::size_t d = 0; d < 3; ++d) load.virial[d] += constant_.virial[d];
}

void ForceField::directional_derivative(const State& state, const Vec3Column& dq,
                                        const Vec3Column& dtheta, Load& slope) {
  set_box(state.box);
  engine_->call([&](auto& engine) { engine.derivative(state, dq, dtheta, slope); });
  if (settings_.mesh) remove_net_force(slope, bodies_, workers_);
  if (slab_) slab_->add_derivative(state, dq, dtheta, slope);
  if (settings_.external) add_derivative(*settings_.external, state, dq, dtheta, slope);
}

ListMemory ForceField::list_memory(const Box& box) const {
  ListMemory memory{{}, list_rebuilds()};
  if (neighbours().width() == 0 || neighbours().box() != box) return memory;
  const Slots& slots = neighbours().slots();
  memory.built_at = Vec3Column(topology_.size());
  for (const Slots::Part& part : slots.parts)
    for (std::uint32_t s = part.first; s < part.end(); ++s)
      memory.built_at.set(slots.body[s], slots.built_at[s]);
  return memory;
}

void ForceField::resume_from(const ListMemory& memory, const Box& box) {
  set_box(box);
  if (memory.built_at.size() > 0) {
    State state(memory.built_at.size(), box);
    state.q = memory.built_at;
    engine_->call([&](auto& engine) { engine.build_list(state); });
  }
  earlier_rebuilds_ = memory.rebuilds - neighbours().rebuilds();
}

}  // namespace polhode
