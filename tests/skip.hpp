// SPDX-License-Identifier: MIT
// A test case without its prerequisites is skipped visibly: its program exits with 77, which ctest
// reports as "Skipped" instead of "Passed".
#pragma once

#include <doctest/doctest.h>

#include <string>

namespace polhode {

inline int skipped_cases = 0;

/// Records that the rest of the case is skipped; the case returns after it.
inline void skip(const std::string& why) {
  ++skipped_cases;
  MESSAGE("skipped: ", why);
}

/// The exit code of a test program: failures take precedence over skipped cases.
inline int exit_code(int failed) { return failed == 0 && skipped_cases > 0 ? 77 : failed; }

}  // namespace polhode
