// SPDX-License-Identifier: MIT
// Names of enumerations whose values users type or read.
#include "polhode/base/enum_names.hpp"

#include <doctest/doctest.h>

#include <string>

#include "polhode/rotor/free_rotation.hpp"
#include "polhode/run/adviser/criterion.hpp"

using namespace polhode;

TEST_CASE("names of rotor methods are those of --method") {
  CHECK(value_of<RotorMethod>("series") == RotorMethod::series);
  CHECK(value_of<RotorMethod>("closed") == RotorMethod::closed);
  CHECK(value_of<RotorMethod>("theta") == RotorMethod::theta);
  CHECK(value_of<RotorMethod>("recursive") == RotorMethod::recursive);
  CHECK(value_of<RotorMethod>("no-squish") == RotorMethod::no_squish);
  CHECK(value_of<RotorMethod>("symmetric-product") == RotorMethod::symmetric_product);
  CHECK(!value_of<RotorMethod>("no_squish"));
}

TEST_CASE("names of qualities are those of messages and JSON") {
  CHECK(name_of(Quality::ratio) == "R");
  CHECK(name_of(Quality::drift) == "energy drift");
  CHECK(name_of(Quality::temperature_bias) == "temperature bias");
}
