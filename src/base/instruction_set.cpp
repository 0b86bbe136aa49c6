// SPDX-License-Identifier: MIT
#include "base/instruction_set.hpp"

#include <hwy/targets.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <type_traits>

#include "polhode/base/error.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(
    struct Loops;)  // if a set is an alias, this is the same type as for the scalar set

namespace {

struct Target {
  const char* name;
  std::int64_t highway;  // bit of the instruction set in Highway
  bool compiled;
};
template <class Loops>
constexpr bool is_compiled = !std::is_same_v<Loops, loops_scalar::Loops>;

constexpr std::array targets{
    // instruction sets in the order of InstructionSet
    Target{"scalar", 0, true}, Target{"sse4", HWY_SSE4, is_compiled<loops_sse4::Loops>},
    Target{"avx2", HWY_AVX2, is_compiled<loops_avx2::Loops>},
    Target{"avx512", HWY_AVX3, is_compiled<loops_avx512::Loops>},
    Target{"neon", HWY_NEON, is_compiled<loops_neon::Loops>}};

InstructionSet initial_instruction_set() {
  const std::vector<InstructionSet> instruction_sets = available_instruction_sets();
  const char* requested = std::getenv("POLHODE_INSTRUCTION_SET");
  if (std::getenv("POLHODE_TARGET") != nullptr)
    throw Error(
        "the environment variable POLHODE_TARGET was renamed in version 0.2; set "
        "POLHODE_INSTRUCTION_SET instead");
  if (requested == nullptr || *requested == '\0') return instruction_sets.back();
  std::string list;
  for (const InstructionSet instruction_set : instruction_sets) {
    if (name(instruction_set) == std::string_view(requested)) return instruction_set;
    list += std::string(list.empty() ? "" : ", ") + name(instruction_set);
  }
  throw Error(
      "POLHODE_INSTRUCTION_SET = '" + std::string(requested) +
      "' is not an instruction set of this program on this processor; choose one of: " + list);
}

std::atomic<InstructionSet>& current() {
  static std::atomic<InstructionSet> instruction_set{initial_instruction_set()};
  return instruction_set;
}

}  // namespace

const char* name(InstructionSet instruction_set) {
  return targets[static_cast<std::size_t>(instruction_set)].name;
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> instruction_sets{InstructionSet::scalar};
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::size_t k = 1; k < targets.size(); ++k)
    if (targets[k].compiled && (supported & targets[k].highway) != 0)
      instruction_sets.push_back(static_cast<InstructionSet>(k));
  return instruction_sets;
}

InstructionSet current_instruction_set() { return current(); }

void force_instruction_set(InstructionSet instruction_set) { current() = instruction_set; }

}  // namespace polhode
