// SPDX-License-Identifier: MIT
// polhode verify NAME|TEXT: the order of a scheme from the slope of its energy error.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <string>

#include "../options/option_values.hpp"
#include "../verbs.hpp"
#include "io/settings/nested_scheme_text.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "run/listing/verification.hpp"

namespace polhode::cli {
namespace {

void check_lambda_option(const std::string& scheme) try {
  check_lambda(nested_scheme_of(scheme));
} catch (const Error& e) {
  throw e.at("--lambda");
}

void print_text(const Verification& v) {
  const auto& points = v.measured.points;
  fmt::print("{:>12}  {:>16}  {:>6}\n", "step [fs]", "energy error", "order");
  for (std::size_t i = 0; i < points.size(); ++i)
    fmt::print(
        "{:>12.6g}  {:>16.3e}  {:>6}\n", points[i].step * units::fs_per_ps, points[i].error,
        i == 0 ? "" : fmt::format("{:.2f}", std::log2(points[i - 1].error / points[i].error)));
  fmt::print("measured order {:.2f}", v.measured.order);
  if (v.declared == 0)
    fmt::print("; no order is declared, so there is nothing to compare with (--order N)\n");
  else
    fmt::print(", declared {}: {}\n", v.declared, v.holds() ? "confirmed" : "NOT confirmed");
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
    if (command.given("--lambda")) check_lambda_option(o->scheme);
    const Verification v = verify(o->scheme, o->order, o->lambda);
    if (o->json)
      fmt::print("{}\n", verification_json(v));
    else
      print_text(v);
    return v.declared == 0 || v.holds() ? 0 : 1;
  };
}

}  // namespace polhode::cli
