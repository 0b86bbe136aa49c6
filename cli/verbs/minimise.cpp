// SPDX-License-Identifier: MIT
// polhode minimise [FILE]: finds the nearest energy minimum and writes a coordinate file.

#include <memory>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

using MinimiseOptions = RequestOptions<MinimisationRequest>;

int minimise(const MinimiseOptions& o) {
  const MinimisationSettings settings = o.request.settings();
  Workers workers = o.workers();
  const MinimisationReport report =
      minimise_configuration(o.config(), settings, o.output(), console(), workers);
  print_results(quantities(report), o);
  return report.minimisation.end == MinimisationEnd::stopped ? 130 : 0;
}

}  // namespace

Action minimise_verb(Command& command) {
  auto o = std::make_shared<MinimiseOptions>();
  o->declare(command, "threads");
  command.add_request(o->request);
  command.add_settings();
  o->declare_force(command);
  return [o] { return minimise(*o); };
}

}  // namespace polhode::cli
