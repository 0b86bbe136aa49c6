// SPDX-License-Identifier: MIT
#include "io/files/with_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace polhode {

std::string with_error(double value, double error) {
  if (!std::isfinite(value) || !std::isfinite(error) || !(error > 1e-12 * std::abs(value)))
    return fmt::format("{:.6g}", value);
  // The decimal exponent of the error after rounding: with two digits, 0.0996 is printed as 0.10.
  const int exponent = std::stoi(fmt::format("{:.1e}", error).substr(4));
  const int decimals = 1 - exponent;
  const double size = std::max(std::abs(value), error);
  constexpr double small = 1e-3, large = 1e7;
  if ((decimals > 6 && size < small) || size >= large) {  // factor out a power of ten
    const int power = static_cast<int>(std::floor(std::log10(size)));
    const double unit = std::pow(10.0, power);
    const int digits = std::clamp(power + decimals, 1, 15);
    return fmt::format("({:.{}f} ± {:.{}f})e{:+03}", value / unit, digits, error / unit, digits,
                       power);
  }
  if (decimals >= 0) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  const double unit = std::pow(10.0, -decimals);
  return fmt::format("{:.0f} ± {:.0f}", std::round(value / unit) * unit,
                     std::round(error / unit) * unit);
}

}  // namespace polhode
