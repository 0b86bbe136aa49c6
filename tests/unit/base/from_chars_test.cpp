// SPDX-License-Identifier: MIT
// The substitute for std::from_chars against the library's own.
#include "base/from_chars.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

using namespace polhode;

TEST_CASE("numbers are read as by std::from_chars") {
  for (const std::string text : {"1",
                                 "-2.5",
                                 "0.1",
                                 ".5",
                                 "5.",
                                 "1e3",
                                 "1E-3 ",
                                 "12abc",
                                 "+1",
                                 " 1",
                                 "",
                                 "-",
                                 ".",
                                 "e5",
                                 "1e",
                                 "1e+",
                                 "0x10",
                                 "-0x1p3",
                                 "1,5",
                                 "inf",
                                 "-inf",
                                 "nan",
                                 "infinity",
                                 "1e400",
                                 "-1e400",
                                 "--1",
                                 "-+1",
                                 "0.30000000000000004",
                                 "9007199254740993",
                                 "1.7976931348623157e308",
                                 "4.9406564584124654e-324",
                                 "- 1",
                                 "i",
                                 "n1"}) {
    CAPTURE(text);
    const char* const last = text.data() + text.size();
    double expected = 7, found = 7;
    const auto theirs = std::from_chars(text.data(), last, expected);
    const auto ours = from_chars_by_strtod(text.data(), last, found);
    CHECK(ours.ec == theirs.ec);
    CHECK(ours.ptr == theirs.ptr);
    CHECK(std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected));
  }
}
