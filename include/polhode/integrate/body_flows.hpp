// SPDX-License-Identifier: MIT
// The reference integrator: drifts, kicks and gradient kicks of rigid bodies, computed for one body
// at a time as in the paper. Together with step(), these flows form a complete integrator for
// another engine, which supplies only the forces. Header-only.
#pragma once

#include <span>
#include <vector>

#include "polhode/integrate/rodrigues.hpp"
#include "polhode/integrate/step.hpp"
#include "polhode/rotor/free_rotation.hpp"

namespace polhode {

/// A single rigid body. Any consistent set of units works; polhode uses nm, ps and u.
struct RigidBody {
  double m = 1;             ///< mass [u]
  Vec3<double> J{1, 1, 1};  ///< principal moments of inertia [u nm²]; at most one moment is 0
  Vec3<double> q{}, p{};    ///< centre of mass [nm] and momentum [u nm/ps], lab frame
  Quaternion<double> orientation{};  ///< rotation from the body frame to the lab frame
  Vec3<double> ell{};                ///< angular momentum about the centre of mass [u nm²/ps], lab
                                     ///< frame

  /// Kinetic energy of translation and rotation [kJ/mol].
  double kinetic_energy() const {
    const Vec3<double> L = to_body(orientation, ell);
    return norm2(p) / (2 * m) + dot(L, over_J(L)) / 2;
  }
  /// The product J⁻¹ v for a body-frame vector v; its component is 0 along an axis with no moment
  /// of inertia.
  Vec3<double> over_J(const Vec3<double>& v) const {
    const auto over = [](double x, double moment) { return moment > 0 ? x / moment : 0; };
    return {over(v.x, J.x), over(v.y, J.y), over(v.z, J.z)};
  }
};

/// Force on a body [kJ/mol/nm] and torque about its centre of mass [kJ/mol], in the lab frame.
struct BodyLoad {
  Vec3<double> f{}, tau{};
};

/// Drifts and kicks for a few rigid bodies. A kick reuses the forces of the previous kick unless
/// the positions have changed.
/// @tparam Forces  callable as forces(std::span<const RigidBody>, std::span<BodyLoad>), which sets
///                 the force and torque of every body
template <class Forces>
class BodyFlows {
 public:
  /// @param bodies  kept by reference; only these flows may move the bodies
  /// @param lambda  displacement factor of gradient kicks [vanzon2008, Eq. 6]
  BodyFlows(std::span<RigidBody> bodies, Forces forces, double lambda = 1e-4)
      : bodies_(bodies),
        forces_(std::move(forces)),
        lambda_(lambda),
        load_(bodies.size()),
        displaced_load_(bodies.size()),
        displaced_(bodies.size()) {}

  /// The drift e^{At}: free flight and exact free rotation [vanzon2008, Eq. 2].
  void drift(double t) {
    for (RigidBody& b : bodies_) {
      b.q += (t / b.m) * b.p;
      const Vec3<double> L = to_body(b.orientation, b.ell);
      b.orientation = normalized(b.orientation * free_rotation(b.J, L, t).rotation);
    }
    current_ = false;
  }

  /// The kick e^{Bt}: forces and torques change momenta [vanzon2008, Eq. 3].
  void kick(double t) {
    if (!current_) {
      forces_(std::span<const RigidBody>(bodies_), std::span(load_));
      ++evaluations_;
    }
    current_ = true;
    kick(t, load_);
  }

  /// The gradient kick e^{B̂(ξ)t}, always by finite difference [vanzon2008, Eqs. 4 to 7].
  /// @param xi_h2  product ξ h²
  void kick(double t, double xi_h2, Gradient) {
    kick(t);
    const double c = 2 * xi_h2 * lambda_;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const RigidBody& b = displaced_[i] = bodies_[i];
      const Vec3<double> turn = c * b.over_J(to_body(b.orientation, load_[i].tau));
      displaced_[i].q += (c / b.m) * load_[i].f;
      displaced_[i].orientation = normalized(b.orientation * rodrigues(turn));
    }
    forces_(std::span<const RigidBody>(displaced_), std::span(displaced_load_));
    ++evaluations_;
    kick(t / lambda_, displaced_load_);
    kick(-t / lambda_, load_);
  }

  int evaluations() const { return evaluations_; }  ///< number of force evaluations so far

 private:
  void kick(double t, std::span<const BodyLoad> load) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i].p += t * load[i].f;
      bodies_[i].ell += t * load[i].tau;
    }
  }

  std::span<RigidBody> bodies_;
  Forces forces_;
  double lambda_;
  std::vector<BodyLoad> load_, displaced_load_;
  std::vector<RigidBody> displaced_;
  bool current_ = false;  // whether load_ belongs to the current positions
  int evaluations_ = 0;
};

}  // namespace polhode
