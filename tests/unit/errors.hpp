// SPDX-License-Identifier: MIT
// Checks of the text and place of an error, and texts with a planted fault.
#pragma once

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

#include "polhode/base/error.hpp"

namespace polhode {

/// Checks that an expression throws an error with every one of `parts` in its text or place.
template <class Action>
void check_error(Action action, std::initializer_list<const char*> parts) {
  try {
    action();
    FAIL("no error");
  } catch (const Error& e) {
    const std::string whole = std::string(e.what()) + "\n  in   " + e.where();
    CAPTURE(whole);
    for (const char* part : parts) {
      CAPTURE(part);
      CHECK(whole.find(part) != std::string::npos);
    }
    for (const char* word : {"invalid", "illegal", "failed", "please"})
      CHECK(whole.find(word) == std::string::npos);
    const std::string text = e.what();
    CHECK(text.back() != '.');
    CHECK((text.front() < 'A' || text.front() > 'Z'));
  }
}

/// A text with the first occurrence of a word replaced; the word must occur.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

}  // namespace polhode
