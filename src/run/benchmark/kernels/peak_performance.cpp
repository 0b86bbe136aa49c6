// SPDX-License-Identifier: MIT
// Peak performance of the processor: independent multiply-adds, and pairs of four-site waters
// without other work.
#include "run/benchmark/peak_performance.hpp"
#include "polhode/base/always_inline.hpp"

#include <array>

#include "base/pack.hpp"
#include "forces/pairs/molecule_pair.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The number of chains exceeds two arithmetic units times the latency of a multiply-add in cycles.
// The number of chains is smaller than the number of registers.
constexpr std::size_t chains = 12;

template <class T>
void multiply_adds(std::size_t rounds, T* numbers) {
  using Real = Pack<T>;
  // All loops over the chains are unrolled, because without unrolling the chains would be kept in
  // memory. The chains start from values in memory, so that the compiler cannot see that all chains
  // are equal.
  const auto each_chain = [](const auto& body)
                              POLHODE_INLINE_LAMBDA { each(Count<chains>{}, body); };
  std::array<Real, chains> sum;
  each_chain([&](auto k) POLHODE_INLINE_LAMBDA { sum[k] = Real::load(numbers + k * Real::width); });
  const Real a(static_cast<T>(0.999)), b(static_cast<T>(1e-3));
  for (std::size_t n = 0; n < rounds; ++n)
    each_chain([&](auto k) POLHODE_INLINE_LAMBDA { sum[k] = fma(sum[k], a, b); });
  each_chain([&](auto k) POLHODE_INLINE_LAMBDA { sum[k].store(numbers + k * Real::width); });
}

template <class T>
void store(const Vec3<Pack<T>>& v, T* to) {
  v.x.store(to), v.y.store(to + Pack<T>::width), v.z.store(to + 2 * Pack<T>::width);
}

template <class T, CutoffTreatment treatment, bool energies>
void water_pairs(const PairTable& table, const PairLaws<T>& laws, const T* own, const T* partners,
                 std::size_t packs, T* out) {
  using Real = Pack<T>;
  using Water = FixedShape<4, 3, 1>;
  const Water shape(table);
  Vec3<Real> tau_a;
  Real u;
  for (std::size_t p = 0; p < packs; ++p) {
    const T* const number = partners + p * 16 * Real::width;
    const auto column = [&](std::size_t k) { return Real::load(number + k * Real::width); };
    const Vec3<Real> R{column(0), column(1), column(2)};
    const auto load = molecule_pair<treatment, energies>(
        shape, table.template lennard_jones<T>(), laws, R,
        [&](std::size_t a) {
          return Vec3<Real>{Real(own[3 * a]), Real(own[3 * a + 1]), Real(own[3 * a + 2])};
        },
        [&](std::size_t b) {
          return Vec3<Real>{column(3 + 3 * b), column(4 + 3 * b), column(5 + 3 * b)};
        });
    tau_a += load.tau_a(R);
    T* const to = out + p * 6 * Real::width;
    store(load.f, to);
    store(load.tau_b, to + 3 * Real::width);
    if constexpr (energies) u += load.van_der_waals + load.coulomb;
  }
  store(tau_a + Vec3<Real>{u, u, u}, out);  // ensures that every result is used
}

template <class T>
void pairs(const PairTable& table, const PairLaws<T>& laws, bool truncated, bool energies,
           const T* own, const T* partners, std::size_t packs, T* out) {
  const auto with = [&]<CutoffTreatment how, bool u>() {
    water_pairs<T, how, u>(table, laws, own, partners, packs, out);
  };
  if (truncated)
    energies ? with.template operator()<CutoffTreatment::molecule_switch, true>()
             : with.template operator()<CutoffTreatment::molecule_switch, false>();
  else
    energies ? with.template operator()<CutoffTreatment::none, true>()
             : with.template operator()<CutoffTreatment::none, false>();
}

}  // namespace

std::size_t pack_width(const double*) { return Pack<double>::width; }
std::size_t pack_width(const float*) { return Pack<float>::width; }
void bare_multiply_adds(std::size_t rounds, double* numbers) { multiply_adds(rounds, numbers); }
void bare_multiply_adds(std::size_t rounds, float* numbers) { multiply_adds(rounds, numbers); }
void bare_pairs(const PairTable& table, const PairLaws<double>& laws, bool truncated, bool energies,
                const double* own, const double* partners, std::size_t packs, double* out) {
  pairs(table, laws, truncated, energies, own, partners, packs, out);
}
void bare_pairs(const PairTable& table, const PairLaws<float>& laws, bool truncated, bool energies,
                const float* own, const float* partners, std::size_t packs, float* out) {
  pairs(table, laws, truncated, energies, own, partners, packs, out);
}

}  // namespace polhode::POLHODE_LOOPS
