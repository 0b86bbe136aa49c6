// SPDX-License-Identifier: MIT
#include "forces/laws/slab_dispersion.hpp"

#include <algorithm>

#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/rotation.hpp"

namespace polhode {
namespace {

/// The shortest wavelength [nm]. The transforms of shorter ones are below 0.1 % of v̂(0) at the
/// usual cutoffs, and the density of a liquid hardly has them.
constexpr double shortest_wave = 0.3;

}  // namespace

SlabDispersion::SlabDispersion(const Topology& topology, const ForceSettings& settings,
                               const Box& box)
    : box_(box),
      k1_(2 * units::pi / box.edge.z),
      modes_(static_cast<std::size_t>(box.edge.z / shortest_wave)) {
  const PairTables tables(topology, settings.mixing);
  std::vector<std::pair<std::size_t, std::size_t>> sites;  // part and index of each kind
  std::size_t first = 0;
  for (std::size_t part = 0; part < topology.parts.size(); ++part) {
    const auto& [molecule, count] = topology.parts[part];
    const InteractionSites interacting(molecule);
    for (std::size_t s = interacting.size() - interacting.dispersive; s < interacting.size(); ++s) {
      kinds_.push_back({first, count, interacting.sites[s].r});
      sites.emplace_back(part, s);
    }
    first += count;
  }
  std::vector<std::pair<TailTransform, std::vector<TailTransform::Mode>>> known;
  for (const auto& [part_a, a] : sites)
    for (const auto& [part_b, b] : sites) {
      const PairTable& table = tables(part_a, part_b);
      TailTransform tail(settings, table.any_law<double>().law[b * table.sites_a + a]);
      auto same = std::find_if(known.begin(), known.end(),
                               [&](const auto& other) { return other.first == tail; });
      if (same == known.end()) {
        std::vector<TailTransform::Mode> modes;
        for (std::size_t n = 1; n <= modes_; ++n)
          modes.push_back(tail.at(k1_ * static_cast<double>(n)));
        same = known.insert(known.end(), {std::move(tail), std::move(modes)});
      }
      transforms_.insert(transforms_.end(), same->second.begin(), same->second.end());
    }
}

/// Calls `site` for each site, with its kind, body, and place relative to the centre, in the lab
/// frame.
template <class Site>
void SlabDispersion::each_site(const State& state, const Site& site) const {
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    const auto& [first, count, place] = kinds_[kind];
    for (std::size_t i = first; i < first + count; ++i)
      site(kind, i, to_lab(state.orientation[i], place));
  }
}

/// Calls `add` for each mode with exp(ikz).
template <class Add>
void SlabDispersion::each_mode(double z, const Add& add) const {
  const Complex first = std::polar(1.0, k1_ * z);
  Complex wave = first;
  for (std::size_t n = 0; n < modes_; ++n, wave *= first) add(n, wave);
}

void SlabDispersion::densities(const State& state) {
  densities_.assign(kinds_.size() * modes_, 0);
  each_site(state, [&](std::size_t kind, std::size_t i, const Vec3<double>& arm) {
    Complex* of_kind = &densities_[kind * modes_];
    each_mode(state.q[i].z + arm.z, [&](std::size_t n, Complex wave) { of_kind[n] += wave; });
  });
}

/// Σ_b v̂_ab ρ_b of each kind a, or the same with the slopes of v̂.
SlabDispersion::Modes SlabDispersion::potentials_of(const Modes& densities,
                                                    double TailTransform::Mode::*of) const {
  Modes sum(densities.size());
  std::size_t t = 0;
  for (std::size_t a = 0; a < kinds_.size(); ++a)
    for (std::size_t b = 0; b < kinds_.size(); ++b)
      for (std::size_t n = 0; n < modes_; ++n)
        sum[a * modes_ + n] += transforms_[t++].*of * densities[b * modes_ + n];
  return sum;
}

/// The derivative of the energy with respect to z of a site, from the potentials of other sites.
double SlabDispersion::slope_at(const Modes& potentials, std::size_t kind, double z) const {
  double sum = 0;
  each_mode(z, [&](std::size_t n, Complex wave) {
    sum += static_cast<double>(n + 1) * (std::conj(wave) * potentials[kind * modes_ + n]).imag();
  });
  return 2 * k1_ / box_.volume() * sum;
}

