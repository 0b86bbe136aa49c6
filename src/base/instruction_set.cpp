// SPDX-License-Identifier: MIT
#include "polhode/base/instruction_set.hpp"

#include <hwy/targets.h>

#include <atomic>
#include <cstdlib>
#include <string>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

InstructionSet initial_instruction_set() {
  const std::vector<InstructionSet> instruction_sets = available_instruction_sets();
  const char* requested = std::getenv("POLHODE_INSTRUCTION_SET");
  if (std::getenv("POLHODE_TARGET") != nullptr)
    throw Error(
        "the environment variable POLHODE_TARGET is called POLHODE_INSTRUCTION_SET since version "
        "0.2; set POLHODE_INSTRUCTION_SET");
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
  switch (instruction_set) {
    case InstructionSet::scalar:
      return "scalar";
    case InstructionSet::sse4:
      return "sse4";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "";
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> instruction_sets{InstructionSet::scalar};
#if defined(__x86_64__)
  [[maybe_unused]] const auto supported = hwy::SupportedTargets();
#if !defined(POLHODE_WITHOUT_SSE4)
  if (supported & HWY_SSE4) instruction_sets.push_back(InstructionSet::sse4);
#endif
#if !defined(POLHODE_WITHOUT_AVX2)
  if (supported & HWY_AVX2) instruction_sets.push_back(InstructionSet::avx2);
#endif
#if !defined(POLHODE_WITHOUT_AVX512)
  if (supported & HWY_AVX3) instruction_sets.push_back(InstructionSet::avx512);
#endif
#endif
  return instruction_sets;
}

InstructionSet current_instruction_set() { return current(); }

void force_instruction_set(InstructionSet instruction_set) { current() = instruction_set; }

}  // namespace polhode
