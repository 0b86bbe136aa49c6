// SPDX-License-Identifier: MIT
#include "polhode/forces/force_field.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/forces/laws/law_range.hpp"
#include "polhode/forces/laws/tail.hpp"
#include "polhode/forces/mesh/mesh_choice.hpp"
#include "polhode/forces/mesh/self_interaction.hpp"
#include "polhode/forces/pairs/molecule_pair.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {
namespace {

constexpr double min_error_in_mixed = 1e-5;

const ForceSettings& validate(const ForceSettings& s) {
  if (!(s.cutoff > 0) || !std::isfinite(s.cutoff))
    throw Error(
        fmt::format("cutoff {} nm must be a positive length; 0.9 to 1.2 nm is usual", s.cutoff));
  if (!(s.switch_from > 0) || s.switch_from >= s.cutoff)
    throw Error(
        fmt::format("switch {} nm must lie between 0 and the cutoff ({} nm), where it ends; "
                    "without a switch the "
                    "energy has a kink and no scheme keeps its order",
                    s.switch_from, s.cutoff));
  if (s.smoothness < 1 || s.smoothness > 3)
    throw Error(
        fmt::format("smoothness {} must be 1, 2 or 3: the class of the switch", s.smoothness));
  if (!(s.dielectric >= 1))
    throw Error(fmt::format("dielectric {} must be 1 or more, or infinite", s.dielectric));
  if (!(s.skin > 0) || !std::isfinite(s.skin))
    throw Error(fmt::format("skin {} nm must be a positive length; 0.1 nm is usual", s.skin));
  if (s.electrostatics == Electrostatics::pme && s.precision == Precision::mixed &&
      s.pme_accuracy < min_error_in_mixed)
    throw Error(fmt::format(
        "accuracy {:g} is below {:g}, about what rounding to float leaves of forces on a "
        "mesh; take precision \"double\", or ask for {:g}",
        s.pme_accuracy, min_error_in_mixed, min_error_in_mixed));
  if (vanishes_at_cutoff(s.electrostatics) && s.truncation != Truncation::site_switch)
    throw Error(
        "electrostatics \"pme\" and \"damped-shifted-force\" go with truncation \"site-switch\", "
        "which then ends Lennard-Jones alone: charges have an ending of their own");
  if (s.electrostatics == Electrostatics::damped_shifted_force &&
      !(s.damping >= 0 && s.damping * s.cutoff <= max_damping))
    throw Error(fmt::format(
        "damping {:g} 1/nm must be 0 or more, and at most {:g} over the cutoff, {:.4g} 1/nm, where "
        "next to nothing is left of charges at the cutoff; 2 1/nm is usual",
        s.damping, max_damping, max_damping / s.cutoff));
  return s;
}

ForceSettings with_mesh(ForceSettings s, const Topology& topology, const Box& box) {
  check_tables(topology, s);
  if (s.electrostatics == Electrostatics::pme && !s.mesh)
    s.mesh = mesh_for(s.pme_accuracy, s.cutoff, box, topology);
  return s;
}

ConstantTerms constant_terms_of(const Topology& topology, const ForceSettings& s, const Box& box) {
  ConstantTerms terms;
  if (s.dispersion_correction) terms.dispersion = dispersion_tail(topology, s, box);
  for (std::size_t d = 0; d < 3; ++d) terms.virial[d][d] = terms.dispersion;
  if (s.electrostatics == Electrostatics::pme) {
    const MeshConstant mesh(topology, {s.cutoff, s.mesh->exponent}, box);
    terms.self = mesh.self;
    terms.intramolecular = mesh.intramolecular;
    terms.background = mesh.background;
    for (std::size_t d = 0; d < 3; ++d) terms.virial[d] += mesh.virial[d];
  } else if (const auto smooth = smooth_polynomial(s)) {
    const SelfInteraction own(topology, *smooth);
    terms.self = own.self;
    terms.intramolecular = own.intramolecular;
  }
  return terms;
}

using Engine = std::variant<PairEngine<double>, PairEngine<float>>;
Engine engine(const Topology& topology, const ForceSettings& settings, const Box& box,
              Workers& workers) {
  if (settings.precision == Precision::mixed)
    return Engine(std::in_place_type<PairEngine<float>>, topology, settings, box, workers);
  return Engine(std::in_place_type<PairEngine<double>>, topology, settings, box, workers);
}

}  // namespace

ForceField::ForceField(const Topology& topology, const ForceSettings& settings, const Box& box,
                       Workers& workers)
    : workers_(workers),
      topology_(topology),
      bodies_(topology),
      settings_(with_mesh(validate(settings), topology, box)),
      constant_(constant_terms_of(topology, settings_, box)),
      engine_(engine(topology, settings_, box, workers)) {}

void ForceField::evaluate(const State& state, Load& load, bool energies) {
  ++evaluations_;
  std::visit([&](auto& engine) { engine(state, load, energies); }, engine_);
  if (settings_.mesh) remove_net_force(load, bodies_, workers_);
  if (!energies) return;
  load.lennard_jones += constant_.dispersion;
  load.coulomb += constant_.coulomb();
  for (std::size_t d = 0; d < 3; ++d) load.virial[d] += constant_.virial[d];
}

void ForceField::directional_derivative(const State& state, const Vec3Column& dq,
                                        const Vec3Column& dtheta, Load& slope) {
  std::visit([&](auto& engine) { engine.derivative(state, dq, dtheta, slope); }, engine_);
  if (settings_.mesh) remove_net_force(slope, bodies_, workers_);
}

ListMemory ForceField::list_memory() const {
  ListMemory memory{{}, list_rebuilds()};
  if (neighbours().width() == 0) return memory;
  const Slots& slots = neighbours().slots();
  memory.built_at = Vec3Column(topology_.size());
  for (const Slots::Part& part : slots.parts)
    for (std::uint32_t s = part.first; s < part.end(); ++s)
      memory.built_at.set(slots.body[s], slots.built_at[s]);
  return memory;
}

void ForceField::resume_from(const ListMemory& memory) {
  if (memory.built_at.size() == 0) return;
  State state(memory.built_at.size(), neighbours().box());
  state.q = memory.built_at;
  std::visit([&](auto& engine) { engine.build_list(state); }, engine_);
  earlier_rebuilds_ = memory.rebuilds - neighbours().rebuilds();
}

}  // namespace polhode
