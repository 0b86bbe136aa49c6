// SPDX-License-Identifier: MIT
// Displacements, reorientation, velocities and dipoles of motions with known correlations.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "io/settings/quantity.hpp"
#include "measure/dielectric.hpp"
#include "measure/displacement.hpp"
#include "measure/finite_size.hpp"
#include "measure/reorientation.hpp"
#include "measure/velocity_correlation.hpp"
#include "model/dipole.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

Topology of(const std::string& model, std::size_t count) {
  return {{{read_molecule(model), count}}};
}

Vec3<double> normal3(Random& random, double width) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return width * Vec3<double>{x, y, z};
}

Vec3<double> into(const Box& box, const Vec3<double>& r) {
  return {r.x - box.edge.x * std::floor(r.x / box.edge.x),
          r.y - box.edge.y * std::floor(r.y / box.edge.y),
          r.z - box.edge.z * std::floor(r.z / box.edge.z)};
}

// The rotation about a vector by its length.
Quaternion<double> turn(const Vec3<double>& v) {
  const double half = norm(v) / 2;
  if (half == 0) return {};
  const Vec3<double> axis = v / norm(v) * std::sin(half);
  return {std::cos(half), axis.x, axis.y, axis.z};
}

// A reported error has four to eight degrees of freedom: an estimate is within six errors of the
// exact value (Student's t with four: 0.4 % are not), and its error within a factor of three of the
// expected one, which is known roughly (0.1 % are not).
void check(const SeriesEstimate& found, double exact, double error) {
  REQUIRE(found.known == Known::yes);
  CAPTURE(found.value);
  CAPTURE(found.error);
  CAPTURE(exact);
  CHECK(std::abs(found.value - exact) < 6 * found.error);
  CHECK(found.error > error / 3);
  CHECK(found.error < error * 3);
}

}  // namespace

// Free flight across many periodic boundaries: ⟨|Δq|²⟩ = v² t² up to rounding, and the largest
// displacement is reported.
TEST_CASE("displacements of free flight are ballistic, across periodic boundaries") {
  const Topology topology = of("argon", 6);
  Displacement displacement(topology, 20);
  State state(6, Box{{1.0, 1.5, 2.0}});
  const Vec3<double> v{0.24, -0.3, 0.1};
  for (int frame = 0; frame < 60; ++frame) {
    for (std::size_t i = 0; i < 6; ++i) {  // half of them forward, half backward
      const double way = i % 2 == 0 ? frame : -frame;
      state.q.set(i, into(state.box, Vec3<double>{0.1 * static_cast<double>(i), 0, 0} + way * v));
    }
    displacement.add(state);
  }
  const std::vector<double> squared = displacement.mean_square(0).mean();
  for (std::size_t lag = 0; lag < 20; ++lag)
    CHECK(std::abs(squared[lag] - norm2(v) * static_cast<double>(lag * lag)) < 1e-11);
  CHECK(displacement.max_step() == doctest::Approx(0.24).epsilon(1e-12));
}

// Brownian steps of variance 2 D t along each axis. The slope through lags 1 to 10 of 400 frames of
// 64 bodies: about 400/10 independent stretches of each in three directions, each of which
// determines D to √2, so the error is about D √(2 · 10/(3 · 400 · 64)) = 1.6 %. Relative to the
// centre of mass independent walkers have 1 − 1/64 of their D.
TEST_CASE("the diffusion coefficient of a random walk") {
  const Topology topology = of("argon", 64);
  const double D = 2.5e-3, interval = 0.5;
  Displacement displacement(topology, 11);
  State state(64, Box{{2, 2, 2}});
  Random random(4);
  for (int frame = 0; frame < 400; ++frame) {
    for (std::size_t i = 0; i < 64; ++i)
      state.q.set(i, into(state.box, state.q[i] + normal3(random, std::sqrt(2 * D * interval))));
    displacement.add(state);
  }
  check(diffusion(displacement.mean_square(0), interval, {0.5, 5}), D * 63 / 64, 0.016 * D);
  CHECK(std::isnan(diffusion(displacement.mean_square(0), interval, {5, 9}).value));
}

