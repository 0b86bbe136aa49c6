// SPDX-License-Identifier: MIT
// The heat flux and the virials of pairs: a direct sum over all pairs within range, without a
// neighbour list. A body interacts with a pack of partners at once.
#include "forces/pairs/pair_heat_flux.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/pack_functions.hpp"
#include "base/pack_integers.hpp"
#include "forces/pairs/molecule_pair.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

using Real = Pack<double>;

/// The partners of a body, and the vectors to them. Each body may be a partner by eight images.
struct Partners {
  std::size_t count = 0;
  std::vector<std::uint32_t> body;
  std::array<std::vector<double>, 3> R;
  explicit Partners(std::size_t bodies) : body(8 * bodies + Real::width) {
    for (auto& component : R) component.resize(body.size());
  }
  /// Adds a partner if it is within range, without a branch.
  void add(std::size_t j, const Vec3<double>& to, bool is_within) {
    body[count] = static_cast<std::uint32_t>(j);
    R[0][count] = to.x, R[1][count] = to.y, R[2][count] = to.z;
    count += is_within ? 1 : 0;
  }
  /// Repeats the first partner to fill a pack.
  void fill_pack() {
    const std::size_t end = (count + Real::width - 1) / Real::width * Real::width;
    for (std::size_t k = count; k < end; ++k) {
      body[k] = body[0];
      for (auto& component : R) component[k] = component[0];
    }
  }
};

/// The components of an image vector along an edge: the nearest one, and the next one if it may be
/// within range.
struct Images {
  std::array<double, 2> at;
  std::size_t count;
  Images(double difference, double edge, double range) {
    const double near = difference - edge * std::nearbyint(difference / edge);
    at = {near, near > 0 ? near - edge : near + edge};
    count = std::abs(at[1]) < range ? 2 : 1;
  }
};

/// Finds the partners of body i among the later bodies, with all images within range.
void find(const PairHeatFluxJob& job, std::size_t i, Partners& partners) {
  const Vec3<double> q = job.motion.q[i];
  const double range2 = job.range * job.range;
  partners.count = 0;
  for (std::size_t j = i + 1; j < job.motion.q.size(); ++j) {
    const Vec3<double> to = job.motion.q[j] - q;
    const Images x(to.x, job.edge.x, job.range), y(to.y, job.edge.y, job.range),
        z(to.z, job.edge.z, job.range);
    for (std::size_t k = 0; k < x.count; ++k)
      for (std::size_t l = 0; l < y.count; ++l)
        for (std::size_t m = 0; m < z.count; ++m) {
          const Vec3<double> R{x.at[k], y.at[l], z.at[m]};
          partners.add(j, R, norm2(R) < range2);
        }
  }
  partners.fill_pack();
}

Vec3<Real> lanes_of(const Vec3Column& column, const std::uint32_t* body) {
  return {gather_lanes(column.x.data(), body), gather_lanes(column.y.data(), body),
          gather_lanes(column.z.data(), body)};
}

Vec3<Real> all_lanes(const Vec3<double>& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }

class FluidSums {
 public:
  explicit FluidSums(const PairHeatFluxJob& job)
      : job_(job),
        shape_(job.table),
        own_(job.motion.arms.size()),
        partner_(job.motion.arms.size()) {}

  template <CutoffTreatment treatment>
  Vec3<double> flux() {
    Vec3<Real> total{};
    each_pack<treatment>(
        [&](std::size_t i, const std::uint32_t* body, std::size_t count, const Vec3<Real>& R,
            const PairLoad<Real>& pair) { total += first_of(flux_of(i, body, R, pair), count); });
    return sum_of_lanes(total);
  }

  template <CutoffTreatment treatment>
  void add_virials(Vec3Column& virials) {
    each_pack<treatment>([&](std::size_t i, const std::uint32_t* body, std::size_t count,
                             const Vec3<Real>& R, const PairLoad<Real>& pair) {
      const Vec3<Real> half = first_of(
          {Real(0.5) * R.x * pair.f.x, Real(0.5) * R.y * pair.f.y, Real(0.5) * R.z * pair.f.z},
          count);
      virials.add(i, sum_of_lanes(half));
      alignas(pack_bytes) std::array<std::array<double, Real::width>, 3> of;
      for (std::size_t d = 0; d < 3; ++d) half[d].store(of[d].data());
      for (std::size_t lane = 0; lane < std::min<std::size_t>(count, Real::width); ++lane)
        virials.add(body[lane], {of[0][lane], of[1][lane], of[2][lane]});
    });
  }

