// SPDX-License-Identifier: MIT
// polhode new KIND [FILE]: writes a commented run file as a starting point.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "io/settings/run_file_template.hpp"
#include "run/new_run_file.hpp"

namespace polhode::cli {
namespace {

struct NewOptions {
  NewRunFileRequest request;
  std::string kind, file;
  bool nvt = false, npt = false;
};

int write_run_file(NewOptions& o) {
  Given& ensemble = o.request.ensemble;
  if (o.nvt + o.npt + static_cast<bool>(ensemble) > 1)
    throw Error("--ensemble, --nvt and --npt exclude each other; give only one of these options");
  if (o.nvt || o.npt) ensemble.text = o.npt ? "npt" : "nvt";
  fmt::print("{0} was written; edit the file, then start the run: polhode run {0}\n",
             new_run_file(o.kind, o.file, o.request, console()));
  return 0;
}

}  // namespace

Action new_verb(Command& command) {
  auto o = std::make_shared<NewOptions>();
  command.add_option("KIND", o->kind, fmt::format("system: {}", fmt::join(run_file_kinds, ", ")),
                     required);
  command.add_option("FILE", o->file, "file to write; default: KIND.toml");
  command.add_request(o->request);
  command.add_flag("--nvt", o->nvt, "short for --ensemble nvt");
  command.add_flag("--npt", o->npt, "short for --ensemble npt");
  return [o] { return write_run_file(*o); };
}

}  // namespace polhode::cli
