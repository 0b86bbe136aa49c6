// SPDX-License-Identifier: MIT
// The Ornstein-Uhlenbeck flow over packs of bodies. The bodies are processed in ranges of whole
// packs; only the last range may end within a pack.
#include <algorithm>
#include <array>

#include "base/pack.hpp"
#include "base/pack_column.hpp"
#include "base/pack_functions.hpp"
#include "base/pack_math.hpp"
#include "base/word_pack.hpp"
#include "ensemble/langevin_terms.hpp"
#include "polhode/math/random.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

namespace {

constexpr std::size_t words = 8;  // random words of 32 bits per body: two blocks of Philox

/// Uniform deviates in (0, 1) for the bodies of a pack: (w + 1/2)/2³² for each random word w.
std::array<Real, words> uniforms(const LangevinTerms& terms, std::size_t first) {
  const std::uint64_t seed = terms.seed, stream = terms.stream;
  const auto number = [&](std::size_t i) {
    return terms.numbers == nullptr ? i : terms.numbers[i];
  };
  const auto word = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  std::array<Real, words> u;
  for (std::size_t b = 0; b < 2; ++b) {
    alignas(pack_bytes) std::uint64_t n[Real::width];
    for (std::size_t k = 0; k < Real::width; ++k) n[k] = 2 * number(first + k) + b;
    const WordPack counter = WordPack::load(n);
    const auto block =
        philox<WordPack>({counter, upper_half(counter), word(stream), word(stream >> 32)},
                         {word(seed), word(seed >> 32)});
    for (std::size_t w = 0; w < 4; ++w)
      u[4 * b + w] = (block[w].numbers() + Real(0.5)) * Real(0x1p-32);
  }
  return u;
}

struct TwoNormals {
  Real first, second;
};

/// Two independent normal deviates, from two uniform deviates [box1958]. The largest possible
/// normal deviate is 6.8. An exact normal distribution exceeds 6.8 once in 10¹¹ deviates.
TwoNormals normals(Real radius, Real angle) {
  const Real r = sqrt(Real(-2) * log(radius));
  const Real a = Real(2 * units::pi) * angle;
  return {r * cos(a), r * sin(a)};
}

Vec3<Real> scaled_by(const Vec3<Real>& v, Real s) { return {v.x * s, v.y * s, v.z * s}; }

Vec3<Real> roots(const Vec3<Real>& v) { return {sqrt(v.x), sqrt(v.y), sqrt(v.z)}; }

}  // namespace

LangevinSums langevin(State& state, const Bodies& bodies, const LangevinTerms& terms,
                      std::size_t first, std::size_t end) {
  Real heat(0), mass(0);
  Vec3<Real> momentum{Real(0), Real(0), Real(0)};
  for (std::size_t i = first; i < end; i += Real::width) {
    const auto here = first_lanes<double>(std::min(Real::width, end - i));  // excludes the padding
    const auto without_padding = [&](Real term) { return select(here, term, Real(0)); };
    const std::array<Real, words> u = uniforms(terms, i);
    const TwoNormals a = normals(u[0], u[4]), b = normals(u[1], u[5]), c = normals(u[2], u[6]);

    const Vec3<Real> p = load_pack<Real>(state.p, i);
    const Vec3<Real> xi =
        scaled_by({a.first, a.second, b.first}, Real(terms.noise) * sqrt(Real::load(&bodies.m[i])));
    const Vec3<Real> new_p = scaled_by(p, Real(terms.c)) + xi;
    store_pack(new_p, state.p, i);

    const Quaternion<Real> orientation = load_pack<Real>(state.orientation, i);
    const Vec3<Real> L = to_body(orientation, load_pack<Real>(state.ell, i));  // L = S ell
    const Vec3<Real> chi = scaled_by(
        scaled(roots(load_pack<Real>(bodies.J, i)), Vec3<Real>{b.second, c.first, c.second}),
        Real(terms.rotational_noise));
    const Vec3<Real> new_L = scaled_by(L, Real(terms.rotational_c)) + chi;
    store_pack(to_lab(orientation, new_L), state.ell, i);

    const Vec3<Real> inverse_J = load_pack<Real>(bodies.inverse_J, i);
    heat += without_padding((norm2(new_p) - norm2(p)) * Real::load(&bodies.inverse_m[i]) +
                            dot(new_L, scaled(inverse_J, new_L)) - dot(L, scaled(inverse_J, L)));
    momentum +=
        Vec3<Real>{without_padding(new_p.x), without_padding(new_p.y), without_padding(new_p.z)};
    mass += without_padding(Real::load(&bodies.m[i]));
  }
  return {sum(heat) / 2, {sum(momentum.x), sum(momentum.y), sum(momentum.z)}, sum(mass)};
}

}  // namespace polhode::POLHODE_LOOPS
