// SPDX-License-Identifier: MIT
#include "polhode/io/settings/nested_scheme_text.hpp"

#include <doctest/doctest.h>

#include "../errors.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "run/simulation/system/near_forces.hpp"

using namespace polhode;

TEST_CASE("a text is a scheme, or a scheme with an inner scheme") {
  const NestedScheme plain = nested_scheme_of("gier4");
  CHECK(!plain.inner);
  CHECK(name_of(plain) == "gier4");
  CHECK(plain.near_evaluations() == 0);
  CHECK(plain.order() == 4);

  const NestedScheme nested = nested_scheme_of("hoa2 / gier4 x 3 within 3.5 to 5 A");
  CHECK(nested.outer.name() == "hoa2");
  REQUIRE(nested.inner);
  CHECK(nested.inner->scheme.name() == "gier4");
  CHECK(nested.inner->steps == 3);
  CHECK(nested.inner->switch_from == doctest::Approx(0.35).epsilon(1e-15));
  CHECK(nested.inner->cutoff == doctest::Approx(0.5).epsilon(1e-15));
  CHECK(nested.order() == 2);
  CHECK(nested.near_evaluations() == 2 * 3 * 2);  // drifts, inner steps, evaluations of each
  CHECK(nested.near_derivatives() == 2 * 3);
  CHECK(name_of(nested) == "hoa2 / gier4 x 3 within 0.35 to 0.5 nm");

  CHECK(nested_scheme_of("hoa2/hoa2 x 1 within 0.5nm").inner->switch_from ==
        doctest::Approx(0.35).epsilon(1e-15));
  // A slash within brackets is a fraction; a displaced evaluation of the outer gradient is one
  // more.
  const NestedScheme text = nested_scheme_of(
      "B(1/6) A(1/2) B(2/3, 1/48, fd) A(1/2) B(1/6) / B(1/2) A(1) B(1/2) x 2 within 0.4 to 0.6 nm");
  CHECK(text.near_evaluations() == 2 * 2 + 1);
  CHECK(text.near_derivatives() == 0);
  const NestedScheme again = nested_scheme_of(text_of(text));
  CHECK(text_of(again) == text_of(text));
  CHECK(again.outer.stages()[2].xi == 1.0 / 48);
  // With the exact gradient, a derivative of both forces where they are known.
  const NestedScheme exact = nested_scheme_of("gier4 / gier4 x 2 within 0.5 nm");
  CHECK(exact.near_evaluations() == 2 * 2 * 2);
  CHECK(exact.near_derivatives() == 2 * 2 + 1);
  CHECK(exact.near_cost() == 8 + 5 * derivative_cost);
  // An inner scheme has no forces at outer kicks.
  CHECK(nested_scheme_of("hoa2 / position-verlet x 2 within 0.5 nm").near_evaluations() == 4 + 2);
}

TEST_CASE("own names and definitions may stand on both sides of the slash") {
  const char* text =
      "mine: x = 1/6; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x) / y = 1/2; B(y) A(1) B(y) x 2 within 0.4 "
      "to 0.6 nm";
  const NestedScheme nested = nested_scheme_of(text);
  CHECK(nested.outer.name() == "mine");
  CHECK(nested.inner->steps == 2);
  CHECK(label_of(text) == "mine / B(0.5) A(1) B(0.5) x 2 within 0.4 to 0.6 nm");
  CHECK(label_of("mine: B(1/2) A(1) B(1/2)") == "mine");
  CHECK(label_of(" B(1/2)  A(1) B(1/2)") == "B(1/2) A(1) B(1/2)");
  CHECK(label_of("b = 1/2; B(b) A(1) B(b)") == "B(0.5) A(1) B(0.5)");
  for (const char* t :
       {text, "mine: B(1/6) A(1/2) B(2/3) A(1/2) B(1/6)", "gier4", "b = 1/3; B(b) A(1) B(1 - b)"}) {
    const NestedScheme again = nested_scheme_of(named_text_of(nested_scheme_of(t)));
    CHECK(text_of(again) == text_of(nested_scheme_of(t)));
    CHECK(again.outer.name() == nested_scheme_of(t).outer.name());
  }
  check_error([] { nested_scheme_of(std::string(9000, ' ')); }, {"9000 characters"});
}

TEST_CASE("incorrect inner schemes are refused") {
  for (const char* text : {"hoa2 /", "hoa2 / hoa2", "hoa2 / hoa2 x 2", "hoa2 / hoa2 x 2 within",
                           "hoa2 / hoa2 within 0.5 nm", "hoa2 / hoa2 x 2 within 0.5"})
    check_error([&] { nested_scheme_of(text); },
                {"write for example \"hoa2 x 2 within 0.35 to 0.5 nm\""});
  check_error([] { nested_scheme_of("hoa2 / giere4 x 2 within 0.5 nm"); }, {"'gier4'"});
  check_error([] { nested_scheme_of("hoa3 / hoa2 x 2 within 0.5 nm"); }, {"'hoa2'"});
  for (const char* steps : {"0", "-1", "1.5", "1001", "two"})
    check_error([&] { nested_scheme_of(std::string("hoa2 / hoa2 x ") + steps + " within 0.5 nm"); },
                {steps, "from 1 to 1000"});
  check_error([] { nested_scheme_of("hoa2 / hoa2 x 2 within 0.5 fs"); }, {"0.5 fs", "length"});
  for (const char* reach : {"0.5 to 0.4 nm", "0 to 0.4 nm", "-0.1 to 0.4 nm", "-0.4 nm"})
    check_error([&] { nested_scheme_of(std::string("hoa2 / hoa2 x 2 within ") + reach); },
                {"the second must be longer", "0.35 to 0.5 nm"});
}

TEST_CASE("near forces must be part of all forces") {
  const InnerScheme inner = *nested_scheme_of("hoa2 / hoa2 x 2 within 0.35 to 0.5 nm").inner;
  ForceSettings whole;
  whole.truncation = Truncation::site_switch;
  whole.electrostatics = Electrostatics::pme;
  whole.precision = Precision::mixed;
  whole.dispersion_correction = true;
  const ForceSettings near = near_settings(whole, inner);
  CHECK(near.truncation == Truncation::molecule_switch);
  CHECK(near.electrostatics == Electrostatics::coulomb);
  CHECK(near.precision == Precision::mixed);
  CHECK(near.cutoff == 0.5);
  CHECK(near.switch_from == 0.35);
  CHECK(!near.dispersion_correction);
  whole.cutoff = 0.49;
  check_error([&] { near_settings(whole, inner); }, {"0.5 nm", "0.49 nm"});
}

// Two drifts of 1/2 with 2 steps of 1/4 each: 4 kicks of 1/4 by velocity Verlet, Σ w² = 1/4.
TEST_CASE("kicks of an inner scheme have the weights of the inner step") {
  const double outer = kick_weights(scheme_of("hoa2"), 1);
  CHECK(kick_weights(nested_scheme_of("hoa2 / velocity-verlet x 2 within 0.5 nm"), 1) ==
        doctest::Approx(outer + 0.25).epsilon(1e-14));
}
