// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"

using namespace polhode;

namespace {

constexpr Scheme scheme_of_name(std::string_view name) {
  for (const Scheme& scheme : schemes)
    if (scheme.name() == name) return scheme;
  throw "there is no such scheme";
}

// The largest energy error of B(b) A(1/2) B(1 − 2b) A(1/2) B(b) over oscillators q̈ = −q with steps
// up to 2, relative to kT: (m₁₂ + m₂₁)²/(2 (1 − m₁₁²)) of the matrix m of one step [blanes2014].
double worst_oscillator(double b) {
  double worst = 0;
  for (double h = 0.001; h < 2.0005; h += 0.001) {
    double q1 = 1, p1 = 0, q2 = 0, p2 = 1;  // columns
    const auto kick = [&](double t) { p1 -= t * h * q1, p2 -= t * h * q2; };
    const auto drift = [&](double t) { q1 += t * h * p1, q2 += t * h * p2; };
    kick(b), drift(0.5), kick(1 - 2 * b), drift(0.5), kick(b);
    worst = std::max(worst, (p1 + q2) * (p1 + q2) / (2 * (1 - q1 * q1)));
  }
  return worst;
}

}  // namespace

// The numbers of the table in closed form; a double holds them to 2⁻⁵³ relative, and the closed
// form loses two more units.
TEST_CASE("coefficients equal their closed forms") {
  const double c = std::cbrt(2 * std::sqrt(326.0) + 36);
  CHECK(std::abs(eta - (0.5 - c / 12 + 1 / (6 * c))) < 2e-16);
  CHECK(std::abs(theta - 1 / (2 - std::cbrt(2.0))) < 5e-16);
  CHECK(std::abs(suzuki - 1 / (4 - std::cbrt(4.0))) < 2e-16);
  CHECK(std::abs(inverse_root_3 - 1 / std::sqrt(3.0)) < 2e-16);
  // The maximum of the error is minimal where its inner maximum equals its value at the end of the
  // range; a change of 1e-6 in the kick changes both by a relative 1e-5.
  CHECK(worst_oscillator(oscillator_kick) < worst_oscillator(oscillator_kick - 1e-5));
  CHECK(worst_oscillator(oscillator_kick) < worst_oscillator(oscillator_kick + 1e-5));
  // HOA2's η minimizes α² + β² [omelyan2003]: the derivative 48 η³ − 72 η² + 38 η − 5 vanishes, to
  // rounding of its terms.
  CHECK(std::abs(((48 * eta - 72) * eta + 38) * eta - 5) < 5e-15);
}

TEST_CASE("every scheme of the table is a palindrome whose coefficients sum to one") {
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
  static_assert(scheme_of_name("bcss3").force_evaluations() == 3);
  static_assert(scheme_of_name("forest-ruth").force_evaluations() == 3);
  static_assert(scheme_of_name("pefrl").force_evaluations() == 4);
  static_assert(scheme_of_name("4mn5fv").force_evaluations() == 5);
  static_assert(scheme_of_name("srkn14-6").force_evaluations() == 14);
  static_assert(scheme_of_name("chin-4b").force_evaluations() == 2);
  static_assert(scheme_of_name("4mn3f1gp").force_evaluations() == 3);
  CHECK(scheme_of("A(1) B(1)").force_evaluations() == 1);
  CHECK(scheme_of("B(1/4) B(1/4) A(1) B(1/2)").force_evaluations() == 1);
}

TEST_CASE("gradient kicks per step follow from the stages") {
  CHECK(scheme_of("hoa2").gradient_kicks() == 0);
  CHECK(scheme_of("gier4").gradient_kicks() == 1);
  CHECK(scheme_of("chin-4b").gradient_kicks() == 2);
  CHECK(scheme_of("B(1/2, 1/48) A(1) B(1/2, 1/48)").gradient_kicks() == 1);
}

