// SPDX-License-Identifier: MIT
#include "../../src/io/formats/text_buffer.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

using namespace polhode;

TEST_CASE("numbers with fixed decimals are rounded as the standard library rounds them") {
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 0.5,
                                 1.5,
                                 -2.5,
                                 0.0005,
                                 -0.0005,
                                 1e-30,
                                 -1e-30,
                                 9999.9995,
                                 1e15,
                                 -1e300,
                                 0.1,
                                 900719.9254740992,
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> below(-12, 12);
  for (int k = 0; k < 5000; ++k) {
    numbers.push_back(below(random));
    numbers.push_back(std::ldexp(std::nearbyint(4096 * below(random)), -13));  // ties in base two
    numbers.push_back(std::nearbyint(1e5 * below(random)) / 1e5 + 0.5e-5);     // nearly ties
  }
  for (const double x : numbers)
    for (const int decimals : {0, 3, 5, 8, 10, 11}) {
      std::ostringstream text;
      TextBuffer(text).fixed(x, 15, decimals);
      const std::string expected = fmt::format("{:15.{}f}", x, decimals);
      if (text.str() != expected) CHECK(text.str() == expected);
    }
}
