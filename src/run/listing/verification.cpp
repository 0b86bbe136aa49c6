// SPDX-License-Identifier: MIT
#include "run/listing/verification.hpp"

#include <fmt/core.h>

#include <cmath>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {

bool Verification::holds() const {
  return declared != 0 && std::abs(measured.order - declared) < 0.1;
}

Verification verify(const NamedScheme& scheme, int order, double lambda) {
  Verification v{scheme, {}, order};
  if (v.scheme.has(Flow::bath))
    throw Error(
        fmt::format("'{}' has a bath O; a bath exchanges energy with the system, so the energy "
                    "error does not show the order: verify the scheme without its stages O",
                    scheme.text));
  v.measured = measure_order(v.scheme, lambda);
  if (order == 0) v.declared = v.scheme.order();
  return v;
}

void check_lambda(const NestedScheme& scheme) {
  if (scheme.has(Gradient::finite_difference)) return;
  throw Error(
      fmt::format("{} has no finite-difference gradient, so lambda has no effect; leave lambda "
                  "out, or choose a scheme with such a gradient, for example gier4-fd",
                  name_of(scheme)));
}

Quantities quantities(const Verification& v) {
  std::vector<Quantities> points;
  const auto& measured = v.measured.points;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto& p = measured[i];
    points.push_back(
        {{"step", "[ps]", p.step, "time step"},
         {"", "fs", p.step * units::fs_per_ps, "", "step"},
         {"error", "", p.error, "energy error, divided by the initial kinetic energy",
          "energy error"},
         row("order",
             i == 0 ? "" : fmt::format("{:.2f}", std::log2(measured[i - 1].error / p.error)))});
  }
  const std::string verdict =
      v.declared == 0
          ? "; no declared order to compare with (set one with --order N)"
          : fmt::format(", declared {}: {}", v.declared, v.holds() ? "confirmed" : "NOT confirmed");
  return {{"scheme", "", name_of(v.scheme), "name of the scheme, or its stages"},
          {"points", "", points, "energy error at each time step", "energy error of a model"},
          {"measured_order", "", v.measured.order, "order from the slope of the energy error"},
          {"declared_order", "", v.declared, "expected order; 0 if unknown"},
          {"holds", "", v.declared ? Value(v.holds()) : Value(),
           "whether the measured and the expected order differ by less than 0.1; null if no order "
           "is expected"},
          row("", fmt::format("measured order {:.2f}{}", v.measured.order, verdict))};
}

}  // namespace polhode
