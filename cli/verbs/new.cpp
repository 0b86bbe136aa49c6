// SPDX-License-Identifier: MIT
// polhode new KIND [FILE]: a commented run file to start from.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "base/printable.hpp"
#include "io/settings/run_file_template.hpp"
#include "io/topology/gromacs_mdp.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string kind, file, mdp, ensemble;
  bool nvt = false, npt = false;
};

std::string text_of(const Options& o, const std::string& file) {
  if (o.nvt + o.npt + !o.ensemble.empty() > 1)
    throw Error("--ensemble, --nvt and --npt exclude each other; leave all but one out");
  const std::string ensemble = o.npt ? "npt" : o.nvt ? "nvt" : o.ensemble;
  if (o.mdp.empty()) return run_file_template(o.kind, ensemble);
  if (o.kind != "gromacs")
    throw Error(
        fmt::format("--mdp has parameters of GROMACS, and the kind is '{}'; write "
                    "polhode new gromacs --mdp {}",
                    o.kind, o.mdp));
  if (!ensemble.empty())
    throw Error("--mdp has the ensemble, tcoupl and pcoupl; leave out --ensemble");
  const MdpImport read = read_mdp(o.mdp, {.prefix = std::filesystem::path(file).stem().string()});
  for (const auto& [parameter, reason] : read.differences)
    log("note: {}: {}\n", printable(parameter), reason);
  return read.run_file;
}

int write_run_file(const Options& o) {
  const std::string file = o.file.empty() ? o.kind + ".toml" : o.file;
  const std::string text = text_of(o, file);
  if (std::filesystem::exists(file))
    throw Error(
        fmt::format("'{}' exists and is never overwritten; give another name, for example "
                    "polhode new {} my-{}.toml",
                    file, o.kind, o.kind));
  check_outputs({file}, ExistingFiles::refuse);
  write_file(file, [&](std::ostream& out) { out << text; });
  fmt::print("{0} is written; edit it, then: polhode run {0}\n", file);
  return 0;
}

}  // namespace

Action new_verb(Command& command) {
  auto o = std::make_shared<Options>();
  command
      .add_option("KIND", o->kind,
                  "water, nvt, npt, mixture, gromacs (topology) or lammps (data file)")
      .required();
  command.add_option("FILE", o->file, "file to write; default: KIND.toml");
  command.add_option(
      "--ensemble", o->ensemble,
      "nvt: add a thermostat to a kind without one: gromacs, lammps, water, mixture; npt: add a "
      "barostat, too");
  command.add_flag("--nvt", o->nvt, "the same as --ensemble nvt");
  command.add_flag("--npt", o->npt, "the same as --ensemble npt");
  command.add_option("--mdp", o->mdp,
                     "run parameters of GROMACS to translate; those without counterpart are "
                     "listed");
  return [o] { return write_run_file(*o); };
}

}  // namespace polhode::cli
