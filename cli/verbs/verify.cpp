// SPDX-License-Identifier: MIT
// polhode verify NAME|TEXT: the order of a scheme from the slope of its energy error.
#include <memory>
#include <string>

#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../verbs.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/listing/verification.hpp"

namespace polhode::cli {
namespace {

void check_lambda_option(const NamedScheme& scheme) try {
  check_lambda(scheme);
} catch (const Error& e) {
  throw e.at("--lambda");
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
    const NamedScheme scheme = o->scheme;
    if (command.given("--lambda")) check_lambda_option(scheme);
    const Verification v = verify(scheme, o->order, o->lambda);
    print_results(quantities(v), o->json);
    return v.declared == 0 || v.holds() ? 0 : 1;
  };
}

}  // namespace polhode::cli
