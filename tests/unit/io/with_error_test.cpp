// SPDX-License-Identifier: MIT
#include "io/files/with_error.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace polhode {

TEST_CASE("values have the decimals of their errors") {
  CHECK(with_error(0.988341, 0.00021) == "0.98834 ± 0.00021");
  CHECK(with_error(0.988341, 0.0996) == "0.99 ± 0.10");  // not 0.988 ± 0.100
  CHECK(with_error(-22.3456, 1.23) == "-22.3 ± 1.2");
  CHECK(with_error(0, 0.5) == "0.00 ± 0.50");
  CHECK(with_error(29859, 1234) == "29900 ± 1200");
  CHECK(with_error(123, 99.6) == "120 ± 100");
  CHECK(with_error(-34.68774276, 4e-8) == "-34.687742760 ± 0.000000040");
}

TEST_CASE("very small and very large values are written as powers of ten") {
  CHECK(with_error(-2.31e-7, 4.1e-8) == "(-2.31 ± 0.41)e-07");
  CHECK(with_error(1.2345e9, 1e7) == "(1.234 ± 0.010)e+09");
}

TEST_CASE("an error that is only rounding is not printed") {
  CHECK(with_error(0.98834, 0) == "0.98834");
  CHECK(with_error(0.98834, 1e-16) == "0.98834");
  CHECK(with_error(0.98834, std::nan("")) == "0.98834");
}

}  // namespace polhode
