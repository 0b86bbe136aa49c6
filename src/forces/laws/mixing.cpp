// SPDX-License-Identifier: MIT
#include "polhode/forces/laws/mixing.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/suggest.hpp"
#include "forces/laws/setting_names.hpp"
#include "polhode/base/error.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {
namespace {

void check_site(const std::string& word, const Topology& topology) {
  std::vector<std::string> names;  // names of sites with a short-range potential
  bool bare = false;               // whether the site exists but has no short-range potential
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites) {
      std::string name = part.molecule.name + '.' + site.name;
      if (name == word && !site.has_short_range()) bare = true;
      if (site.has_short_range() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
    }
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  if (bare)
    throw Error(fmt::format(
        "site '{}' has no short-range potential, so a [[pair]] with this site has no effect; set "
        "its sigma and epsilon in the molecule file, or delete the [[pair]]",
        word));
  const std::string near = did_you_mean(word, names);
  throw Error(fmt::format(
      "there is no site '{}' in this system{}", word,
      !near.empty() ? near
      : names.empty()
          ? "; no site of this system has a short-range potential, so delete the [[pair]]"
          : "; sites are written as molecule.site; the sites are: " + join_names(names)));
}

bool same_sites(const PairOverride& a, const PairOverride& b) {
  return (a.first == b.first && a.second == b.second) ||
         (a.first == b.second && a.second == b.first);
}

}  // namespace

void check(const Mixing& mixing, const Topology& topology) {
  for (auto pair = mixing.pairs.begin(); pair != mixing.pairs.end(); ++pair) {
    check_site(pair->first, topology);
    check_site(pair->second, topology);
    const std::string what = fmt::format("pair of '{}' and '{}'", pair->first, pair->second);
    if (std::any_of(mixing.pairs.begin(), pair,
                    [&](const PairOverride& other) { return same_sites(other, *pair); }))
      throw Error(fmt::format("the {} is given twice; delete one of the two", what));
    try {
      check(pair->sigma, pair->epsilon, pair->law);
    } catch (const Error& e) {
      throw Error(fmt::format("in the {}, {}", what, e.what()));
    }
  }
}

std::string description(const Mixing& mixing) {
  std::string text =
      mixing.rule == Mixing{}.rule ? "" : fmt::format("{} mixing", name_of(mixing.rule));
  for (const PairOverride& pair : mixing.pairs)
    text += fmt::format("{}{} with {}: {}", text.empty() ? "" : "; ", pair.first, pair.second,
                        parameters(pair.sigma, pair.epsilon, pair.law));
  return text;
}

}  // namespace polhode
