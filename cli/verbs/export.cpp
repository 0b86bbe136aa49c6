// SPDX-License-Identifier: MIT
// polhode export PROGRAM FILE: converts a run file to input for another program.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/base/error.hpp"
#include "run/conversion/lammps_export.hpp"
#include "run/quantity_lists.hpp"

namespace polhode::cli {
namespace {

struct ExportOptions : JobOptions {
  std::string program, pair_style = "table";
};

int export_run(const ExportOptions& o) {
  if (o.program != "lammps")
    throw Error(
        fmt::format("export to '{}' is not supported; the program must be lammps", o.program));
  const auto style = given_name<LammpsPairStyle>({o.pair_style, "--pair-style"});
  print_results({row_of_files(export_to_lammps(o.config(), style, o.output(), console()))}, {});
  return 0;
}

}  // namespace

Action export_verb(Command& command) {
  auto o = std::make_shared<ExportOptions>();
  command.add_option("PROGRAM", o->program, "lammps", required);
  o->declare_file(command, required);
  command.add_option(
      "--pair-style", o->pair_style,
      "table: the pair potentials as tables; polhode: pair_style polhode of the plugin; "
      "polhode-particles: pair_style polhode with one particle per molecule; default: table");
  command.add_settings();
  o->declare_force(command);
  return [o] { return export_run(*o); };
}

}  // namespace polhode::cli
