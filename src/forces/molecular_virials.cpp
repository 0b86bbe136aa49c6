// SPDX-License-Identifier: MIT
#include "polhode/forces/molecular_virials.hpp"

#include "forces/constant_terms.hpp"
#include "forces/fluid_pairs.hpp"
#include "forces/laws/slab_dispersion.hpp"

namespace polhode {

struct MolecularVirials::Parts {
  FluidPairs fluid;
  std::optional<SlabDispersion> slab;
  Vec3<double> constant;  // of each molecule
  Vec3Column virials;
};

MolecularVirials::MolecularVirials(const Topology& topology, const ForceSettings& settings,
                                   const Box& box)
    : parts_(std::make_unique<Parts>(
          Parts{FluidPairs(topology, settings, box, "the virial of each molecule"), {}, {}, {}})) {
  if (settings.slab_dispersion) parts_->slab.emplace(topology, settings, box);
  const Mat3<double> all =
      constant_terms_of(topology, settings, box, tail_of(topology, settings)).virial;
  const auto molecules = static_cast<double>(topology.size());
  parts_->constant = 1 / molecules * Vec3<double>{all[0].x, all[1].y, all[2].z};
}

MolecularVirials::MolecularVirials(MolecularVirials&&) noexcept = default;
MolecularVirials::~MolecularVirials() = default;

const Vec3Column& MolecularVirials::operator()(const State& state) {
  auto& [fluid, slab, constant, virials] = *parts_;
  fluid.place(state);
  virials = Vec3Column(state.size(), constant);
  POLHODE_CURRENT_LOOPS(pair_virials)(fluid.job(0.5), virials);
  if (fluid.mesh) fluid.mesh->add_virials(fluid.motion, virials);
  if (slab) slab->add_virials(state, virials);
  return virials;
}

}  // namespace polhode
