// SPDX-License-Identifier: MIT
// A test case that lacks what it needs is skipped, and is seen to be: its program exits with 77,
// which ctest reports as "Skipped" and lists at the end, in place of "Passed".
#pragma once

#include <doctest/doctest.h>

#include <string>

namespace polhode {

inline int skipped_cases = 0;

/// Records that the rest of the case is not carried out; the case returns after it.
inline void skip(const std::string& why) {
  ++skipped_cases;
  MESSAGE("skipped: ", why);
}

/// The exit code of a test program: what is wrong comes before what is skipped.
inline int exit_code(int failed) { return failed == 0 && skipped_cases > 0 ? 77 : failed; }

}  // namespace polhode
