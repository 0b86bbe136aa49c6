// SPDX-License-Identifier: MIT
#include "polhode/io/settings/type_pairs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::size_t max_pairs = 10'000;

struct Type {
  bool bare = true;  // whether the type has no potential
  std::set<std::string> sites;
};

}  // namespace

std::vector<PairOverride> overrides(std::span<const TypedSite> sites,
                                    std::span<const TypePair> pairs) {
  std::map<std::string, Type> types;
  std::map<std::string, std::set<std::string>> types_of;  // atom types by site name
  for (const TypedSite& site : sites) {
    types[site.type].bare = is_zero(site.epsilon, site.law);
    types[site.type].sites.insert(site.name);
    types_of[site.name].insert(site.type);
  }
  std::map<std::pair<std::string, std::string>, PairOverride> given;
  std::map<std::pair<std::string, std::string>, const TypePair*> met;
  for (const TypePair& pair : pairs) {
    const auto first = types.find(pair.first), second = types.find(pair.second);
    if (first == types.end() || second == types.end()) continue;
    const auto refuse = [&](const std::string& what) { throw Error(what, text_of(pair.place)); };
    const auto [earlier, is_new] = met.try_emplace(std::minmax(pair.first, pair.second), &pair);
    if (!is_new) {
      const TypePair& other = *earlier->second;
      if (other.sigma == pair.sigma && other.epsilon == pair.epsilon && other.law == pair.law)
        continue;
      refuse(
          fmt::format("the pair of atom types '{}' and '{}' is already defined in {} with other "
                      "parameters; delete one of the definitions",
                      pair.first, pair.second, text_of(other.place)));
    }
    const bool bare = first->second.bare || second->second.bare;
    if (bare && is_zero(pair.epsilon, pair.law)) continue;
    if (pair.epsilon < 0)
      refuse(
          "the pair has only one of C6 and C12; set both or neither, since sigma and epsilon "
          "follow from both");
    if (bare)
      refuse(fmt::format(
          "the pair of atom types '{}' and '{}' has a short-range potential, but one of these "
          "types has no potential with itself; both types must have such a potential",
          pair.first, pair.second));
    for (const std::string& a : first->second.sites)
      for (const std::string& b : second->second.sites) {
        for (const std::string& site : {a, b})
          if (types_of.at(site).size() > 1)
            refuse(
                fmt::format("atoms with the name '{}' have several types, but this pair applies to "
                            "only one of the types; give atoms of different types different names",
                            site));
        given[std::minmax(a, b)] = {a, b, pair.sigma, pair.epsilon, pair.law};
        if (given.size() > max_pairs)
          refuse(
              fmt::format("there are more than {} pairs of sites, the maximum; delete unused pairs",
                          max_pairs));
      }
  }
  std::vector<PairOverride> list;
  for (const auto& [names, pair] : given) list.push_back(pair);
  return list;
}

}  // namespace polhode
