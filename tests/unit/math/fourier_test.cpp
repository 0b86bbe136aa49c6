// SPDX-License-Identifier: MIT
#include "math/fourier.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

// A transform and its inverse multiply by the length, up to rounding of about log₂ n additions.
TEST_CASE("a real transform and its inverse") {
  const RealTransform transform(97);
  CHECK(transform.size() == 98);  // 2 · 7 · 7
  Column<double> series(98), back(98);
  Column<std::complex<double>> modes(50);
  Random random(3);
  for (std::size_t k = 0; k < 98; ++k) series[k] = back[k] = random.normal();
  transform.forward(series, modes);
  double sum = 0;
  for (std::size_t k = 0; k < 98; ++k) sum += back[k];
  CHECK(modes[0].real() == doctest::Approx(sum).epsilon(1e-12));
  transform.backward(modes, series);
  for (std::size_t k = 0; k < 98; ++k) CHECK(std::abs(series[k] / 98 - back[k]) < 1e-13);
}

// ∫₀^T e^{−t/τ} cos(2πνt) dt = τ/(1 + (2πντ)²) for T ≫ τ; the trapezoidal rule errs by
// interval²/12 times the slope at 0, 1/τ: 8e-5 τ here.
TEST_CASE("the cosine transform of an exponential is a Lorentzian") {
  const double tau = 0.5, interval = 0.015;
  std::vector<double> C;
  for (int k = 0; k <= 1000; ++k) C.push_back(std::exp(-k * interval / tau));
  const std::vector<double> I = cosine_transform(C, interval);
  for (const std::size_t k : {0U, 1U, 10U, 40U}) {
    const double omega = 2 * units::pi * static_cast<double>(k) / (2 * 1000 * interval);
    const double exact = tau / (1 + omega * omega * tau * tau);
    CHECK(I[k] - exact == doctest::Approx(interval * interval / 12 / tau).epsilon(0.05));
  }
}
