// SPDX-License-Identifier: MIT
// polhode verify NAME|TEXT: the order of a scheme from the slope of its energy error.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "option_values.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/measure/order.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

void check_lambda(const NestedScheme& scheme) {
  if (scheme.has(Gradient::finite_difference)) return;
  throw Error(fmt::format("{} has no gradient by finite difference, so lambda has no effect; leave "
                          "it out, or take a scheme with one, such as gier4-fd",
                          name_of(scheme)),
              "--lambda");
}

}  // namespace

Action verify_verb(Command& command) {
  struct Options {
    std::string scheme;
    int order = 0;
    double lambda = 1e-4;
    bool json = false;
  };
  auto o = std::make_shared<Options>();
  command.add_option("SCHEME", o->scheme, "a scheme's name, or its stages as text").required();
  command.add_option("--order", o->order, "expected order; default: that of the table")
      .in_range(1, 12);
  command.add_option("--lambda", o->lambda, "of the finite-difference gradient")
      .in_range(1e-8, 1.0);
  command.add_flag("--json", o->json, "print JSON");
  return [o, command] {
    const NestedScheme scheme = nested_scheme_of(o->scheme);
    if (command.given("--lambda")) check_lambda(scheme);
    const OrderMeasurement m = measure_order(scheme, o->lambda);
    const int declared = o->order ? o->order : scheme.order();
    // The error of a symmetric scheme is C hᵏ + O(hᵏ⁺²): the slope differs from k by O(h²),
    // here < 0.1.
    const bool holds = declared != 0 && std::abs(m.order - declared) < 0.1;
    if (o->json) {
      nlohmann::json points = nlohmann::json::array();
      for (const auto& p : m.points) points.push_back({{"step", p.step}, {"error", p.error}});
      fmt::print("{}\n", nlohmann::json{{"scheme", name_of(scheme)},
                                        {"measured_order", m.order},
                                        {"declared_order", declared},
                                        {"holds", declared ? nlohmann::json(holds) : nullptr},
                                        {"points", points}}
                             .dump(2));
    } else {
      fmt::print("{:>12}  {:>16}  {:>6}\n", "step [fs]", "energy error", "order");
      for (std::size_t i = 0; i < m.points.size(); ++i)
        fmt::print(
            "{:>12.6g}  {:>16.3e}  {:>6}\n", m.points[i].step * units::fs_per_ps, m.points[i].error,
            i == 0 ? ""
                   : fmt::format("{:.2f}", std::log2(m.points[i - 1].error / m.points[i].error)));
      fmt::print("measured order {:.2f}", m.order);
      if (declared == 0)
        fmt::print("; no order is declared, so there is nothing to compare with (--order N)\n");
      else
        fmt::print(", declared {}: {}\n", declared, holds ? "confirmed" : "NOT confirmed");
    }
    return declared == 0 || holds ? 0 : 1;
  };
}

}  // namespace polhode::cli