// The same with steps of different variance along the axes: each axis is a third of the walks, so
// the error of its D is √3 times as large, 2.8 %.
TEST_CASE("the diffusion coefficients of a random walk along three axes") {
  const Topology topology = of("argon", 64);
  const Vec3<double> D{1e-3, 2e-3, 4e-3};
  const double interval = 0.5;
  Displacement displacement(topology, 11);
  State state(64, Box{{2, 1.5, 3}});
  Random random(5);
  for (int frame = 0; frame < 400; ++frame) {
    for (std::size_t i = 0; i < 64; ++i) {
      const Vec3<double> step = normal3(random, std::sqrt(2 * interval));
      const Vec3<double> scale{std::sqrt(D.x), std::sqrt(D.y), std::sqrt(D.z)};
      state.q.set(i, into(state.box, state.q[i] + scaled(scale, step)));
    }
    displacement.add(state);
  }
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const SeriesEstimate along =
        diffusion_along(displacement.mean_square_along(axis, 0), interval, {0.5, 5});
    check(along, D[axis] * 63 / 64, 0.028 * D[axis]);
    sum += along.value / 3;
  }
  CHECK(diffusion(displacement.mean_square(0), interval, {0.5, 5}).value ==
        doctest::Approx(sum).epsilon(1e-12));
}

// yeh2004, Eq. 12: 2.837297 k_B T/(6πηL). By hand, in SI: 1.380649e-23 · 298 · 2.837297 /
// (6π · 0.729e-3 · 2.4858e-9) = 3.4175e-10 m²/s = 3.4175e-4 nm²/ps.
TEST_CASE("Yeh-Hummer finite-size correction of the diffusion coefficient") {
  const double viscosity = quantity("0.729 mPa s", Dimension::viscosity, "viscosity");
  constexpr double L = 2.4858;
  CHECK(std::abs(finite_size_correction(298, viscosity, {L, L, L}).x / 3.4175e-4 - 1) <
        2e-5);  // the constant has five digits
}

// Uniform rotation about a lab axis perpendicular to body axis 1 and along axis 3: axis 1 rotates
// by ωt, P₁ = cos ωt and P₂ = (3 cos² ωt − 1)/2; axis 3 is fixed.
TEST_CASE("orientational correlations of a uniform rotation") {
  const Topology topology = of("tip4p", 3);
  Reorientation reorientation(topology, 30);
  State state(3, Box{{2, 2, 2}});
  const double angle = 0.13;
  for (int frame = 0; frame < 90; ++frame) {
    for (std::size_t i = 0; i < 3; ++i) state.orientation.set(i, turn({0, 0, angle * frame}));
    reorientation.add(state);
  }
  REQUIRE(reorientation.axes(0).size() == 4);
  CHECK(reorientation.axes(0).back().name == "dipole");
  for (std::size_t lag = 0; lag < 30; ++lag) {
    const double c = std::cos(angle * static_cast<double>(lag));
    const auto P = [&](std::size_t axis, int rank) {
      return reorientation.legendre(0, axis, rank).mean()[lag];
    };
    CHECK(P(0, 1) == doctest::Approx(c).epsilon(1e-12));
    CHECK(P(0, 2) == doctest::Approx((3 * c * c - 1) / 2).epsilon(1e-12));
    CHECK(P(2, 1) == doctest::Approx(1).epsilon(1e-12));
    CHECK(P(2, 2) == doctest::Approx(1).epsilon(1e-12));
  }
}

