// SPDX-License-Identifier: MIT
// polhode export PROGRAM FILE: a run file as input of another program.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/option_values.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/base/error.hpp"
#include "run/conversion/lammps_export.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string program, file, pair_style = "table", output, scheme, step;
  bool force = false;
};

int export_run(const Options& o) {
  if (o.program != "lammps")
    throw Error(fmt::format("there is no export to '{}'; the program must be lammps", o.program));
  Config config = read_config_option(o.file);
  if (!o.output.empty()) config.output.prefix = o.output;
  if (!o.scheme.empty()) config.integrator.scheme = o.scheme;
  if (!o.step.empty()) config.integrator.step = quantity(o.step, Dimension::time, "--step");
  const auto style = named_option<LammpsPairStyle>(o.pair_style, "--pair-style");
  print_files(
      export_to_lammps(config, style, {.existing = existing_files(false, o.force)}, console()));
  return 0;
}

}  // namespace

Action export_verb(Command& command) {
  auto o = std::make_shared<Options>();
  command.add_option("PROGRAM", o->program, "lammps").required();
  command.add_option("FILE", o->file, "run file (TOML)").required();
  command.add_option("--pair-style", o->pair_style,
                     "table: the pair laws as tables; polhode: pair_style polhode of the plugin; "
                     "polhode-particles: the same with one particle a molecule; default: table");
  command.add_option("--output", o->output, "prefix of the files; default: the run file's");
  command.add_option("--scheme", o->scheme, "a name, or stages as text; default: the run file's");
  command.add_option("--step", o->step, "time step: \"2 fs\"; default: the run file's");
  command.add_flag("--force", o->force, "overwrite output files that exist");
  return [o] { return export_run(*o); };
}

}  // namespace polhode::cli
