// SPDX-License-Identifier: MIT
// polhode top: the rotation of one free top, exact and with NO_SQUISH, or a table of tops.
#include "polhode/run/top/top.hpp"

#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "run/top/top_figure.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  std::vector<double> J, L;
  double step = 0, length = 0;
  std::string table, prefix, method = "series";
};

int print_trajectory(const Options& o) {
  if (o.J.size() != 3 || o.L.size() != 3)
    throw Error(
        "a top needs three principal moments and three components of angular momentum: write for "
        "example --J 1,2,3 --L 0.1,0.2,1, or give --table FILE.csv",
        "--J, --L");
  const Vec3<double> J{o.J[0], o.J[1], o.J[2]}, L{o.L[0], o.L[1], o.L[2]};
  const TopFigure figure(o.prefix);
  if (!o.prefix.empty()) check_prefix(o.prefix);
  if (!o.prefix.empty()) check_outputs(figure.files(), o.output().existing);
  const Callbacks callbacks = console();
  const TopTrajectory trajectory = integrate_top(J, L, o.step, o.length, callbacks.stop);
  print_results(quantities(trajectory), false);
  if (trajectory.interrupted) {
    log("interrupted; the table ends at the last sample before\n");
    return 130;
  }
  if (o.prefix.empty()) return 0;
  draw_top(figure, J, L, callbacks);
  log("wrote {}, {}, {} and {}\n", figure.svg, figure.png, figure.data, figure.script);
  return 0;
}

}  // namespace

Action top_verb(Command& command) {
  auto options = std::make_shared<Options>();
  command
      .add_option("--J", options->J, "principal moments, for example 1,2,3; any consistent units")
      .separated_by(',');
  command.add_option("--L", options->L, "body-frame angular momentum, for example 0.1,0.2,1")
      .separated_by(',');
  command.add_option("--step", options->step, "time step; default: the top turns by 0.2 per step");
  command.add_option("--length", options->length, "length of the trajectory; default: 200 steps");
  command.add_option("--output", options->prefix,
                     "draw the polhode on the inertia ellipsoid: PREFIX.svg, .png, .dat, .gp");
  options->declare_force(command);
  command.add_option(
      "--table", options->table,
      "read tops from a CSV file with columns I1,I2,I3,L1,L2,L3,t and print their rotations");
  command.add_option("--method", options->method,
                     "for --table: series (default), closed, theta, recursive, no-squish, "
                     "symmetric-product");
  return [options] {
    if (options->table.empty()) return print_trajectory(*options);
    fmt::print(
        "{}", rotate_table(options->table, given_name<RotorMethod>({options->method, "--method"})));
    return 0;
  };
}

}  // namespace polhode::cli
