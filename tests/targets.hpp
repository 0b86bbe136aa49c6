// SPDX-License-Identifier: MIT
// Tests that run on every instruction set of this processor.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "polhode/base/target.hpp"

namespace polhode {

/// Calls f once for each instruction set, with that set in use.
template <class Function>
void for_each_target(const Function& f) {
  const Target before = current_target();
  for (const Target target : available_targets()) {
    force_target(target);
    INFO("target " << std::string(name(target)));
    f();
  }
  force_target(before);
}

}  // namespace polhode