// Random rotations by vectors with components of variance s²: a step multiplies P_l by the mean
// character over 2l + 1, with ⟨cos kθ⟩ = (1 − k² s²) exp(−k² s²/2). So C is exponential from lag 0,
// and both times are −interval/ln of that factor (the trapezoidal rule adds interval²/12τ).
TEST_CASE("relaxation times of rotational diffusion") {
  const Topology topology = of("tip4p", 100);
  const double interval = 0.1, s2 = 0.03;
  Reorientation reorientation(topology, 121);
  State state(100, Box{{2, 2, 2}});
  Random random(9);
  for (std::size_t i = 0; i < 100; ++i) state.orientation.set(i, random.orientation());
  for (int frame = 0; frame < 3000; ++frame) {
    for (std::size_t i = 0; i < 100; ++i)
      state.orientation.set(
          i, normalized(turn(normal3(random, std::sqrt(s2))) * state.orientation[i]));
    reorientation.add(state);
  }
  const double cos1 = (1 - s2) * std::exp(-s2 / 2), cos2 = (1 - 4 * s2) * std::exp(-2 * s2);
  const double tau1 = -interval / std::log((1 + 2 * cos1) / 3);
  const double tau2 = -interval / std::log((1 + 2 * cos1 + 2 * cos2) / 5);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto one = relaxation_times(reorientation.legendre(0, axis, 1), interval);
    const auto two = relaxation_times(reorientation.legendre(0, axis, 2), interval);
    REQUIRE(one);
    REQUIRE(two);
    CHECK(one->from == doctest::Approx(tau1).epsilon(0.1));
    CHECK(one->to == doctest::Approx(3 * tau1).epsilon(0.2));
    // A run of length T determines C to about √(2τ/T) for each independent signal: three components
    // of 100 bodies, five for the second rank. The integral accumulates that error over about 2τ;
    // the fit is determined where C is about a quarter.
    const double noise1 = std::sqrt(2 * tau1 / 300 / 300), noise2 = std::sqrt(2 * tau2 / 300 / 500);
    check(one->exponential, tau1, 4 * noise1 * tau1);
    check(two->exponential, tau2, 4 * noise2 * tau2);
    check(one->integral, tau1, 2 * noise1 * tau1);
    check(two->integral, tau2, 2 * noise2 * tau2);
  }
  Reorientation brief(topology, 121);
  for (int frame = 0; frame < 5; ++frame) brief.add(state);
  CHECK(!relaxation_times(brief.legendre(0, 0, 1), interval));
}

// Velocities of an Ornstein-Uhlenbeck process: ⟨v(0) v(t)⟩ = (kT/m) e^{−t/τ} along each axis, D =
// kT τ/m, and for ω about each axis kT/J_k; relative to the centre of mass 63/64 of kT/m. D from
// 600/(2 · 0.2) stretches of 3 · 64 signals: slightly above 1 %.
TEST_CASE("velocities with an exponential autocorrelation") {
  const Topology topology = of("tip4p", 64);
  const Bodies bodies(topology);
  const double kT = 2.5, tau = 0.2, interval = 0.02, keep = std::exp(-interval / tau);
  VelocityCorrelation velocity(topology, 101);
  State state(64, Box{{2, 2, 2}});
  Random random(6);
  std::vector<Vec3<double>> L(64);
  for (int frame = -100; frame < 3000; ++frame) {
    for (std::size_t i = 0; i < 64; ++i) {
      const double width = std::sqrt(kT * (1 - keep * keep));
      state.p.set(i, keep * state.p[i] + normal3(random, width * std::sqrt(bodies.m[i])));
      const Vec3<double> J = bodies.J[i];
      L[i] = keep * L[i] +
             scaled(normal3(random, width), {std::sqrt(J.x), std::sqrt(J.y), std::sqrt(J.z)});
      state.orientation.set(i, random.orientation());
      state.ell.set(i, to_lab(state.orientation[i], L[i]));
    }
    if (frame >= 0) velocity.add(state);
  }
  const double v2 = kT / bodies.m[0] * 63 / 64, T = 60;
  const std::vector<SeriesEstimate> v = series_estimates(velocity.linear(0));
  // A mean square over T has T/τ independent values, each known to √2, of 3 · 64 signals.
  check(v[0], v2, v2 * std::sqrt(2 * tau / T / 192));
  CHECK(std::abs(v[10].value - v2 * std::exp(-1.0)) < 6 * v[10].error);
  const SeriesEstimate D = series_estimates(running_integral(velocity.linear(0), interval)).back();
  // The integral up to a lag of 2 ps = 10 τ is of the variance 2 (2 ps)/T of (D)² for each signal.
  check(D, v2 * tau, v2 * tau * std::sqrt(4 * 2.0 / T / 192));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double w2 = kT / bodies.J[0][axis];
    check(series_estimates(velocity.angular(0, axis))[0], w2, w2 * std::sqrt(2 * tau / T / 64));
  }
  // 4τ/(1 + (2πντ)²), widened by Hann's window of 2 ps: at ν = 0 by τ/(T) squared, 3 %.
  const Spectrum I = spectrum(velocity.linear(0), interval);
  CHECK(I.frequency[1] == doctest::Approx(0.25));
  CHECK(I.intensity[4].value ==
        doctest::Approx(4 * tau / (1 + std::pow(2 * units::pi * tau, 2))).epsilon(0.12));
  // The inverse transform at lag 0 is the trapezoidal rule over all frequencies: exactly 1.
  double integral = -(I.intensity.front().value + I.intensity.back().value) / 2 * 0.25;
  for (const SeriesEstimate& i : I.intensity) integral += i.value * 0.25;
  CHECK(integral == doctest::Approx(1).epsilon(1e-12));
  CHECK(velocity.turning_axes(0).size() == 3);
}