// α and β of the O(h²) error. Those of the family B(η) A(1/2) B(1 − 2η, ξ) A(1/2) B(η) are known in
// closed form (docs/theory.md, Eq. (6)); for every other scheme they vanish where the order is
// above 2, to the rounding of coefficients with 15 digits, of size 1 to 2 and cubed: 1e-14. And
// only there.
TEST_CASE("the error of second order follows from the stages") {
  for (const double eta : {0.1, 0.1931833275037836, 0.5})
    for (const double xi : {0.0, 0.02}) {
      const std::array stages{B(eta), A(0.5), B(1 - 2 * eta, xi), A(0.5), B(eta)};
      const ErrorTerms terms = error_terms(Scheme(stages, 2));
      CHECK(std::abs(terms.alpha - (6 * eta - 1) / 24) < 1e-16);
      CHECK(std::abs(terms.beta - (1 - 6 * eta + 6 * eta * eta) / 12 + (1 - 2 * eta) * xi) < 1e-16);
    }
  const ErrorTerms position_verlet = error_terms(schemes[0]);
  CHECK(position_verlet.alpha == doctest::Approx(-1.0 / 24));
  CHECK(position_verlet.beta == doctest::Approx(1.0 / 12));
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    const ErrorTerms terms = error_terms(scheme);
    const double size = std::hypot(terms.alpha, terms.beta);
    if (scheme.order() == 2)
      CHECK(size > 1e-4);
    else
      CHECK(size < 1e-14);
  }
}

// A bath is no part of the Hamiltonian, and forces stay valid across it.
TEST_CASE("baths change neither the cost of a scheme nor the errors of its drifts and kicks") {
  constexpr Scheme baoab("x", 2, {B(0.5), A(0.5), O(1)}, "");
  static_assert(baoab.force_evaluations() == 1 && baoab.cost() == 1 && baoab.consistent());
  static_assert(baoab.has(Flow::bath) && !schemes[1].has(Flow::bath));
  for (const char* text :
       {"B(1/2) A(1/2) O(1) A(1/2) B(1/2)", "O(1/2) B(1/2) A(1) B(1/2) O(1/2)"}) {
    const ErrorTerms terms = error_terms(scheme_of(text)), verlet = error_terms(schemes[1]);
    CHECK(std::abs(terms.alpha - verlet.alpha) < 1e-16);
    CHECK(std::abs(terms.beta - verlet.beta) < 1e-16);
  }
  CHECK(scheme_of("B(1/2) O(1/2) B(1/2) A(1) O(1/2)").force_evaluations() == 1);
  CHECK(scheme_of("O(1/2) A(1/2) B(1) A(1/2) O(1/2)").force_evaluations() == 1);
  CHECK((A(0.5).joins(A(1)) && !A(0.5).joins(B(0.5))));
  CHECK((B(0.5).joins(B(1)) && !B(0.5, 0.1).joins(B(0.5))));
  CHECK(!O(0.5).joins(O(0.5)));
  // Gradient kicks at the ends are one with those of the next step, unless a bath is between them.
  CHECK(scheme_of("B(1/2, 1/48) A(1) B(1/2, 1/48)").derivatives() == 1);
  CHECK(scheme_of("O(1) B(1/2, 1/48) A(1) B(1/2, 1/48)").derivatives() == 2);
  CHECK(scheme_of("B(1/2, 1/48) A(1) B(1/2, 1/24)").derivatives() == 2);
}

TEST_CASE("a stage may take the remainder of the others of its flow") {
  constexpr Scheme scheme("x", 2, {B(0.1), A(0.25), B(rest), A(rest)}, "");
  CHECK(scheme.stages().size() == 7);
  CHECK(scheme.stages()[2] == B(0.4));
  CHECK(scheme.stages()[3] == A(0.5));
}

TEST_CASE("a scheme written as text is read back bit for bit") {
  for (const Scheme& scheme : schemes) {
    const Scheme again = scheme_of(text_of(scheme));
    REQUIRE(again.stages().size() == scheme.stages().size());
    for (std::size_t i = 0; i < scheme.stages().size(); ++i)
      CHECK(again.stages()[i] == scheme.stages()[i]);
  }
  const Scheme bath = scheme_of("B(1/2) A(1/2) O ( 1 ) A(1/2) B(1/2)");
  CHECK(bath.stages()[2] == O(1));
  CHECK(text_of(bath) == "B(0.5) A(0.5) O(1) A(0.5) B(0.5)");
  const Scheme gier4 = scheme_of(" B( 1/6)A(0.5) B(2/3,xi = 1/48)\tA(1/2) B(1 / 6) ");
  CHECK(gier4.stages()[2] == B(2.0 / 3, 1.0 / 48));
  CHECK(gier4.stages()[2].has(Gradient::exact));
  CHECK(gier4.derivatives() == 1);
  const Scheme by_difference = scheme_of("B(1/6) A(1/2) B(2/3, 1/48 , fd) A(1/2) B(1/6)");
  CHECK(by_difference.stages()[2] == B(2.0 / 3, 1.0 / 48, Gradient::finite_difference));
  CHECK(by_difference.force_evaluations() == 3);
}

