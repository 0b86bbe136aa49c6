// SPDX-License-Identifier: MIT
// Tests that run on every instruction set of this processor.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "base/instruction_set.hpp"

namespace polhode {

/// Calls f once for each instruction set, with that set in use.
template <class Function>
void for_each_instruction_set(const Function& f) {
  const InstructionSet before = current_instruction_set();
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    force_instruction_set(instruction_set);
    INFO("target " << std::string(name(instruction_set)));
    f();
  }
  force_instruction_set(before);
}

}  // namespace polhode
