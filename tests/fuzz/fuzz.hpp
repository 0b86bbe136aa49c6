// SPDX-License-Identifier: MIT
// A fuzz target: one reader with arbitrary input. It must return, or throw an Error with a place,
// within the limits of memory and time set in driver.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace polhode::fuzz {

/// Passes a text to a reader; an Error is a valid outcome, any other exception is a bug.
void read(std::string_view text);

}  // namespace polhode::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
