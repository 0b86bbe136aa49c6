// SPDX-License-Identifier: MIT
// The bias of functions of averages, from samples of distributions whose shadow energy is known:
// compared with the exact bias, from both sides.
#include "polhode/measure/step_response.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "measure/dielectric.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/radial_distribution.hpp"

using namespace polhode;

namespace {

constexpr double T = 300, kT = units::boltzmann * T;
constexpr double a = 0.02;  // ω²h²/6 of all modes, with velocity Verlet
constexpr std::size_t modes = 40;

// Harmonic modes with the distribution exp(−H̃/kT), H̃ = K (1 + a) + V (1 − a/2), or on the surface
// of constant H̃. Each is correlated with the sample before.
class Modes {
 public:
  Modes(std::uint64_t seed, double memory) : random_(seed), memory_(memory) {
    for (auto* x : {&p_, &q_})
      for (double& value : *x) value = random_.normal();
  }

  void next() {
    const double fresh = std::sqrt(1 - memory_ * memory_);
    for (auto* x : {&p_, &q_})
      for (double& value : *x) value = memory_ * value + fresh * random_.normal();
    kinetic_ = potential_ = 0;
    for (const double p : p_) kinetic_ += kT / 2 * p * p / (1 + a);
    for (const double q : q_) potential_ += kT / 2 * q * q / (1 - a / 2);
    scale_ = 1;
  }
  // Onto the surface on which H̃ has its mean.
  void keep_shadow_energy() { scale_ = modes * kT / (total() + error()); }

  double kinetic() const { return scale_ * kinetic_; }
  double total() const { return scale_ * (kinetic_ + potential_); }
  double error() const { return scale_ * a * (kinetic_ - potential_ / 2); }
  // In units of the rms displacement that exact dynamics has at T.
  double displacement(std::size_t mode) const { return std::sqrt(scale_ / (1 - a / 2)) * q_[mode]; }
  StepError step_error(FixedMeans fixed) const {
    return {fixed == FixedMeans::energy ? -total() : error(), total(), kinetic(), 0, 1};
  }

 private:
  Random random_;
  double memory_;
  std::array<double, modes> p_{}, q_{};
  double kinetic_ = 0, potential_ = 0, scale_ = 1;
};

void next(Modes& m, FixedMeans fixed) {
  m.next();
  if (fixed == FixedMeans::energy) m.keep_shadow_energy();
}

// What the step changes in ⟨q²⟩, relative: it is larger by a/2 at one temperature, which is higher
// by a with the kinetic energy fixed, and by a/4 with the energy fixed.
double widening(FixedMeans fixed) {
  return fixed == FixedMeans::energy ? a / 2 + a / 4 : a / 2 + a;
}

// Beyond 4.5 standard errors, the next order, and at constant energy the difference from constant
// temperature, of order 1 over the number of modes.
void check(const SeriesEstimate& found, double expected) {
  CAPTURE(found.value);
  CAPTURE(found.error);
  CAPTURE(expected);
  REQUIRE(found.known == Known::yes);
  CHECK(found.error < 0.15 * std::abs(expected));
  CHECK(std::abs(found.value - expected) <
        4.5 * found.error + (2 * a + 2.0 / modes) * std::abs(expected));
}

}  // namespace

