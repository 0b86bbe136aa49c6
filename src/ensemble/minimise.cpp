// SPDX-License-Identifier: MIT
#include "polhode/ensemble/minimise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/flows.hpp"

namespace polhode {
namespace {

// Parameters of FIRE [guenole2020, Table 1]; times are in ps.
constexpr double first_step = 0.001, min_step = 0.02 * first_step, max_step = 20 * first_step;
constexpr double growth = 1.1, shrinkage = 0.5;
constexpr double first_mixing = 0.25, mixing_decay = 0.99;
constexpr int delay = 20;  // number of downhill steps before the step grows

/// Scalar products of momenta and forces over all bodies, weighted with inverse masses and moments
/// of inertia.
struct Products {
  double power = 0;    ///< power Σ(f·p/m + τ·J⁻¹L)
  double momenta = 0;  ///< squared momenta Σ(p²/m + L·J⁻¹L)
  double forces = 0;   ///< squared forces Σ(f²/m + τ·J⁻¹τ)
};

Products products(const State& state, const Bodies& bodies, const Load& load) {
  Products sum;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> p = state.p[i], f = load.f[i];
    const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
    const Vec3<double> tau = to_body(state.orientation[i], load.tau[i]);
    const Vec3<double> omega = scaled(bodies.inverse_J[i], L);
    const double inverse_m = bodies.inverse_m[i];
    sum.power += inverse_m * dot(f, p) + dot(tau, omega);
    sum.momenta += inverse_m * norm2(p) + dot(L, omega);
    sum.forces += inverse_m * norm2(f) + dot(tau, scaled(bodies.inverse_J[i], tau));
  }
  return sum;
}

Steepness steepness(const Load& load) {
  double force2 = 0, torque2 = 0, sum = 0;
  for (std::size_t i = 0; i < load.f.size(); ++i) {
    const double f2 = norm2(load.f[i]), t2 = norm2(load.tau[i]);
    force2 = std::max(force2, f2);
    torque2 = std::max(torque2, t2);
    sum += f2 + t2;  // a sum shows NaNs, which a maximum would hide
  }
  if (!std::isfinite(sum) || !std::isfinite(load.potential()))
    throw RunError("the energy cannot be minimised: a force is not a finite number");
  return {load.potential(), std::sqrt(force2), std::sqrt(torque2)};
}

void scale_momenta(State& state, double factor) {
  scale(state.p, factor);
  scale(state.ell, factor);
}

/// The factor that reduces a momentum so that a body moves by at most `max_move` instead of
/// `distance`.
double share(double distance, double max_move) {
  return distance > max_move ? max_move / distance : 1;
}

class Fire {
 public:
  Fire(State& state, const Topology& topology, const Bodies& bodies, double max_move,
       Workers& workers)
      : state_(state), bodies_(bodies), max_move_(max_move), workers_(workers) {
    for (const auto& part : topology.parts) extents_.push_back(part.molecule.extent());
    scale_momenta(state_, 0);
  }

  /// Takes one step.
  /// @param load  load of the state
  void step(const Load& load) {
    adapt(products(state_, bodies_, load));
    kick(state_, bodies_, load, step_, workers_);
    const Products now = products(state_, bodies_, load);
    scale_momenta(state_, 1 - mixing_);
    if (now.forces > 0)
      kick(state_, bodies_, load, mixing_ * std::sqrt(now.momenta / now.forces), workers_);
    cap_moves();
    drift(state_, bodies_, step_, workers_);
  }

 private:
  void adapt(const Products& now) {
    if (now.power > 0) {
      if (++downhill_ <= delay) return;
      step_ = std::min(growth * step_, max_step);
      mixing_ *= mixing_decay;
    } else if (now.momenta > 0) {
      downhill_ = 0;
      step_ = std::max(shrinkage * step_, min_step);
      mixing_ = first_mixing;
      drift(state_, bodies_, -step_ / 2, workers_);
      scale_momenta(state_, 0);
    }
  }

  void cap_moves() {
    for (std::size_t i = 0; i < state_.size(); ++i) {
      const Vec3<double> p = state_.p[i], ell = state_.ell[i];
      const Vec3<double> omega = scaled(bodies_.inverse_J[i], to_body(state_.orientation[i], ell));
      const double moved = step_ * bodies_.inverse_m[i] * norm(p);
      const double turned = step_ * extents_[bodies_.part[i]] * norm(omega);
      state_.p.set(i, share(moved, max_move_) * p);
      state_.ell.set(i, share(turned, max_move_) * ell);
    }
  }

  State& state_;
  const Bodies& bodies_;
  double max_move_;
  Workers& workers_;
  std::vector<double> extents_;  // extent of the molecules of each part of the topology
  double step_ = first_step, mixing_ = first_mixing;
  int downhill_ = 0;  // number of steps since the power was last negative
};

}  // namespace

Minimisation minimise(State& state, const Topology& topology, const Bodies& bodies,
                      const EvaluateLoad& evaluate, const MinimisationSettings& settings,
                      const MinimisationWatch& watch, Workers& workers) {
  Fire fire(state, topology, bodies, settings.max_move, workers);
  Load load(state.size());
  Minimisation result;
  for (;; ++result.steps) {
    evaluate(state, load);
    result.after = steepness(load);
    if (result.steps == 0) result.before = result.after;
    if (result.after.force <= settings.force && result.after.torque <= settings.torque)
      result.end = MinimisationEnd::converged;
    else if (result.steps == settings.max_steps)
      result.end = MinimisationEnd::max_steps;
    else if (watch && watch(result.steps, result.after))
      result.end = MinimisationEnd::stopped;
    else {
      fire.step(load);
      continue;
    }
    scale_momenta(state, 0);
    return result;
  }
}

}  // namespace polhode
