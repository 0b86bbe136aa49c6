// SPDX-License-Identifier: MIT
// polhode new KIND [FILE]: a commented run file to start from.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include "polhode/base/error.hpp"
#include "polhode/io/run_file_template.hpp"
#include "polhode/run/outputs.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

void write_run_file(const std::string& kind, const std::string& file) {
  const std::string_view text = run_file_template(kind);
  if (std::filesystem::exists(file))
    throw Error(
        fmt::format("'{}' exists and is never overwritten; give another name, for example "
                    "polhode new {} my-{}.toml",
                    file, kind, kind));
  check_outputs({file}, ExistingFiles::refuse);
  write_file(file, [&](std::ostream& out) { out << text; });
}

}  // namespace

Action new_verb(Command& command) {
  struct Options {
    std::string kind, file;
  };
  auto o = std::make_shared<Options>();
  command
      .add_option("KIND", o->kind,
                  "water, nvt, npt, mixture, gromacs (topology) or lammps (data file)")
      .required();
  command.add_option("FILE", o->file, "file to write; default: KIND.toml");
  return [o] {
    const std::string file = o->file.empty() ? o->kind + ".toml" : o->file;
    write_run_file(o->kind, file);
    fmt::print("{0} is written; edit it, then: polhode run {0}\n", file);
    return 0;
  };
}

}  // namespace polhode::cli