/// Half of the energy of a site in the potentials of all sites.
double SlabDispersion::energy_at(const Modes& potentials, std::size_t kind, double z) const {
  double sum = 0;
  each_mode(z, [&](std::size_t n, Complex wave) {
    sum += (std::conj(wave) * potentials[kind * modes_ + n]).real();
  });
  return sum / box_.volume();
}

void SlabDispersion::add_virials(const State& state, Vec3Column& virials) {
  densities(state);
  const Modes potentials = potentials_of(densities_),
              slopes = potentials_of(densities_, &TailTransform::Mode::slope);
  each_site(state, [&](std::size_t kind, std::size_t i, const Vec3<double>& arm) {
    const double z = state.q[i].z + arm.z, energy = energy_at(potentials, kind, z);
    virials.add(i, {energy, energy,
                    energy + energy_at(slopes, kind, z) + slope_at(potentials, kind, z) * arm.z});
  });
}

/// @param moments  Σ f_z z over the sites, with z relative to the centre of the body
void SlabDispersion::add_energies(Load& load, const Modes& potentials, double moments) const {
  double energy = 0, slope = 0;
  for (std::size_t i = 0; i < potentials.size(); ++i)
    energy += (std::conj(densities_[i]) * potentials[i]).real();
  std::size_t t = 0;
  for (std::size_t a = 0; a < kinds_.size(); ++a)
    for (std::size_t b = 0; b < kinds_.size(); ++b)
      for (std::size_t n = 0; n < modes_; ++n)
        slope += transforms_[t++].slope *
                 (std::conj(densities_[a * modes_ + n]) * densities_[b * modes_ + n]).real();
  energy /= box_.volume(), slope /= box_.volume();
  load.van_der_waals += energy;
  load.virial[0].x += energy;
  load.virial[1].y += energy;
  load.virial[2].z += energy + slope - moments;
}

void SlabDispersion::add(const State& state, Load& load, bool energies) {
  densities(state);
  const Modes potentials = potentials_of(densities_);
  double moments = 0;
  each_site(state, [&](std::size_t kind, std::size_t i, const Vec3<double>& arm) {
    const Vec3<double> f{0, 0, -slope_at(potentials, kind, state.q[i].z + arm.z)};
    load.f.add(i, f);
    load.tau.add(i, cross(arm, f));
    moments += f.z * arm.z;
  });
  if (energies) add_energies(load, potentials, moments);
}

void SlabDispersion::add_derivative(const State& state, const Vec3Column& dq,
                                    const Vec3Column& dtheta, Load& slope) {
  densities(state);
  const Modes potentials = potentials_of(densities_);
  const auto turned = [&](std::size_t i, const Vec3<double>& arm) {
    return cross(to_lab(state.orientation[i], dtheta[i]), arm);
  };
  Modes change(densities_.size());
  each_site(state, [&](std::size_t kind, std::size_t i, const Vec3<double>& arm) {
    const Complex moved(0, k1_ * (dq[i].z + turned(i, arm).z));
    each_mode(state.q[i].z + arm.z, [&](std::size_t n, Complex wave) {
      change[kind * modes_ + n] += static_cast<double>(n + 1) * moved * wave;
    });
  });
  const Modes changed = potentials_of(change);
  each_site(state, [&](std::size_t kind, std::size_t i, const Vec3<double>& arm) {
    const Vec3<double> turn = turned(i, arm);
    const double z = state.q[i].z + arm.z, moved = dq[i].z + turn.z;
    double curvature = 0;
    each_mode(z, [&](std::size_t n, Complex wave) {
      const auto number = static_cast<double>(n + 1);
      curvature += number * number * (std::conj(wave) * potentials[kind * modes_ + n]).real();
    });
    curvature *= 2 * k1_ * k1_ / box_.volume();
    const Vec3<double> f{0, 0, -slope_at(potentials, kind, z)},
        df{0, 0, -slope_at(changed, kind, z) + curvature * moved};
    slope.f.add(i, df);
    slope.tau.add(i, cross(arm, df) + cross(turn, f));
  });
}

}  // namespace polhode
