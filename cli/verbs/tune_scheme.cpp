// SPDX-License-Identifier: MIT
// polhode tune-scheme [FILE]: finds the best parameters of a scheme for a given system and step.
// The parameters are η of the hoa2 family, η and ξ of the gier4 family, or the free parameters of a
// user-defined scheme.

#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

using TuneSchemeOptions = RequestOptions<TuneRequest>;

int tune_scheme(const TuneSchemeOptions& o) {
  const Config config = o.config();
  const TuneSettings settings = o.request.settings(config);
  Workers workers = o.workers();
  const TuneResult result = tune(config, settings, console(), workers);
  if (result.interrupted) return interrupted(" before a result was found");
  print_results(quantities(result), o);
  return 0;
}

}  // namespace

Action tune_scheme_verb(Command& command) {
  auto o = std::make_shared<TuneSchemeOptions>();
  o->declare(command, "simultaneous runs");
  command.add_request(o->request);
  return [o] { return tune_scheme(*o); };
}

}  // namespace polhode::cli