 private:
  static Vec3<double> sum_of_lanes(const Vec3<Real>& v) { return {sum(v.x), sum(v.y), sum(v.z)}; }
  /// Zero in all lanes but the first ones.
  static Vec3<Real> first_of(const Vec3<Real>& v, std::size_t count) {
    const auto counted = first_lanes<double>(count);
    return {select(counted, v.x, Real(0)), select(counted, v.y, Real(0)),
            select(counted, v.z, Real(0))};
  }

  /// Calls visit(i, partners, count, R, loads) for each body i and each pack of its partners, of
  /// which the first `count` are counted. R are the vectors to the partners.
  template <CutoffTreatment treatment, class Visit>
  void each_pack(const Visit& visit) {
    Partners partners(job_.motion.q.size());
    for (std::size_t i = 0; i + 1 < job_.motion.q.size(); ++i) {
      find(job_, i, partners);
      for (std::size_t a = 0; a < own_.size(); ++a) own_[a] = all_lanes(job_.motion.arms[a][i]);
      for (std::size_t k = 0; k < partners.count; k += Real::width) {
        const Vec3<Real> R = vectors_to(partners, k);
        visit(i, &partners.body[k], partners.count - k, R,
              loads_of<treatment>(&partners.body[k], R));
      }
    }
  }

  static Vec3<Real> vectors_to(const Partners& partners, std::size_t k) {
    alignas(pack_bytes) std::array<std::array<double, Real::width>, 3> at;
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t lane = 0; lane < Real::width; ++lane) at[d][lane] = partners.R[d][k + lane];
    return {Real::load(at[0].data()), Real::load(at[1].data()), Real::load(at[2].data())};
  }

  template <CutoffTreatment treatment>
  PairLoad<Real> loads_of(const std::uint32_t* body, const Vec3<Real>& R) {
    for (std::size_t b = 0; b < partner_.size(); ++b)
      partner_[b] = lanes_of(job_.motion.arms[b], body);
    return molecule_pair<treatment, true>(
        shape_, job_.table.any_law<double>(), job_.laws, R, [&](std::size_t a) { return own_[a]; },
        [&](std::size_t b) { return partner_[b]; });
  }

  Vec3<Real> flux_of(std::size_t i, const std::uint32_t* body, const Vec3<Real>& R,
                     const PairLoad<Real>& pair) const {
    const Motion& m = job_.motion;
    const Vec3<Real> v_i = all_lanes(m.v[i]), v_j = lanes_of(m.v, body);
    const Real power_i = dot(pair.tau_a(R), all_lanes(m.omega[i])) - dot(pair.f, v_i),
               power_j = dot(pair.tau_b, lanes_of(m.omega, body)) + dot(pair.f, v_j);
    const Real first(job_.share), second(1 - job_.share);
    const Real u = pair.van_der_waals + pair.coulomb;
    return u * (first * v_i + second * v_j) + (first * power_j - second * power_i) * R;
  }

  const PairHeatFluxJob& job_;
  const AnyShape<1> shape_;
  std::vector<Vec3<Real>> own_, partner_;  // arms of a body and of a pack of its partners
};

/// Calls a template with the treatment of the cutoff.
template <class Sum>
auto with_treatment(CutoffTreatment treatment, const Sum& sum) {
  switch (treatment) {
    case CutoffTreatment::molecule_switch:
      return sum.template operator()<CutoffTreatment::molecule_switch>();
    case CutoffTreatment::site_switch:
      return sum.template operator()<CutoffTreatment::site_switch>();
    case CutoffTreatment::site_shift:
      return sum.template operator()<CutoffTreatment::site_shift>();
    default:
      return sum.template operator()<CutoffTreatment::smooth>();
  }
}

}  // namespace

Vec3<double> pair_heat_flux(const PairHeatFluxJob& job) {
  FluidSums sums(job);
  return with_treatment(
      job.treatment, [&]<CutoffTreatment treatment>() { return sums.template flux<treatment>(); });
}

void pair_virials(const PairHeatFluxJob& job, Vec3Column& virials) {
  FluidSums sums(job);
  with_treatment(job.treatment, [&]<CutoffTreatment treatment>() {
    sums.template add_virials<treatment>(virials);
  });
}

}  // namespace polhode::POLHODE_LOOPS
