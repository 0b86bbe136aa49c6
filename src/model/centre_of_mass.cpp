// SPDX-License-Identifier: MIT
#include "polhode/model/centre_of_mass.hpp"

#include <algorithm>
#include <array>

#include "base/blocks.hpp"

namespace polhode {
namespace {

// The division into blocks depends only on the number of bodies, so that sums do not depend on the
// number of threads. The number of blocks is small, so that the sums of all blocks fit on the
// stack.
constexpr std::size_t max_blocks = 64;
std::size_t block_of(std::size_t size) {
  return std::max<std::size_t>(4096, blocks(size, max_blocks));
}

/// The sum Σ v, computed block by block in a fixed order.
Vec3<double> total(const Vec3Column& v, Workers& workers = Workers::serial()) {
  std::array<Vec3<double>, max_blocks> sums{};
  const std::size_t block = block_of(v.size());
  each_block(v.size(), block, workers, [&](std::size_t first, std::size_t end) {
    Vec3<double> sum{};
    for (std::size_t i = first; i < end; ++i) sum += v[i];
    sums[first / block] = sum;
  });
  Vec3<double> all{};
  for (const Vec3<double>& sum : sums) all += sum;
  return all;
}

/// Subtracts a vector u in proportion to the mass of each body: v ← v − (m/M) u. For a single body
/// the result is exactly v − u.
void subtract_by_mass(Vec3Column& v, const Bodies& bodies, const Vec3<double>& u,
                      Workers& workers = Workers::serial()) {
  const double mass = total_mass(bodies);
  each_block(v.size(), block_of(v.size()), workers, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) v.add(i, -(bodies.m[i] / mass) * u);
  });
}

}  // namespace

double total_mass(const Bodies& bodies) {
  double sum = 0;
  for (const double m : bodies.m.values()) sum += m;
  return sum;
}

Vec3<double> total_momentum(const State& state) { return total(state.p); }

Vec3<double> centre_of_mass(const Vec3Column& q, const Bodies& bodies) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < q.size(); ++i) sum += bodies.m[i] * q[i];
  return sum / total_mass(bodies);
}

Vec3<double> remove_total_momentum(State& state, const Bodies& bodies) {
  const Vec3<double> momentum = total_momentum(state);
  subtract_by_mass(state.p, bodies, momentum);
  return momentum / total_mass(bodies);
}

void subtract_velocity(State& state, const Bodies& bodies, const Vec3<double>& u,
                       Workers& workers) {
  const auto subtract = [&](Component& p, double v, std::size_t first, std::size_t end) {
    double* const to = p.data();
    const double* const m = bodies.m.data();
    for (std::size_t i = first; i < end; ++i) to[i] -= m[i] * v;
  };
  each_block(state.size(), block_of(state.size()), workers,
             [&](std::size_t first, std::size_t end) {
               subtract(state.p.x, u.x, first, end);
               subtract(state.p.y, u.y, first, end);
               subtract(state.p.z, u.z, first, end);
             });
}

void remove_net_force(Load& load, const Bodies& bodies, Workers& workers) {
  subtract_by_mass(load.f, bodies, total(load.f, workers), workers);
}

}  // namespace polhode
