// SPDX-License-Identifier: MIT
#include "polhode/forces/laws/mixing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/forces/laws/setting_names.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {
namespace {

void check_site(const std::string& word, const Topology& topology) {
  std::vector<std::string> names;  // of sites with Lennard-Jones parameters
  bool bare = false;               // whether the site exists, but without Lennard-Jones parameters
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites) {
      std::string name = part.molecule.name + '.' + site.name;
      if (name == word && site.epsilon == 0) bare = true;
      if (site.epsilon > 0 && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
    }
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  if (bare)
    throw Error(
        fmt::format("site '{}' has no Lennard-Jones parameters, so the pair loops skip it; give it "
                    "sigma and epsilon in its molecule file, or leave the pair out",
                    word));
  const std::string near = did_you_mean(word, names);
  throw Error(fmt::format(
      "there is no site '{}' in this system{}", word,
      !near.empty() ? near
      : names.empty()
          ? "; no site of this system has Lennard-Jones parameters, so leave the pair out"
          : "; sites are written as molecule.site, and there are: " + join_names(names)));
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
      throw Error(fmt::format("the {} is given twice; delete one", what));
    for (const double x : {pair->sigma, pair->epsilon})
      if (!(x >= 0) || !std::isfinite(x))
        throw Error(
            fmt::format("the {} has sigma {} nm and epsilon {} kJ/mol; both must be finite "
                        "and 0 or more",
                        what, pair->sigma, pair->epsilon));
    if (pair->epsilon > 0 && pair->sigma == 0)
      throw Error(
          fmt::format("the {} has epsilon {} kJ/mol but sigma 0 nm; a Lennard-Jones term "
                      "needs both, and epsilon 0 kJ/mol means none",
                      what, pair->epsilon));
  }
}

std::string description(const Mixing& mixing) {
  std::string text =
      mixing.rule == Mixing{}.rule ? "" : fmt::format("{} mixing", name_of(mixing.rule));
  for (const PairOverride& pair : mixing.pairs)
    text += fmt::format("{}{} with {}: sigma {} nm, epsilon {} kJ/mol", text.empty() ? "" : "; ",
                        pair.first, pair.second, pair.sigma, pair.epsilon);
  return text;
}

}  // namespace polhode
