// SPDX-License-Identifier: MIT
#include "io/figures/figure_script.hpp"

#include <doctest/doctest.h>

#include <set>
#include <utility>

#include "polhode/integrate/schemes.hpp"
#include "polhode/run/canonical/canonical_study.hpp"

using namespace polhode;

namespace {

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Scheme& scheme : schemes) names.emplace_back(scheme.name());
  return names;
}

}  // namespace

TEST_CASE("every scheme has a style of its own, which no text of a scheme shares") {
  std::vector<std::string> names = all_names();
  for (int k = 0; k < 6; ++k) names.push_back("B(1/2) A(1) B(1/2) of user " + std::to_string(k));
  std::set<std::pair<std::string, int>> found;
  for (const SchemeStyle& style : scheme_styles(names)) {
    CHECK(style.colour.size() == 7);
    CHECK(style.filled == style.open + 1);
    found.insert({style.colour, style.filled});
  }
  CHECK(found.size() == names.size());
}

TEST_CASE("the style of a scheme does not depend on the others of a figure") {
  const SchemeStyle hoa2 = scheme_styles({"hoa2"})[0];
  CHECK(hoa2.colour == "#D55E00");
  CHECK(hoa2.filled == 5);
  const auto styles = scheme_styles({"my scheme", "gier4", "hoa2", "another"});
  CHECK(styles[2].colour == hoa2.colour);
  CHECK(styles[2].filled == hoa2.filled);
  CHECK(styles[0].colour == scheme_styles({"x"})[0].colour);
  CHECK(styles[0].colour != styles[3].colour);
  CHECK(scheme_styles({}).empty());
}

TEST_CASE("no two methods of a canonical study share a colour") {
  std::vector<std::string> names;
  for (const NamedScheme& scheme : canonical_schemes()) names.push_back(scheme.text);
  REQUIRE(names.back() == "hoa2");
  names.back() = "hmc-hoa2";
  std::set<std::string> colours;
  for (const SchemeStyle& style : scheme_styles(names)) colours.insert(style.colour);
  CHECK(colours.size() == names.size());
}
