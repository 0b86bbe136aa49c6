// SPDX-License-Identifier: MIT
// polhode convert IN OUT: converts frames from one format to another.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#include "../options/option_values.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "run/conversion/conversion.hpp"

namespace polhode::cli {
namespace {

struct Options {
  Conversion conversion;
  std::string from, to, particles;
  bool force = false;
};

int convert_frames(const Options& o) {
  Conversion conversion = o.conversion;
  if (!o.from.empty()) conversion.first = quantity(o.from, Dimension::time, "--from");
  if (!o.to.empty()) conversion.last = quantity(o.to, Dimension::time, "--to");
  if (!o.particles.empty())
    conversion.particles = molecules_of_run(read_config_option(o.particles));
  const ConversionResult result =
      convert(conversion, {.existing = existing_files(false, o.force)}, console());
  if (result.interrupted) {
    log("interrupted; no file was written\n");
    return 130;
  }
  fmt::print("{} {} written to {}\n", result.frames, result.frames == 1 ? "frame" : "frames",
             conversion.to);
  return 0;
}

}  // namespace

Action convert_verb(Command& command) {
  auto o = std::make_shared<Options>();
  command
      .add_option("IN", o->conversion.from,
                  fmt::format("file to read: .{}, or a LAMMPS .data or .dump file",
                              fmt::join(writable_formats(), " .")))
      .required();
  command
      .add_option("OUT", o->conversion.to,
                  "file to write, in any of these formats except those of LAMMPS")
      .required();
  command.add_option("--names", o->conversion.names,
                     "file with the atom names, if IN has none: XTC, TRR, DCD");
  command.add_option("--particles", o->particles,
                     "run file with the molecules that the particles of a LAMMPS dump file are");
  command.add_option("--every", o->conversion.every, "write every Nth frame only");
  command.add_option("--from", o->from, "ignore frames before this time: \"10 ps\"");
  command.add_option("--to", o->to, "ignore frames after this time");
  command.add_flag("--force", o->force, "overwrite OUT if it exists");
  return [o] { return convert_frames(*o); };
}

}  // namespace polhode::cli
