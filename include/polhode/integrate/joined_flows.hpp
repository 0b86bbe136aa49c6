// SPDX-License-Identifier: MIT
// A layer between a scheme and its flows, which joins adjacent stages of the same flow within a
// step and between steps.
#pragma once

#include <optional>

#include "polhode/integrate/step.hpp"

namespace polhode {

/// Delays each drift or kick until a different flow follows. For example, the last kick of a step
/// and the first kick of the next step are joined: e^{Bs} e^{Bt} = e^{B(s + t)}. Only flush()
/// synchronizes the state.
template <Flows F>
class JoinedFlows {
 public:
  /// @param flows        kept by reference
  /// @param join_drifts  false for drifts whose result depends on how the time is divided, such as
  ///   steps of an inner scheme
  explicit JoinedFlows(F& flows, bool join_drifts = true)
      : flows_(flows), join_drifts_(join_drifts) {}

  void drift(double t) {
    hold(A(t));
    if (!join_drifts_) flush();
  }
  void kick(double t) { hold(B(t)); }
  void kick(double t, double xi_h2, Gradient gradient) requires OffersGradientKick<F> {
    hold(B(t, xi_h2, gradient));
  }
  void bath(double t, StageNumber at) requires OffersBath<F> {
    flush();
    flows_.bath(t, at);
  }

  /// Applies the stage that is being delayed.
  void flush() {
    if (held_) play(*held_, flows_, 1, {});
    held_.reset();
  }

 private:
  void hold(const Stage& stage) {
    if (held_ && held_->joins(stage)) {
      held_->fraction += stage.fraction;
      return;
    }
    flush();
    held_ = stage;
  }

  F& flows_;
  bool join_drifts_;
  std::optional<Stage> held_;  // Delayed stage. With h = 1, its fraction is a time, and its ξ is ξ
                               // h².
};

}  // namespace polhode