// Free rotation: ω is constant in the lab. Every frame has another rotation about the body's own
// axis, as fits to its atoms have.
TEST_CASE("the angular velocity of linear bodies needs no rotation about their own axis") {
  const Topology topology = of("co2", 8);
  const Bodies bodies(topology);
  VelocityCorrelation velocity(topology, 11);
  State state(8, Box{{3, 3, 3}});
  Random random(9);
  std::vector<Quaternion<double>> axes;
  for (std::size_t i = 0; i < 8; ++i) {
    axes.push_back(random.orientation());
    state.ell.set(i, to_lab(axes[i], Vec3<double>{0, random.normal(), random.normal()}));
  }
  for (int frame = 0; frame < 40; ++frame) {
    for (std::size_t i = 0; i < 8; ++i) {
      const double half = units::pi * random.uniform();
      state.orientation.set(i, axes[i] * Quaternion<double>{std::cos(half), std::sin(half), 0, 0});
    }
    velocity.add(state);
  }
  double square = 0;
  for (std::size_t i = 0; i < 8; ++i) square += norm2(state.ell[i]) / 8;
  CHECK(velocity.turning_axes(0).size() == 1);
  const std::vector<double> C = velocity.angular(0, 1).mean();
  for (const double c : C)
    CHECK(c == doctest::Approx(square * std::pow(bodies.inverse_J[0].y, 2) / 2).epsilon(1e-9));
}

// Dipoles that point up in half of the frames and down in the others: M² = (N μ)², ⟨M⟩ = 0, so the
// constants follow from their formulas without noise. Independent dipoles: Kirkwood factor 1.
TEST_CASE("the dielectric constant of known fluctuations") {
  const Topology topology = of("tip4p", 50);
  const double mu = topology.parts[0].molecule.dipole(), T = 298, edge = 2.0;
  const Vec3<double> body = dipole_moment(topology.parts[0].molecule);
  State state(50, Box{{edge, edge, edge}});
  TotalDipole flips(topology);
  for (int frame = 0; frame < 40; ++frame) {
    // The dipole of a water lies along a principal axis: a rotation by 180 degrees about another
    // one reverses it.
    const Vec3<double> across =
        std::abs(body.x) > mu / 2 ? Vec3<double>{0, units::pi, 0} : Vec3<double>{units::pi, 0, 0};
    for (std::size_t i = 0; i < 50; ++i)
      state.orientation.set(i, frame % 2 == 0 ? Quaternion<double>{} : turn(across));
    flips.add(state);
  }
  const double y = 4 * units::pi * units::coulomb * 2500 * mu * mu /
                   (3 * edge * edge * edge * units::boltzmann * T);
  CHECK(flips.result(T, tin_foil).constant.value == doctest::Approx(1 + y).epsilon(1e-10));
  CHECK(flips.result(T, tin_foil).kirkwood.value == doctest::Approx(50).epsilon(1e-10));
  CHECK(flips.result(T, tin_foil).mean_over_rms < 1e-10);
  // (ε − 1)(2ε' + 1)/(2ε' + ε) = y, inverted; a huge ε' means conducting boundary conditions.
  const double around = 3 * y, epsilon = flips.result(T, around).constant.value;
  CHECK((epsilon - 1) * (2 * around + 1) / (2 * around + epsilon) ==
        doctest::Approx(y).epsilon(1e-10));
  CHECK(flips.result(T, 1e12).constant.value == doctest::Approx(1 + y).epsilon(1e-6));

  TotalDipole free(topology);
  Random random(8);
  for (int frame = 0; frame < 4000; ++frame) {
    for (std::size_t i = 0; i < 50; ++i) state.orientation.set(i, random.orientation());
    free.add(state);
  }
  // M² of 4000 frames in three directions: 1 within √(2/12000).
  check(free.result(T, tin_foil).kirkwood, 1, std::sqrt(2.0 / 12000));
}
