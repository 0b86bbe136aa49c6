// SPDX-License-Identifier: MIT
// polhode top: computes the rotation of a free top, exactly and with NO_SQUISH, for one top or all
// tops in a table.
#include "polhode/run/top/top.hpp"

#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "run/requests.hpp"
#include "run/top/top_figure.hpp"

namespace polhode::cli {
namespace {

using TopOptions = RequestOptions<TopRequest>;

int print_trajectory(const TopOptions& o) {
  const auto [J, L, step, length] = o.request.top();
  std::optional<TopFigure> figure;
  if (o.request.output) figure.emplace(o.request.output.text, o.output());
  const Callbacks callbacks = console();
  const TopTrajectory trajectory = integrate_top(J, L, step, length, callbacks.stop);
  print_results(quantities(trajectory), {});
  if (trajectory.interrupted)
    return interrupted("; the table ends at the last sample before the interrupt");
  if (!figure) return 0;
  draw_top(*figure, J, L, callbacks);
  log("wrote {}\n", fmt::join(figure->files(), ", "));
  return 0;
}

}  // namespace

Action top_verb(Command& command) {
  auto o = std::make_shared<TopOptions>();
  command.add_request(o->request);
  o->declare_force(command);
  return [o] {
    if (!o->request.table) return print_trajectory(*o);
    fmt::print("{}", o->request.rotated_table());
    return 0;
  };
}

}  // namespace polhode::cli
