// SPDX-License-Identifier: MIT
#include "ewald.hpp"

#include <array>
#include <complex>

#include "forces/pairs/pair_table.hpp"
#include "polhode/math/rotation.hpp"

namespace polhode {
namespace {

using Complex = std::complex<double>;

void add_outer(Mat3<double>& to, const Vec3<double>& a, const Vec3<double>& b) {
  for (std::size_t d = 0; d < 3; ++d) to[d] += a[d] * b;
}

/// e^(i n g·r) of each charge for 0 ≤ n ≤ most, one direction of the box.
std::vector<Complex> phases(const PointCharges& charges, double edge, std::size_t d, int n_max) {
  const auto modes = static_cast<std::size_t>(n_max) + 1;
  std::vector<Complex> e(charges.size() * modes);
  for (std::size_t i = 0; i < charges.size(); ++i)
    for (std::size_t n = 0; n < modes; ++n)
      e[n * charges.size() + i] =
          std::polar(1.0, 2 * units::pi / edge * static_cast<double>(n) * charges.r[i][d]);
  return e;
}

template <class Split>
void add_pairs(const PointCharges& charges, const Box& box, const Split& split, double cutoff,
               EwaldSum& sum) {
  // The minimum image is within half an edge, so images up to these can be within the cutoff.
  Vec3<int> images;
  for (std::size_t d = 0; d < 3; ++d)
    images[d] = static_cast<int>(std::floor(cutoff / box.edge[d] + 0.5));
  const auto visit = [&](std::size_t i, std::size_t j, const Vec3<double>& R, double weight) {
    const double r2 = norm2(R);
    if (r2 >= cutoff * cutoff) return;
    const double strength = weight * units::coulomb * charges.q[i] * charges.q[j];
    const RadialValue value = split.pair(std::sqrt(r2));
    sum.energy.pairs += strength * value.u;
    const Vec3<double> f = strength * value.s * R;
    sum.f[j] += f;
    sum.f[i] -= f;
    add_outer(sum.virial, R, f);
  };
  for (std::size_t i = 0; i < charges.size(); ++i)
    for (std::size_t j = i; j < charges.size(); ++j) {
      const bool same = charges.body[i] == charges.body[j];
      Vec3<double> nearest = charges.r[j] - charges.r[i];
      if (!same) nearest = box.minimum_image(nearest);
      const Vec3<int> image_range = same ? images + Vec3<int>{1, 1, 1} : images;
      for (int x = -image_range.x; x <= image_range.x; ++x)
        for (int y = -image_range.y; y <= image_range.y; ++y)
          for (int z = -image_range.z; z <= image_range.z; ++z) {
            if (same && x == 0 && y == 0 && z == 0) continue;
            const Vec3<double> shift{x * box.edge.x, y * box.edge.y, z * box.edge.z};
            visit(i, j, nearest + shift, i == j ? 0.5 : 1.0);  // a charge meets each of its own
                                                               // images twice
          }
    }
}

template <class Split>
void add_intramolecular(const PointCharges& charges, const Split& split, EwaldSum& sum) {
  for (std::size_t i = 0; i < charges.size(); ++i)
    for (std::size_t j = i + 1; j < charges.size() && charges.body[j] == charges.body[i]; ++j) {
      const Vec3<double> R = charges.r[j] - charges.r[i];
      const RadialValue value = split.smooth(norm(R));
      const double strength = units::coulomb * charges.q[i] * charges.q[j];
      sum.energy.intramolecular -= strength * value.u;
      const Vec3<double> f = -strength * value.s * R;
      sum.f[j] += f;
      sum.f[i] -= f;
      add_outer(sum.virial, R, f);
    }
}

}  // namespace

PointCharges point_charges(const Topology& topology, const State& state) {
  PointCharges charges;
  std::size_t body = 0;
  for (const auto& part : topology.parts) {
    const InteractionSites sites(part.molecule);
    for (std::size_t n = 0; n < part.count; ++n, ++body)
      for (std::size_t k = 0; k < sites.charged; ++k) {
        charges.r.push_back(state.q[body] + to_lab(state.orientation[body], sites.sites[k].r));
        charges.q.push_back(sites.sites[k].charge);
        charges.body.push_back(body);
      }
  }
  return charges;
}

template <class Split>
EwaldSum reciprocal_sum(const PointCharges& charges, const Box& box, const Split& split,
                        double k_max) {
  const std::size_t count = charges.size();
  EwaldSum sum{{}, std::vector<Vec3<double>>(count), {}};
  std::array<int, 3> n_max{};
  std::array<std::vector<Complex>, 3> e;
  for (std::size_t d = 0; d < 3; ++d) {
    n_max[d] = static_cast<int>(k_max * box.edge[d] / (2 * units::pi));
    e[d] = phases(charges, box.edge[d], d, n_max[d]);
  }
  const auto phase = [&](std::size_t d, int n, std::size_t i) {
    const Complex forward = e[d][static_cast<std::size_t>(std::abs(n)) * count + i];
    return n < 0 ? std::conj(forward) : forward;
  };
  std::vector<Complex> layer(count), wave(count);
  for (int x = 0; x <= n_max[0]; ++x)  // k and −k contribute equally
    for (int y = x == 0 ? 0 : -n_max[1]; y <= n_max[1]; ++y) {
      for (std::size_t i = 0; i < count; ++i)
        layer[i] = charges.q[i] * phase(0, x, i) * phase(1, y, i);
      for (int z = x == 0 && y == 0 ? 1 : -n_max[2]; z <= n_max[2]; ++z) {
        const Vec3<double> k{2 * units::pi * x / box.edge.x, 2 * units::pi * y / box.edge.y,
                             2 * units::pi * z / box.edge.z};
        const double k2 = norm2(k);
        if (k2 >= k_max * k_max) continue;
        Complex S = 0;
        for (std::size_t i = 0; i < count; ++i) S += wave[i] = layer[i] * phase(2, z, i);
        const TransformValue density = split.transform(std::sqrt(k2));
        const double strength = units::coulomb * 4 * units::pi / (k2 * box.volume());
        const double energy = strength * density.value * std::norm(S);
        sum.energy.reciprocal += energy;
        for (std::size_t d = 0; d < 3; ++d) sum.virial[d][d] += energy;
        add_outer(sum.virial, k,
                  strength * std::norm(S) * (density.slope - 2 * density.value) / k2 * k);
        for (std::size_t i = 0; i < count; ++i)
          sum.f[i] += 2 * strength * density.value * std::imag(wave[i] * std::conj(S)) * k;
      }
    }
  return sum;
}

template <class Split>
EwaldSum ewald_sum(const PointCharges& charges, const Box& box, const Split& split,
                   const EwaldRange& range) {
  EwaldSum sum = reciprocal_sum(charges, box, split, range.k_max);
  add_pairs(charges, box, split, range.cutoff, sum);
  add_intramolecular(charges, split, sum);
  double net = 0, squares = 0;
  for (const double q : charges.q) net += q, squares += q * q;
  sum.energy.self = -units::coulomb / 2 * split.smooth_at_zero() * squares;
  sum.energy.background = -units::coulomb / 2 * net * net * split.integral() / box.volume();
  for (std::size_t d = 0; d < 3; ++d) sum.virial[d][d] += sum.energy.background;
  return sum;
}

template EwaldSum reciprocal_sum(const PointCharges&, const Box&, const GaussianSplit&, double);
template EwaldSum reciprocal_sum(const PointCharges&, const Box&, const CompactSplit&, double);
template EwaldSum ewald_sum(const PointCharges&, const Box&, const GaussianSplit&,
                            const EwaldRange&);
template EwaldSum ewald_sum(const PointCharges&, const Box&, const CompactSplit&,
                            const EwaldRange&);

}  // namespace polhode
