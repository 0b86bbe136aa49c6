// SPDX-License-Identifier: MIT
#include "run/listing/verification.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/settings/nested_scheme_text.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

bool Verification::holds() const {
  return declared != 0 && std::abs(measured.order - declared) < 0.1;
}

Verification verify(const std::string& scheme, int order, double lambda) {
  Verification v{nested_scheme_of(scheme), {}, order};
  if (v.scheme.has(Flow::bath))
    throw Error(
        fmt::format("'{}' has a bath O, which exchanges energy with the system, so that the error "
                    "of the energy measures no order; verify the scheme without its stages O",
                    scheme));
  v.measured = measure_order(v.scheme, lambda);
  if (order == 0) v.declared = v.scheme.order();
  return v;
}

void check_lambda(const NestedScheme& scheme) {
  if (scheme.has(Gradient::finite_difference)) return;
  throw Error(
      fmt::format("{} has no gradient by finite difference, so lambda has no effect; leave "
                  "it out, or take a scheme with one, such as gier4-fd",
                  name_of(scheme)));
}

std::string verification_json(const Verification& v) {
  nlohmann::json points = nlohmann::json::array();
  for (const auto& p : v.measured.points) points.push_back({{"step", p.step}, {"error", p.error}});
  return nlohmann::json{{"scheme", name_of(v.scheme)},
                        {"measured_order", v.measured.order},
                        {"declared_order", v.declared},
                        {"holds", v.declared ? nlohmann::json(v.holds()) : nullptr},
                        {"points", points}}
      .dump(2);
}

}  // namespace polhode
