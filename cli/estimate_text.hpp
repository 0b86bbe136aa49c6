// SPDX-License-Identifier: MIT
// Estimates of a run as text.
#pragma once

#include <cstdint>
#include <string>

#include "polhode/math/fit.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode::cli {

/// "not known from 2 samples".
std::string not_known(std::uint64_t samples);

/// Why an error is missing; empty if it is not.
std::string missing_error(Known known, std::uint64_t samples);

/// A temperature with its error, if it is known; without the unit.
std::string kelvin(const SeriesEstimate& temperature);

/// A value with its error, or why it has none; both in the same unit, "" for a number.
std::string estimate_text(const Estimate& e, Known known, std::uint64_t samples, int digits,
                          const char* unit);

}  // namespace polhode::cli
