// SPDX-License-Identifier: MIT
// Which schemes are symplectic: the Jacobian J of a step conserves the symplectic form, JᵀΩJ = Ω.
#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

// A tangent vector of a body's phase space: of centre, orientation (a lab-frame rotation), momentum
// and angular momentum.
struct Tangent {
  Vec3<double> q, theta, p, ell;
};

// The form Σ dq∧dp + θ∧dℓ − dℓ(θ, θ): of Θ = ℓ·θ with the rotations θ = dA A⁻¹ of orientations A,
// whose differential is dθ(a, b) = a × b, the form −dΘ is a_θ·b_ℓ − b_θ·a_ℓ − ℓ·(a_θ × b_θ).
double form(const State& at, const std::vector<Tangent>& a, const std::vector<Tangent>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += dot(a[i].q, b[i].p) - dot(b[i].q, a[i].p) + dot(a[i].theta, b[i].ell) -
           dot(b[i].theta, a[i].ell) - dot(at.ell[i], cross(a[i].theta, b[i].theta));
  return sum;
}

// Units in which all directions of a body are comparable: 0.01 nm, and the rotation and momenta of
// thermal motion over that distance.
constexpr double unit_q = 0.01, unit_theta = 0.1, unit_p = 7, unit_ell = 0.3;

Tangent unit(std::size_t direction) {
  Vec3<double> e{};
  e[direction % 3] = 1;
  switch (direction / 3) {
    case 0:
      return {.q = unit_q * e};
    case 1:
      return {.theta = unit_theta * e};
    case 2:
      return {.p = unit_p * e};
    default:
      return {.ell = unit_ell * e};
  }
}

State moved(State state, std::size_t body, std::size_t direction, double t) {
  const Tangent by = unit(direction);
  const Quaternion<double> a = state.orientation[body];
  state.q.add(body, t * by.q);
  state.orientation.set(body, a * rodrigues(to_body(a, t * by.theta)));
  state.p.add(body, t * by.p);
  state.ell.add(body, t * by.ell);
  return state;
}

// From one state to a neighbouring one.
std::vector<Tangent> difference(const State& to, const State& from) {
  std::vector<Tangent> result;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Quaternion<double> turn = to.orientation[i] * conjugate(from.orientation[i]);
    const Vec3<double> half = (turn.w < 0 ? -1.0 : 1.0) * turn.vector();
    const double sine = norm(half);
    const double factor = sine > 0 ? 2 * std::asin(sine) / sine : 2;
    result.push_back(
        {to.q[i] - from.q[i], factor * half, to.p[i] - from.p[i], to.ell[i] - from.ell[i]});
  }
  return result;
}

// The largest change of the form by a step, over all pairs of directions, in units of motion: of
// derivatives by central differences of eighth order.
double largest_violation(const NestedScheme& scheme, double h, double lambda) {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 3}}, 0.3, 40, 7);
  ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
  std::optional<ForceField> near;
  if (scheme.inner)
    near.emplace(scene.topology, near_settings(scenes::no_truncation(), *scheme.inner),
                 scene.state.box);
  const auto step = [&](State state) {
    if (near) {
      NestedIntegrator(scheme, scene.bodies, forces, *near, lambda).advance(state, h);
    } else {
      Integrator(scheme.outer, scene.bodies, forces, lambda).advance(state, h);
    }
    return state;
  };
  const std::size_t n = scene.state.size();
  const State end = step(scene.state);
  constexpr double eps = 0.01;
  constexpr double weights[] = {4. / 5, -1. / 5, 4. / 105, -1. / 280};
  std::vector<std::vector<Tangent>> before, after;
  for (std::size_t body = 0; body < n; ++body)
    for (std::size_t direction = 0; direction < 12; ++direction) {
      std::vector<Tangent> column(n);
      column[body] = unit(direction);
      before.push_back(column);
      column.assign(n, {});
      for (int k = 1; k <= 4; ++k)
        for (const int sign : {1, -1}) {
          const auto to =
              difference(step(moved(scene.state, body, direction, sign * k * eps)), end);
          const double w = sign * weights[k - 1] / eps;
          for (std::size_t i = 0; i < n; ++i) {
            column[i].q += w * to[i].q, column[i].theta += w * to[i].theta;
            column[i].p += w * to[i].p, column[i].ell += w * to[i].ell;
          }
        }
      after.push_back(column);
    }
  double worst = 0;
  for (std::size_t a = 0; a < before.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      worst = std::max(
          worst, std::abs(form(end, after[a], after[b]) - form(scene.state, before[a], before[b])));
  return worst;
}

}  // namespace

// Kicks of a potential and the exact drift are symplectic, and so are exact gradient kicks: that of
// V − ξ h² W. In units of motion the form has entries q p = 0.07 and θ ℓ = 0.03. A step rounds
// places to 2⁻⁵³ of 1 nm, 1e-14 of a unit, and differences divide that by eps = 0.01: 1e-12 of a
// column, whose entries are a few units; about ten of them contribute to an entry of the form, 0.07
// each: 1e-12. Eighth differences err by eps⁸/630 = 2e-19 of a ninth derivative. Without any,
// finite differences with λ = 1 break the form by λ h⁵ times the sum of b ξ² over gradient kicks of
// weight b, which is 2e-8 here for GIER4.
TEST_CASE("plain schemes and exact gradients are symplectic, finite differences are not") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    const double violation = largest_violation(scheme, 0.008, 1);
    CAPTURE(violation);
    if (scheme.has(Gradient::finite_difference)) {
      double size = 0;
      for (const Stage& stage : scheme.stages()) size += stage.fraction * stage.xi * stage.xi;
      const double relative_to_gier4 = size / (2.0 / 3 / (48 * 48));
      CHECK(violation > 1e-9 * relative_to_gier4);
      CHECK(violation < 1e-7 * relative_to_gier4);
    } else {
      CHECK(violation < 3e-12);
    }
  }
}

// Steps under the near forces are symplectic, and so are kicks of slow ones and of their gradient,
// which is that of V_slow − ξ h² W_slow. Bounds as above.
TEST_CASE("nested schemes are symplectic with exact gradients") {
  for (const char* text :
       {"hoa2 / hoa2 x 2 within 0.2 to 0.4 nm", "gier4 / gier4 x 1 within 0.2 to 0.4 nm"}) {
    CAPTURE(std::string(text));
    const double violation = largest_violation(nested_scheme_of(text), 0.008, 1);
    CAPTURE(violation);
    CHECK(violation < 3e-12);
  }
  CHECK(largest_violation(nested_scheme_of("gier4-fd / gier4-fd x 1 within 0.2 to 0.4 nm"), 0.008,
                          1) > 1e-9);
}