// Each expression and its value; double arithmetic in the same order, so equal to the bit.
TEST_CASE("coefficients of a scheme's text are expressions") {
  const auto value = [](const std::string& x) {
    return scheme_of("x = " + x + "; B(x) A(1) B(1 - x)").stages()[0].fraction;
  };
  CHECK(value("1/6") == 1.0 / 6);
  CHECK(value("1/sqrt(3)") == 1 / std::sqrt(3.0));
  CHECK(value("1/(2 - cbrt(2))") == doctest::Approx(theta).epsilon(1e-15));
  CHECK(value("1/(2 - 2^(1/3))") == doctest::Approx(theta).epsilon(1e-15));
  CHECK(value("1 - 2 - 3") == 1.0 - 2 - 3);  // from left to right
  CHECK(value("8/4/2") == 1);
  CHECK(value("2^3^2") == 512);  // from right to left
  CHECK(value("-2^2") == -4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("- -1.5e-1 + (2*3 - 4)*.5") == 0.15 + 1);
  CHECK(value("1; y = 2*x; z = x + y") == 1);

  const Scheme chin = scheme_of(
      "root = 1/sqrt(3); a = (1 - root)/2; A(a) B(1/2, (2 - 3*root)/24) A(root) B(1/2, xi = (2 - "
      "3*root)/24) A(a)");
  const Scheme table = scheme_of("chin-4b");
  REQUIRE(chin.stages().size() == table.stages().size());
  for (std::size_t i = 0; i < table.stages().size(); ++i) {
    CHECK(chin.stages()[i].fraction == doctest::Approx(table.stages()[i].fraction).epsilon(4e-16));
    CHECK(chin.stages()[i].xi == doctest::Approx(table.stages()[i].xi).epsilon(4e-15));
  }
  CHECK(scheme_of("xi = 1/48; B(1/6) A(1/2) B(2/3, xi) A(1/2) B(1/6)").stages()[2].xi == 1.0 / 48);
}

TEST_CASE("a scheme of one's own has a name, an order and free parameters") {
  const Scheme mine = scheme_of("mine: B(1/6) A(1/2) B(2/3) A(1/2) B(1/6)");
  CHECK(mine.name() == "mine");
  CHECK(mine.has_own_name());
  const Scheme copy = mine;
  CHECK(copy.name() == "mine");
  CHECK(text_of(mine) == text_of(scheme_of("B(1/6) A(1/2) B(2/3) A(1/2) B(1/6)")));
  CHECK(scheme_of(" My-scheme_1.2 :B(1) A(1)").name() == "My-scheme_1.2");
  // 2 where the error of order h² is known; a higher order is not determined
  CHECK(mine.order() == 2);
  CHECK(scheme_of("B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)").order() == 0);
  CHECK(scheme_of("A(1) B(1)").order() == 0);
  CHECK(scheme_of("B(0.16667) A(1/2) B(0.66666, 0.02083) A(1/2) B(0.16667)").order() == 0);

  const char* text = "free b = 0.2; c = 1 - 2*b; free x = 1/48; B(b) A(1/2) B(c, x) A(1/2) B(b)";
  const std::vector<FreeParameter> free = free_parameters(text);
  REQUIRE(free.size() == 2);
  CHECK(free[0].name == "b");
  CHECK(free[0].value == 0.2);
  CHECK(free[1].name == "x");
  CHECK(scheme_of(text).stages()[2] == B(0.6, 1.0 / 48));
  const std::vector<FreeParameter> other = {{"b", 0.125}};
  CHECK(scheme_of(text, other).stages()[2] == B(0.75, 1.0 / 48));
  CHECK(free_parameters("hoa2").empty());
}

