// SPDX-License-Identifier: MIT
// Multiplies the modes by the influence function.
#include "polhode/base/pack_transpose.hpp"
#include "polhode/forces/mesh/mesh_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T, bool energies>
void multiply(const ConvolveJob<T>& job, [[maybe_unused]] ModeSums* sums) {
  using Real = Pack<T>;
  for (std::size_t z = 0; z < job.rows; ++z) {
    T* const mode = job.modes + z * job.row;
    [[maybe_unused]] Pack<double> total[4];
    for (std::size_t c = 0; c < job.row; c += Real::width) {
      const Real S = Real::load(mode + c), G = Real::load(job.influence[z] + c), product = G * S;
      product.store(mode + c);
      if constexpr (energies) {
        const Real square = S * Real::load(job.weight + c);
        const Real slope = square * S * Real::load(job.slope[z] + c);
        const auto add = [&](Pack<double>& to, Real what) {
          for (const Pack<double>& part : promote(what)) to += part;
        };
        add(total[0], square * product);
        add(total[1], slope);
        add(total[2], slope * Real::load(job.kx + c));
        add(total[3], slope * Real::load(job.kx_squared + c));
      }
    }
    if constexpr (energies)
      sums[z] = {sum(total[0]) / 2, sum(total[1]) / 2, sum(total[2]) / 2, sum(total[3]) / 2};
  }
}

template <class T>
void multiply_rows(const ConvolveJob<T>& job, ModeSums* sums) {
  if (sums)
    multiply<T, true>(job, sums);
  else
    multiply<T, false>(job, sums);
}

}  // namespace

void convolve(const ConvolveJob<double>& job, ModeSums* sums) { multiply_rows(job, sums); }
void convolve(const ConvolveJob<float>& job, ModeSums* sums) { multiply_rows(job, sums); }

}  // namespace polhode::POLHODE_LOOPS
