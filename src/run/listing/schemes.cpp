// SPDX-License-Identifier: MIT
#include "run/listing/schemes.hpp"

#include <nlohmann/json.hpp>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"

namespace polhode {
namespace {

nlohmann::json as_json(const Scheme& scheme) {
  nlohmann::json stages = nlohmann::json::array();
  for (const Stage& s : scheme.stages())
    stages.push_back({{"flow", name_of(s.flow)},
                      {"fraction", s.fraction},
                      {"xi", s.xi},
                      {"gradient", s.xi == 0                            ? ""
                                   : s.has(Gradient::finite_difference) ? "finite difference"
                                                                        : "exact"}});
  return {{"name", scheme.name()},
          {"order", scheme.order()},
          {"stages", stages},
          {"force_evaluations", scheme.force_evaluations()},
          {"gradient_kicks", scheme.gradient_kicks()},
          {"derivatives", scheme.derivatives()},
          {"cost", scheme.cost()},
          {"palindrome", scheme.palindromic()},
          {"source", scheme.source()},
          {"text", text_of(scheme)}};
}

}  // namespace

std::string scheme_json(const Scheme& scheme) { return as_json(scheme).dump(2); }

std::string schemes_json() {
  nlohmann::json all = nlohmann::json::array();
  for (const Scheme& scheme : schemes) all.push_back(as_json(scheme));
  return all.dump(2);
}

}  // namespace polhode
