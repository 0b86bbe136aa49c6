// SPDX-License-Identifier: MIT
#include "measure/finite_size.hpp"

#include <cmath>
#include <functional>

#include "polhode/base/units.hpp"

namespace polhode {
namespace {

/// Calls a function for all points of a rectangular lattice within a distance of the origin, except
/// for the origin.
void each_point(const Vec3<double>& edge, double distance,
                const std::function<void(const Vec3<double>&)>& f) {
  const auto last = [&](double e) { return static_cast<int>(distance / e); };
  const int nx = last(edge.x), ny = last(edge.y), nz = last(edge.z);
  for (int x = -nx; x <= nx; ++x)
    for (int y = -ny; y <= ny; ++y)
      for (int z = -nz; z <= nz; ++z) {
        const Vec3<double> r{x * edge.x, y * edge.y, z * edge.z};
        if (const double r2 = norm2(r); r2 > 0 && r2 <= distance * distance) f(r);
      }
}

}  // namespace

// With 1/k² = ∫ exp(−k² t) dt and 1/k⁴ = ∫ t exp(−k² t) dt, the tensor (1/k²)(1 − k_a²/k²) is an
// integral over t of heat kernels. At large t, a sum over wave vectors converges fast. At small t,
// the integrand is the sum over images of (1/2 + x²/4t) (4πt)^(−3/2) exp(−R²/4t), minus its mean.
// The Oseen tensor is the integral over the image at the origin.
Vec3<double> image_mobility(const Vec3<double>& edge) {
  constexpr double pi = units::pi, decay = 6.5;  // exp(−6.5²) = 5e-19
  const double volume = edge.x * edge.y * edge.z;
  const double tau = std::cbrt(volume * volume) / (4 * pi), width = 2 * std::sqrt(tau);
  Vec3<double> sum{};
  each_point({2 * pi / edge.x, 2 * pi / edge.y, 2 * pi / edge.z}, 2 * decay / width,
             [&](const Vec3<double>& k) {
               const double k2 = norm2(k), share = std::exp(-k2 * tau) / (k2 * volume);
               for (std::size_t a = 0; a < 3; ++a)
                 sum[a] += share * (1 - k[a] * k[a] * (tau + 1 / k2));
             });
  each_point(edge, decay * width, [&](const Vec3<double>& r) {
    const double R = norm(r), u = R / width, tail = std::erfc(u) / (8 * pi * R);
    const double along =
        tail + u * std::exp(-u * u) / (4 * std::pow(pi, 1.5) * R);  // of 4 ∫ u² exp(−u²) du
    for (std::size_t a = 0; a < 3; ++a) sum[a] += tail + along * r[a] * r[a] / (R * R);
  });
  const double same = tau / volume + 1 / (std::pow(4 * pi, 1.5) * std::sqrt(tau));
  return {same - sum.x, same - sum.y, same - sum.z};
}

Vec3<double> finite_size_correction(double temperature, double viscosity,
                                    const Vec3<double>& edge) {
  return units::boltzmann * temperature / viscosity * image_mobility(edge);
}

}  // namespace polhode
