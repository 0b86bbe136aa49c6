// SPDX-License-Identifier: MIT
#include "mesh_influence.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

double power(double x, int n) {
  double product = 1;
  for (; n > 0; n /= 2, x *= x)
    if (n % 2 == 1) product *= x;
  return product;
}

}  // namespace

Influence::Influence(const MeshSettings& settings, const Box& box)
    : split_(settings.cutoff, settings.exponent), volume_(box.volume()) {
  // The contribution of wave number n + l × points, an alias of n, decreases as l^(2 − 2 order).
  // The omitted aliases add up to less than 1e-9.
  constexpr int aliases = 30;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto points = static_cast<double>(settings.points[d]);
    for (std::size_t n = 0; n < settings.points[d]; ++n) {
      const double signed_n = static_cast<double>(n) - (2 * n > settings.points[d] ? points : 0);
      Wave wave{2 * units::pi * signed_n / box.edge[d], {}, 0, 0};
      const int next = signed_n > 0 ? -1 : 1;
      const double sine =
          std::sin(units::pi * signed_n / points);  // numerator of all aliases, except for the sign
      for (int l = -aliases; l <= aliases; ++l) {
        const double m = signed_n + l * points, angle = units::pi * m / points;
        const double k = 2 * units::pi * m / box.edge[d];
        const double share = m == 0 ? 1 : power(sine / angle, 2 * settings.order);
        if (l == 0) wave.near[0] = {k, share};
        if (l == next) wave.near[1] = {k, share};
        wave.all += share;
        wave.all_k2 += share * k * k;
      }
      axes_[d].push_back(wave);
    }
  }
}

InfluenceValue Influence::operator()(const std::array<std::size_t, 3>& n) const {
  const Wave &x = axes_[0][n[0]], &y = axes_[1][n[1]], &z = axes_[2][n[2]];
  const double k2 = x.k * x.k + y.k * y.k + z.k * z.k;
  if (k2 == 0) return {0, 0};
  const double all = x.all * y.all * z.all;
  const double all_k2 =
      x.all_k2 * y.all * z.all + x.all * y.all_k2 * z.all + x.all * y.all * z.all_k2;
  // The sum Σ U² ρ and the slope of this sum. Aliases with small terms are omitted, because they do
  // not affect the error.
  const double min_share = 1e-3 * x.near[0].share * y.near[0].share * z.near[0].share;
  TransformValue density{0, 0};
  for (const Alias& a : x.near)
    for (const Alias& b : y.near)
      for (const Alias& c : z.near) {
        const double share = a.share * b.share * c.share;
        if (share < min_share) continue;
        const TransformValue there = split_.transform(std::sqrt(a.k * a.k + b.k * b.k + c.k * c.k));
        density.value += share * there.value;
        density.slope += share * there.slope;
      }
  const double strength = units::coulomb * 4 * units::pi / (volume_ * all * all_k2);
  return {strength * density.value, strength * (density.slope - 2 * density.value) / k2};
}

InfluenceTable::InfluenceTable(const Influence& influence, const std::array<std::size_t, 3>& points,
                               const Box& box, Workers& workers)
    : points_(points),
      cubic_(box.edge.x == box.edge.y && box.edge.y == box.edge.z && points[0] == points[1] &&
             points[1] == points[2]),
      values_(half(0) * half(1) * half(2)) {
  workers.each(half(0), [&](std::size_t x) {
    for (std::size_t y = cubic_ ? x : 0; y < half(1); ++y)
      for (std::size_t z = cubic_ ? y : 0; z < half(2); ++z)
        values_[place({x, y, z})] = influence({x, y, z});
  });
}

InfluenceValue InfluenceTable::operator()(std::array<std::size_t, 3> n) const {
  for (std::size_t d = 0; d < 3; ++d) n[d] = std::min(n[d], points_[d] - n[d]);
  if (cubic_) std::sort(n.begin(), n.end());
  return values_[place(n)];
}

}  // namespace polhode
