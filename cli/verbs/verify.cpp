// SPDX-License-Identifier: MIT
// polhode verify NAME|TEXT: measures the order of a scheme from the slope of its energy error.
#include <memory>
#include <string>

#include "../reports/reports.hpp"
#include "../verbs.hpp"
#include "run/listing/verification.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
Action verify_verb(Command& command) {
  struct VerifyOptions : ResultForm {
    std::string scheme;
    VerificationRequest request;
  };
  auto o = std::make_shared<VerifyOptions>();
  command.add_option("SCHEME", o->scheme, "a scheme's name, or its stages as text", required);
  command.add_request(o->request);
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    const NamedScheme scheme = o->scheme;
    const Verification v =
        verify(scheme, o->request.expected_order(), o->request.gradient_lambda(scheme));
    print_results(quantities(v), *o);
    return v.declared == 0 || v.holds() ? 0 : 1;
  };
}

}  // namespace polhode::cli
