// SPDX-License-Identifier: MIT
#include "polhode/forces/force_field.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/forces/pair_loops.hpp"
#include "polhode/forces/reference.hpp"
#include "polhode/math/dual.hpp"

namespace polhode {
namespace {

const ForceSettings& checked(const ForceSettings& s) {
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
  return s;
}

void zero(Column<double>& column) { std::fill_n(column.data(), column.padded_size(), 0.0); }

void clear(Load& load, std::size_t bodies) {
  if (load.f.size() != bodies) load = Load(bodies);
  for (Vec3Column* v : {&load.f, &load.tau}) zero(v->x), zero(v->y), zero(v->z);
  load.lennard_jones = load.coulomb = 0;
}

}  // namespace

ForceField::ForceField(const Topology& topology, const ForceSettings& settings, const Box& box)
    : topology_(topology),
      settings_(checked(settings)),
      tables_(topology),
      laws_(settings),
      list_(topology, settings, box),
      first_{0},
      shifts_(image_shifts(box)) {
  std::size_t most = 0;
  for (const auto& part : topology.parts) {
    sites_.emplace_back();
    for (const Site& site : Arms(part.molecule).sites) sites_.back().push_back(site.r);
    most = std::max(most, sites_.back().size());
    first_.push_back(first_.back() + part.count);
  }
  arms_ = ArmRecords(topology.size(), most);
}

void ForceField::operator()(const State& state, Load& load) {
  ++evaluations_;
  list_.update(state);
  clear(load, state.size());
  const std::size_t parts = topology_.parts.size();
  for (std::size_t part = 0; part < parts; ++part) POLHODE_CURRENT_LOOPS(site_arms)
  (state.attitude, sites_[part], first_[part], first_[part + 1], arms_);
  buffer_.reserve(list_.longest_row());
  for (std::size_t a = 0; a < parts; ++a)
    for (std::size_t b = a; b < parts; ++b) {
      const double reach = list_.reach(a, b);
      const PairJob job{tables_(a, b), laws_,         list_, arms_,        shifts_.data(),
                        first_[a],     first_[a + 1], b,     reach * reach};
      POLHODE_CURRENT_LOOPS(pair_forces)(job, buffer_, load);
    }
}

Load ForceField::directional_derivative(const State& state, const Vec3Column& dq,
                                        const Vec3Column& dtheta) const {
  std::vector<Pose<Dual>> poses(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> a = state.attitude[i];
    const Vec3<double> q = state.q[i], u = dq[i], v = dtheta[i];
    const Quaternion<double> da = scaled(a * Quaternion<double>{0, v.x, v.y, v.z}, 0.5);
    poses[i] = {{{q.x, u.x}, {q.y, u.y}, {q.z, u.z}},
                {{a.w, da.w}, {a.x, da.x}, {a.y, da.y}, {a.z, da.z}}};
  }
  const ReferenceLoad<Dual> exact = reference_load(topology_, settings_, state.box, poses);
  Load slope(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto slopes = [](const Vec3<Dual>& v) {
      return Vec3<double>{v.x.slope, v.y.slope, v.z.slope};
    };
    slope.f.set(i, slopes(exact.f[i]));
    slope.tau.set(i, slopes(exact.tau[i]));
  }
  slope.lennard_jones = exact.lennard_jones.slope;
  slope.coulomb = exact.coulomb.slope;
  return slope;
}

}  // namespace polhode
