// SPDX-License-Identifier: MIT
#include "polhode/integrate/flows.hpp"

#include "base/blocks.hpp"
#include "base/instruction_set.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(void drift(State&, const Bodies&, double, std::size_t, std::size_t);
                      void kick(State&, const Bodies&, const Load&, double, std::size_t,
                                std::size_t);
                      void gradient_direction(const State&, const Bodies&, const Load&, Vec3Column&,
                                              Vec3Column&, std::size_t, std::size_t);
                      void displace(State&, const Bodies&, const Load&, double, std::size_t,
                                    std::size_t);)

namespace {

// Number of bodies per block, chosen so that a block takes about 2 µs with the widest packs.
constexpr std::size_t drift_block = 256, kick_block = 2048, displace_block = 1024;

}  // namespace

void drift(State& state, const Bodies& bodies, double t, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(drift);
  each_block(state.size(), drift_block, workers,
             [&](std::size_t first, std::size_t end) { loop(state, bodies, t, first, end); });
}

void kick(State& state, const Bodies& bodies, const Load& load, double t, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(kick);
  each_block(state.size(), kick_block, workers,
             [&](std::size_t first, std::size_t end) { loop(state, bodies, load, t, first, end); });
}

void gradient_direction(const State& state, const Bodies& bodies, const Load& load, Vec3Column& dq,
                        Vec3Column& dtheta, Workers& workers) {
  if (dq.size() != state.size()) dq = dtheta = Vec3Column(state.size());
  const auto loop = POLHODE_CURRENT_LOOPS(gradient_direction);
  each_block(state.size(), displace_block, workers, [&](std::size_t first, std::size_t end) {
    loop(state, bodies, load, dq, dtheta, first, end);
  });
}

void displace(State& state, const Bodies& bodies, const Load& load, double c, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(displace);
  each_block(state.size(), displace_block, workers,
             [&](std::size_t first, std::size_t end) { loop(state, bodies, load, c, first, end); });
}

}  // namespace polhode
