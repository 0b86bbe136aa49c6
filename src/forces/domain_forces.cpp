// SPDX-License-Identifier: MIT
#include "polhode/forces/domain_forces.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "forces/constant_terms.hpp"
#include "forces/laws/check_settings.hpp"
#include "forces/laws/law_range.hpp"
#include "forces/pairs/pair_engine.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

Topology with_ghosts(const Topology& own, const std::vector<std::size_t>& ghosts) {
  Topology all = own;
  if (!ghosts.empty() && ghosts.size() != own.parts.size())
    throw Error(
        fmt::format("ghosts of {} kinds in DomainForces, which has {} kinds of molecules; give a "
                    "number for each kind, or none",
                    ghosts.size(), own.parts.size()));
  for (std::size_t kind = 0; kind < ghosts.size(); ++kind)
    all.parts.push_back({own.parts[kind].molecule, ghosts[kind]});
  return all;
}

double reach_of(const Topology& topology, const ForceSettings& settings) {
  return std::max(settings.cutoff, cutoff_of_charges(settings)) + 2 * topology.extent() +
         settings.skin;
}

// The box in which forces are computed. In directions that are not periodic, the edge is so long
// that no images of bodies interact. This condition holds if the extent of the bodies is at most
// the edge minus the range.
Box box_around(const Vec3<double>& extent, double reach, const Vec3<double>& period) {
  Box box;
  for (std::size_t d = 0; d < 3; ++d)
    box.edge[d] = period[d] > 0 ? period[d] : extent[d] + 2 * reach;
  return box;
}

double constant_energy(const Topology& own, const ForceSettings& settings, const Box& box) {
  const ConstantTerms terms = constant_terms_of(own, settings, box, 0);
  return terms.intramolecular + (settings.ewald_alpha ? 0 : terms.self);
}

const ForceSettings& without_slab(const ForceSettings& settings) {
  if (settings.slab_dispersion)
    throw Error(
        "slab_dispersion needs all bodies, but DomainForces has the bodies of a domain; leave "
        "slab_dispersion out");
  return settings;
}

}  // namespace

bool DomainForces::is_long_enough(double edge, const Topology& topology,
                                  const ForceSettings& settings) {
  return edge >= reach_of(topology, settings) &&
         edge >= 2 * std::max(settings.cutoff, cutoff_of_charges(settings));
}

DomainForces::DomainForces(const Topology& own, const std::vector<std::size_t>& ghosts,
                           const ForceSettings& settings, const Vec3<double>& period)
    : own_bodies_(own.size()),
      topology_(with_ghosts(own, ghosts)),
      settings_(without_slab(checked(settings))),
      reach_(reach_of(topology_, settings_)),
      period_(period),
      state_(topology_.size(), box_around({}, reach_, period_)),
      constant_(constant_energy(own, settings_, state_.box)),
      engine_(pair_engine(topology_, settings_, state_.box, Workers::serial(), ghosts.size())) {
  check_tables(topology_, settings_);
}

DomainForces::DomainForces(DomainForces&&) noexcept = default;
DomainForces& DomainForces::operator=(DomainForces&&) noexcept = default;
DomainForces::~DomainForces() = default;

void DomainForces::set_period(const Vec3<double>& period) {
  period_ = period;
  Box box = state_.box;
  for (std::size_t d = 0; d < 3; ++d)
    if (period[d] > 0) box.edge[d] = period[d];
  set_box(box);
}

void DomainForces::set_box(const Box& box) {
  state_.box = box;
  engine_->call([&](auto& engine) { engine.set_box(topology_, settings_, box); });
}

/// Sets a larger box if bodies could interact with images of other bodies in the present box.
void DomainForces::enclose() {
  Vec3<double> extent;
  bool fits = true;
  const Component* const columns[] = {&state_.q.x, &state_.q.y, &state_.q.z};
  for (std::size_t d = 0; d < 3; ++d) {
    if (period_[d] > 0) continue;
    const auto q = columns[d]->values();
    const auto [low, high] = std::minmax_element(q.begin(), q.end());
    extent[d] = *high - *low;
    fits = fits && extent[d] + reach_ <= state_.box.edge[d];
  }
  if (fits) return;
  set_box(box_around(extent, reach_, period_));
}

void DomainForces::operator()(Load& load, bool energies) {
  if (own_bodies_ == 0) {
    load = Load(state_.size());
    return;
  }
  enclose();
  engine_->call([&](auto& engine) { engine(state_, load, energies); });
  if (energies) load.coulomb += constant_;
}

}  // namespace polhode
