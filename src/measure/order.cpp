// SPDX-License-Identifier: MIT
#include "measure/order.hpp"

#include <algorithm>
#include <cmath>

#include "math/dual.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
namespace {

// An external field on three unlike sites r_k of one body, V(x) = a x·Dx/2 + b (x·c)³/3 + g |x|⁴/4
// for each site.
Topology body() {
  return {{{rigid_molecule("top", {{.name = "1", .r = {0.10, 0.02, 0.00}, .mass = 3.0},
                                   {.name = "2", .r = {-0.05, 0.08, 0.03}, .mass = 2.0},
                                   {.name = "3", .r = {-0.01, -0.06, 0.07}, .mass = 1.5}}),
            1}}};
}

class Field {
 public:
  /// @param anharmonic  1 for the full field, 0 for a field without the terms of b and g
  Field(const Molecule& molecule, double anharmonic)
      : sites_(molecule.sites), cubic_(900 * anharmonic), quartic_(5000 * anharmonic) {}

  void operator()(const State& state, Load& load) const {
    const FieldValue<double> value = of(state.q[0], state.orientation[0]);
    load.van_der_waals = value.energy;
    load.coulomb = 0;
    load.f.set(0, value.f);
    load.tau.set(0, value.tau);
  }
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& derivative) const {
    const Quaternion<double> a = state.orientation[0];
    const Vec3<double> v = dtheta[0];
    const Quaternion<double> da = scaled(a * Quaternion<double>{0, v.x, v.y, v.z}, 0.5);
    const FieldValue<Dual<double>> value = of<Dual<double>>(
        dual(state.q[0], dq[0]), {{a.w, da.w}, {a.x, da.x}, {a.y, da.y}, {a.z, da.z}});
    derivative.f.set(0, slope(value.f));
    derivative.tau.set(0, slope(value.tau));
  }

 private:
  template <class Real>
  struct FieldValue {
    Vec3<Real> f{}, tau{};
    Real energy{};
  };
  template <class Real>
  FieldValue<Real> of(const Vec3<Real>& q, const Quaternion<Real>& orientation) const {
    const auto as_real = [](const Vec3<double>& v) { return Vec3<Real>{v.x, v.y, v.z}; };
    const Vec3<Real> stiffness = as_real(stiffness_), skew = as_real(skew_);
    FieldValue<Real> value;
    for (std::size_t k = 0; k < sites_.size(); ++k) {
      const Real weight = 1 + 0.3 * static_cast<double>(k);
      const Vec3<Real> arm = to_lab(orientation, as_real(sites_[k].r));
      const Vec3<Real> x = q + arm;
      const Real along = dot(x, skew), x2 = norm2(x);
      value.energy += weight * (dot(x, scaled(stiffness, x)) / 2.0 +
                                cubic_ * along * along * along / 3.0 + quartic_ * x2 * x2 / 4.0);
      const Vec3<Real> force =
          -weight * (scaled(stiffness, x) + (cubic_ * along * along) * skew + (quartic_ * x2) * x);
      value.f += force;
      value.tau += cross(arm, force);
    }
    return value;
  }
  std::vector<Site> sites_;
  Vec3<double> stiffness_{900, 1400, 600};  // stiffness [kJ/mol/nm²]
  Vec3<double> skew_{0.6, -0.5, 0.62};
  double cubic_, quartic_;  // coefficients [kJ/mol/nm³], [kJ/mol/nm⁴]
};

State start() {
  State state(1, Box{{100, 100, 100}});
  state.q.set(0, {0.05, -0.04, 0.06});
  state.p.set(0, {2.0, 1.0, -1.5});
  state.orientation.set(0, normalized(Quaternion<double>{0.8, 0.3, -0.4, 0.2}));
  state.ell.set(0, {0.12, -0.2, 0.16});
  return state;
}

/// The kinetic energy, including centre-of-mass motion, because the field is fixed in space.
double kinetic(const State& state, const Bodies& bodies, const Energies& e) {
  return e.kinetic() + norm2(total_momentum(state)) / (2 * total_mass(bodies));
}

/// Measures the energy error of an integrator.
/// @param integrator  Integrator or NestedIntegrator
template <class AnyIntegrator>
double energy_error(AnyIntegrator& integrator, const Bodies& bodies, double h, std::size_t steps) {
  State state = start();
  const auto energy = [&] {
    const Energies e = energies(state, bodies, integrator.load(state));
    return e.potential() + kinetic(state, bodies, e);
  };
  const double first = energy();
  const double scale = kinetic(state, bodies, energies(state, bodies, Load{}));
  double worst = 0;
  for (std::size_t n = 0; n < steps; ++n) {
    integrator.advance(state, h);
    const double e = energy();
    worst = std::max(worst, std::abs(e - first));
    if (!std::isfinite(e)) return INFINITY;
  }
  return worst / scale;
}

double energy_error(const NestedScheme& scheme, double lambda, double h, std::size_t steps) {
  const Topology topology = body();
  const Bodies bodies(topology);
  Field field(topology.parts[0].molecule, 1), near(topology.parts[0].molecule, 0);
  if (scheme.inner) {
    NestedIntegrator integrator(scheme, bodies, field, near, lambda);
    return energy_error(integrator, bodies, h, steps);
  }
  Integrator integrator(scheme.outer, bodies, field, lambda);
  return energy_error(integrator, bodies, h, steps);
}

}  // namespace

OrderMeasurement measure_order(const NestedScheme& scheme, double lambda) {
  // The runs last several periods [ps] and have large steps. Even at steps of 20 fs, schemes with
  // many stages reach their order.
  constexpr double length = 0.64;
  const double max_step = scheme.outer.force_evaluations() < 8 ? 0.02 : 0.04;
  // The round-off error. A finite-difference gradient with the displacement factor λ amplifies
  // round-off errors by 1/λ. Without finite differences, round-off errors of a few 2⁻⁵³ per step
  // add up as a random walk over hundreds to ten thousand steps.
  const double rounding = scheme.has(Gradient::finite_difference) ? 1e-15 / lambda : 4e-14;
  OrderMeasurement result;
  double before = 0;
  auto steps = static_cast<std::size_t>(std::llround(length / max_step));
  for (double h = max_step; h > length / 20000; h /= 2, steps *= 2) {
    const double error = energy_error(scheme, lambda, h, steps);
    result.points.push_back({h, error});
    const std::size_t n = result.points.size();
    if (n < 2) continue;
    if (error < 30 * rounding) break;
    before = result.order;
    result.order = std::log2(result.points[n - 2].error / error);
    result.uncertainty = std::abs(result.order - before);
  }
  return result;
}

}  // namespace polhode
