// SPDX-License-Identifier: MIT
#include "estimate_text.hpp"

#include <fmt/core.h>

#include "polhode/io/with_error.hpp"

namespace polhode::cli {

std::string not_known(std::uint64_t samples) {
  return fmt::format("not known from {} samples", samples);
}

std::string missing_error(Known known, std::uint64_t samples) {
  switch (known) {
    case Known::yes:
      return "";
    case Known::too_few_samples:
      return fmt::format(", its error is {}", not_known(samples));
    case Known::too_short:
      return ", the run is too short to estimate its error";
    case Known::not_defined:
      return ", its error is not defined";
    case Known::grows:
      return ", which grows with the length of the run";
  }
  return "";
}

std::string kelvin(const SeriesEstimate& e) {
  return e.known == Known::yes ? with_error(e.value, e.error) : fmt::format("{:.2f}", e.value);
}

std::string estimate_text(const Estimate& e, Known known, std::uint64_t samples, int digits,
                          const char* unit) {
  const std::string of_unit = *unit ? std::string(" ") + unit : "";
  if (known == Known::yes) return with_error(e.value, e.error) + of_unit;
  return fmt::format("{:.{}g}{}{}", e.value, digits, of_unit, missing_error(known, samples));
}

}  // namespace polhode::cli
