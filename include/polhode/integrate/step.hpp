// SPDX-License-Identifier: MIT
// Performs one step of a scheme on any object with drift(t) and kick(t), called its flows.
// This code is header-only, so that another engine can supply its own flows and use these schemes.
#pragma once

#include <cstdint>

#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// Identifies a stage of a step in a trajectory. The random numbers of a bath are a function of the
/// StageNumber, and do not depend on threads or on the step at which a run was suspended.
struct StageNumber {
  std::uint64_t step = 0;
  std::size_t stage = 0;
  friend constexpr bool operator==(const StageNumber&, const StageNumber&) = default;
};

/// Flows that every scheme needs: drift(t) and kick(t), with t in the unit of the step h.
template <class F>
concept Flows = requires(F& flows, double t) {
  {flows.drift(t)};
  {flows.kick(t)};
};

/// Flows for schemes with gradient kicks: kick(t, ξh², gradient).
template <class F>
concept OffersGradientKick = requires(F& flows, double t, Gradient gradient) {
  {flows.kick(t, t, gradient)};
};

/// Flows for schemes with a bath: bath(t, number), which changes only momenta.
template <class F>
concept OffersBath = requires(F& flows, double t, StageNumber at) {
  {flows.bath(t, at)};
};

/// @throws Error  if type F lacks a function for one of the scheme's stages
template <Flows F>
void check_flows(const Scheme& scheme) {
  if (!OffersGradientKick<F> &&
      (scheme.has(Gradient::exact) || scheme.has(Gradient::finite_difference)))
    throw Error(
        "the scheme has gradient kicks, but the class of the flows has none; define kick(t, xi_h2, "
        "gradient), or use a scheme without gradient kicks");
  if (!OffersBath<F> && scheme.has(Flow::bath))
    throw Error(
        "the scheme has a bath, but the class of the flows has none; define bath(t, number), or "
        "leave the stages O out of the scheme");
}

/// Performs one stage of a scheme.
/// @param h  full step h, not the fraction of the stage
template <Flows F>
void play(const Stage& stage, F& flows, double h, StageNumber at) {
  switch (stage.flow) {
    case Flow::drift:
      flows.drift(stage.fraction * h);
      break;
    case Flow::kick:
      if constexpr (OffersGradientKick<F>)
        if (stage.xi != 0) {
          flows.kick(stage.fraction * h, stage.xi * h * h, stage.gradient);
          break;
        }
      flows.kick(stage.fraction * h);
      break;
    case Flow::bath:
      if constexpr (OffersBath<F>) flows.bath(stage.fraction * h, at);
      break;
  }
}

/// Performs stages in their order.
/// @param at  number of the first stage
template <Flows F>
void play(std::span<const Stage> stages, F& flows, double h, StageNumber at) {
  for (const Stage& stage : stages) {
    play(stage, flows, h, at);
    ++at.stage;
  }
}

/// Performs one step e^{Lh} of a scheme [vanzon2008, Eq. 1]: flows.drift(t), flows.kick(t),
/// flows.kick(t, ξh², gradient) and flows.bath(t, number) in the order of its stages.
/// @param number  number of this step in the trajectory, which selects the random numbers of a bath
/// @throws Error  if type F lacks a function for one of the scheme's stages
template <Flows F>
void step(const Scheme& scheme, F& flows, double h, std::uint64_t number = 0) {
  check_flows<F>(scheme);
  play(scheme.stages(), flows, h, {number, 0});
}

}  // namespace polhode
