// SPDX-License-Identifier: MIT
// Times as options give them.
#pragma once

#include <fmt/core.h>

#include <string>

#include "polhode/base/error.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode::cli {

/// "2 fs" in ps.
/// @throws Error  if the unit is missing or the time is not positive
inline double positive_time(const std::string& text, const std::string& option) {
  const double t = quantity(text, Dimension::time, option);
  if (!(t > 0))
    throw Error(
        fmt::format("{} = \"{}\" must be longer than 0; write for example \"2 fs\"", option, text));
  return t;
}

}  // namespace polhode::cli