TEST_CASE("incorrect definitions, names and expressions are refused with the place") {
  check_error([] { scheme_of("x = 1/6; B(y) A(1)"); },
              {"'y) A(1)' at character 12", "a name that is defined", "\"y = 1/6;\""});
  check_error([] { scheme_of("mine: B(1/3) A(1/2"); }, {"the end at character 19", "')'"});
  check_error([] { scheme_of("x = 1/0; B(x) A(1)"); }, {"'0; B(x) A(' at character 7"});
  check_error([] { scheme_of("B(sqrt(1 - 2)) A(1)"); },
              {"'1 - 2)) A(' at character 8", "a finite real result"});
  check_error([] { scheme_of("B(2^10000) A(1)"); }, {"at character 4", "a finite real result"});
  check_error([] { scheme_of("x = 1e308 + 1e308; B(1, 1/x) A(1)"); },
              {"at character 12", "a finite real result"});
  check_error([] { scheme_of("x = 1/6 B(x) A(1)"); }, {"'B(x) A(1)' at character 9", "';'"});
  check_error([] { scheme_of("x = 1; x = 2; B(x) A(1)"); }, {"'x = 2; B(x' at character 8"});
  check_error([] { scheme_of("free = 1; B(1) A(1)"); }, {"a new name of a constant"});
  check_error([] { scheme_of("sqrt = 1; B(1) A(1)"); }, {"a new name of a constant"});
  check_error([] { scheme_of("A = 1; B(1) A(1)"); }, {"'= 1; B(1) ' at character 3", "'('"});
  check_error([] { scheme_of("hoa2: B(1) A(1)"); }, {"'hoa2' is the name of a built-in scheme"});
  check_error([] { scheme_of("my scheme: B(1) A(1)"); }, {"'my scheme' must have 1 to 32 letters"});
  check_error([] { scheme_of(": B(1) A(1)"); }, {"scheme name ''"});
  check_error([] { scheme_of("mine: hoa2"); }, {"'hoa2' at character 7", "A(...) for a drift"});
  check_error([] { scheme_of("B(" + std::string(1000, '(')); }, {"at most 32 levels"});
  check_error([] { scheme_of("B(" + std::string(1000, '-') + "1) A(1)"); }, {"at most 32 levels"});
  check_error([] { scheme_of("B(" + std::string(5000, ' ')); },
              {"5002 characters", "the maximum is 4096"});
}

TEST_CASE("incorrect scheme texts are refused with the place and what is expected") {
  check_error([] { scheme_of("giere4"); }, {"no scheme 'giere4'", "did you mean 'gier4'"});
  check_error([] { scheme_of("C(1)"); },
              {"'C(1)' at character 1", "A(...) for a drift", "O(...) for a bath"});
  check_error([] { scheme_of("B(1/2) A(1"); }, {"the end at character 11", "')'"});
  check_error([] { scheme_of("B(1/0) A(1)"); }, {"a denominator other than 0"});
  check_error([] { scheme_of("B(x) A(1)"); }, {"'x) A(1)' at character 3", "a finite number"});
  check_error([] { scheme_of("A(1, 1/48) B(1)"); },
              {"', 1/48) B(' at", "a drift has one argument"});
  check_error([] { scheme_of("A(1) B(1) O(1 , 2)"); }, {"', 2)' at", "a bath has one argument"});
  check_error([] { scheme_of("B(1, 1/48, exact) A(1)"); }, {"'exact) A(1'", "'fd'"});
  check_error([] { scheme_of("B(1e999) A(1)"); }, {"a finite number"});
  check_error([] { scheme_of("B(1/2) A(1)"); }, {"kicks B to 0.5;", "must sum to 1"});
  check_error([] { scheme_of("B(1) A(1) O(1/2)"); }, {"baths O to 0.5;", "must sum to 1"});
  check_error([] { scheme_of("B(1) A(1) O(1) O(-1)"); }, {"baths O to 0;", "must sum to 1"});
  std::string longer;
  for (int i = 0; i < 70; ++i) longer += "A(1/70) ";
  check_error([&] { scheme_of(longer); }, {"more than 64 stages"});
}
