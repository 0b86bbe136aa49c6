// SPDX-License-Identifier: MIT
// A line in the log where Lennard-Jones parameters are not mixed as usual.
#pragma once

#include <fmt/core.h>

#include <string>

#include "polhode/forces/settings.hpp"

namespace polhode::cli {

/// On standard error: the mixing rule and the pairs that are given, unless the usual rule holds for
/// all.
inline void note_mixing(const ForceSettings& forces) {
  if (const std::string mixing = described(forces.mixing); !mixing.empty())
    fmt::print(stderr, "Lennard-Jones: {}\n", mixing);
}

}  // namespace polhode::cli
