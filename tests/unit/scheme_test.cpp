// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "errors.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"

using namespace polhode;

// The numbers of the table in closed form; a double holds them to 2⁻⁵³ relative, and the closed
// form loses two units more.
TEST_CASE("coefficients equal their closed forms") {
  const double c = std::cbrt(2 * std::sqrt(326.0) + 36);
  CHECK(std::abs(eta - (0.5 - c / 12 + 1 / (6 * c))) < 2e-16);
  CHECK(std::abs(theta - 1 / (2 - std::cbrt(2.0))) < 5e-16);
  // HOA2's η minimises α² + β² (omelyan2003): the derivative 48 η³ − 72 η² + 38 η − 5 vanishes, to
  // rounding of its terms.
  CHECK(std::abs(((48 * eta - 72) * eta + 38) * eta - 5) < 5e-15);
}

TEST_CASE("every scheme of the table is a palindrome that makes one step") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    CHECK(scheme.palindromic());
    CHECK(scheme.consistent());
    CHECK(!scheme.source().empty());
  }
}

TEST_CASE("force evaluations per step follow from the stages") {
  static_assert(schemes[0].force_evaluations() == 1);
  static_assert(schemes[1].force_evaluations() == 1);
  static_assert(schemes[2].force_evaluations() == 2);
  static_assert(schemes[3].force_evaluations() == 2 && schemes[3].derivatives() == 1);
  static_assert(schemes[3].cost() == 2 + derivative_cost);
  static_assert(schemes[4].force_evaluations() == 3 && schemes[4].derivatives() == 0);
  static_assert(schemes[5].force_evaluations() == 3);
  CHECK(scheme_of("A(1) B(1)").force_evaluations() == 1);
  CHECK(scheme_of("B(1/4) B(1/4) A(1) B(1/2)").force_evaluations() == 1);
}

TEST_CASE("a scheme as text reads back to the same bits") {
  for (const Scheme& scheme : schemes) {
    const Scheme again = scheme_of(text_of(scheme));
    REQUIRE(again.stages().size() == scheme.stages().size());
    for (std::size_t i = 0; i < scheme.stages().size(); ++i)
      CHECK(again.stages()[i] == scheme.stages()[i]);
  }
  const Scheme gier4 = scheme_of(" B( 1/6)A(0.5) B(2/3,xi = 1/48)\tA(1/2) B(1 / 6) ");
  CHECK(gier4.stages()[2] == B(2.0 / 3, 1.0 / 48));
  CHECK(gier4.stages()[2].has(Gradient::exact));
  CHECK(gier4.derivatives() == 1);
  const Scheme by_difference = scheme_of("B(1/6) A(1/2) B(2/3, 1/48 , fd) A(1/2) B(1/6)");
  CHECK(by_difference.stages()[2] == B(2.0 / 3, 1.0 / 48, Gradient::finite_difference));
  CHECK(by_difference.force_evaluations() == 3);
}

TEST_CASE("scheme texts that cannot be read say where and what is expected") {
  check_error([] { scheme_of("giere4"); }, {"no scheme 'giere4'", "did you mean 'gier4'"});
  check_error([] { scheme_of("C(1)"); }, {"'C(1)' at character 1", "A(...) for a drift"});
  check_error([] { scheme_of("B(1/2) A(1"); }, {"the end at character 11", "')'"});
  check_error([] { scheme_of("B(1/0) A(1)"); }, {"a denominator other than 0"});
  check_error([] { scheme_of("B(x) A(1)"); }, {"'x) A(1)' at character 3", "a finite number"});
  check_error([] { scheme_of("A(1, 1/48) B(1)"); }, {"a drift has one argument"});
  check_error([] { scheme_of("B(1, 1/48, exact) A(1)"); }, {"'exact) A(1'", "'fd'"});
  check_error([] { scheme_of("B(1e999) A(1)"); }, {"a finite number"});
  check_error([] { scheme_of("B(1/2) A(1)"); }, {"kicks B to 0.5", "must sum to 1"});
  std::string longer;
  for (int i = 0; i < 70; ++i) longer += "A(1/70) ";
  check_error([&] { scheme_of(longer); }, {"more than 64 stages"});
}
