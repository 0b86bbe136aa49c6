// SPDX-License-Identifier: MIT
#include "polhode/base/target.hpp"

#include <hwy/targets.h>

#include <atomic>
#include <cstdlib>
#include <string>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

Target chosen() {
  const std::vector<Target> targets = available_targets();
  const char* wanted = std::getenv("POLHODE_TARGET");
  if (wanted == nullptr || *wanted == '\0') return targets.back();
  std::string list;
  for (const Target target : targets) {
    if (name(target) == std::string_view(wanted)) return target;
    list += std::string(list.empty() ? "" : ", ") + name(target);
  }
  throw Error("POLHODE_TARGET = '" + std::string(wanted) +
              "' is no instruction set of this program on this processor; choose one of: " + list);
}

std::atomic<Target>& current() {
  static std::atomic<Target> target{chosen()};
  return target;
}

}  // namespace

const char* name(Target target) {
  switch (target) {
    case Target::scalar:
      return "scalar";
    case Target::sse4:
      return "sse4";
    case Target::avx2:
      return "avx2";
    case Target::avx512:
      return "avx512";
  }
  return "";
}

std::vector<Target> available_targets() {
  std::vector<Target> targets{Target::scalar};
#if defined(__x86_64__)
  [[maybe_unused]] const auto supported = hwy::SupportedTargets();
#if !defined(POLHODE_WITHOUT_SSE4)
  if (supported & HWY_SSE4) targets.push_back(Target::sse4);
#endif
#if !defined(POLHODE_WITHOUT_AVX2)
  if (supported & HWY_AVX2) targets.push_back(Target::avx2);
#endif
#if !defined(POLHODE_WITHOUT_AVX512)
  if (supported & HWY_AVX3) targets.push_back(Target::avx512);
#endif
#endif
  return targets;
}

Target current_target() { return current(); }

void force_target(Target target) { current() = target; }

}  // namespace polhode