TEST_CASE("step response: a fluctuation formula and a ratio of averages") {
  for (const FixedMeans fixed : {FixedMeans::energy, FixedMeans::kinetic_energy}) {
    CAPTURE(static_cast<int>(fixed));
    StepResponse response;
    Modes m(21, 0);
    for (int n = 0; n < 60'000; ++n) {
      next(m, fixed);
      double x2 = 0, x4 = 0, x = 0;
      for (std::size_t k = 0; k < modes; ++k) {
        const double q = m.displacement(k) + 5;  // ⟨q⟩² is much larger than the fluctuation
        x += q / modes, x2 += q * q / modes, x4 += std::pow(m.displacement(k), 4) / modes;
      }
      response.add(m.step_error(fixed), std::array{x, x2, x4});
    }
    CHECK(response.samples() == 60'000);
    using Means = std::span<const double>;
    const auto bias = [&](const StepResponse::Function& f) {
      return response.bias(modes, fixed, f);
    };
    const auto variance = [](Means mean) { return mean[1] - mean[0] * mean[0]; };
    check(bias(variance), widening(fixed));
    // 3 ⟨q²⟩²/⟨q²⟩
    check(bias([&](Means mean) { return mean[2] / variance(mean); }), 3 * widening(fixed));
  }
}

// A molecule that librates about one axis, with an angle θ of the variance s: ⟨M²⟩ − ⟨M⟩² is
// μ² (1 − exp(−s)).
TEST_CASE("step response: the dielectric constant of a librating molecule") {
  for (const FixedMeans fixed : {FixedMeans::energy, FixedMeans::kinetic_energy}) {
    CAPTURE(static_cast<int>(fixed));
    const Topology topology{{{read_molecule("spce"), 1}}};
    TotalDipole dipole(topology);
    Modes m(22, 0);
    constexpr double spread = 0.4;  // rms angle of exact dynamics
    State state(1, {{3, 3, 3}});
    for (int n = 0; n < 200'000; ++n) {
      next(m, fixed);
      const double half = spread * m.displacement(0) / 2;
      // About the first principal axis, from one hydrogen to the other: the dipole is the second.
      state.orientation.set(0, {std::cos(half), std::sin(half), 0, 0});
      dipole.add(state, m.step_error(fixed));
    }
    const double s = spread * spread;
    const auto with_given = dipole.step_bias(T, tin_foil, modes, fixed);
    const TotalDipole::Result result = dipole.result(T, tin_foil);
    const double relative = widening(fixed) * s * std::exp(-s) / (1 - std::exp(-s));
    check(with_given.kirkwood, result.kirkwood.value * relative);
    check(with_given.constant, (result.constant.value - 1) * relative);
    // With the temperature that is read: too low by a, and with the energy fixed higher by a/4;
    // with the kinetic energy fixed it has no bias.
    const double colder = fixed == FixedMeans::energy ? a - a / 4 : 0;
    check(dipole.step_bias(std::nullopt, tin_foil, modes, fixed).constant,
          (result.constant.value - 1) * (relative + colder));
  }
}

// Pairs of atoms whose distance is that of a mode: g(r) has a peak as high as 1 over the rms
// displacement, and as wide.
TEST_CASE("step response: the first peak of g(r) of oscillating pairs") {
  for (const FixedMeans fixed : {FixedMeans::energy, FixedMeans::kinetic_energy}) {
    CAPTURE(static_cast<int>(fixed));
    constexpr std::size_t pairs = 27;
    const Topology topology{{{read_molecule("argon"), 2 * pairs}}};
    RadialDistribution g(topology, {{{"Ar", "Ar"}}, 0.6, 0.004});
    Modes m(23, 0);
    State state(2 * pairs, {{6, 6, 6}});
    for (std::size_t k = 0; k < pairs; ++k) {
      state.orientation.set(2 * k, {1, 0, 0, 0}), state.orientation.set(2 * k + 1, {1, 0, 0, 0});
      state.q.set(2 * k, {2.0 * static_cast<double>(k % 3), 2.0 * static_cast<double>(k / 3 % 3),
                          2.0 * static_cast<double>(k / 9)});
    }
    for (int n = 0; n < 20'000; ++n) {
      next(m, fixed);
      for (std::size_t k = 0; k < pairs; ++k)
        state.q.set(2 * k + 1, state.q[2 * k] + Vec3<double>{0.5 + 0.02 * m.displacement(k), 0, 0});
      g.add(state, Workers::serial(), m.step_error(fixed));
    }
    const double height = g.first_peak(0).value().height.value;
    check(g.first_peak_bias(0, modes, fixed).value().height, -height * widening(fixed) / 2);
  }
}

// With 20 to 39 blocks of correlated samples the squares of deviations from the mean, in standard
// errors, are a little above 1 on average; the mean of 120 scatters by √(2/120), times 1.3 for
// their own errors. Both bounds are 4.7 times that from 1.1: errors 1.3 times too small, or 1.8
// times too large.
TEST_CASE("step response: errors are the scatter of independent series") {
  constexpr std::size_t series = 120;
  const FixedMeans fixed = FixedMeans::kinetic_energy;
  std::vector<SeriesEstimate> found;
  double mean = 0, squares = 0;
  for (std::size_t k = 0; k < series; ++k) {
    StepResponse response;
    Modes m(100 + k, 0.9);
    for (int n = 0; n < 2'000; ++n) {
      next(m, fixed);
      double x2 = 0;
      for (std::size_t i = 0; i < modes; ++i) x2 += std::pow(m.displacement(i), 2) / modes;
      response.add(m.step_error(fixed), std::array{x2});
    }
    found.push_back(response.bias(modes, fixed, [](auto means) { return means[0]; }));
    REQUIRE(found.back().known == Known::yes);
    mean += found.back().value / series;
  }
  for (const SeriesEstimate& f : found) squares += std::pow((f.value - mean) / f.error, 2);
  CAPTURE(squares / (series - 1));
  CHECK(squares / (series - 1) < 1.9);
  CHECK(squares / (series - 1) > 0.3);
}
