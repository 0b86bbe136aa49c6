// SPDX-License-Identifier: MIT
// polhode convert IN OUT: converts frames from one format to another.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "console.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/draft.hpp"
#include "polhode/io/frame_file.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/io/table_file.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string in, out, names, from, to;
  std::size_t every = 1;
  bool force = false;
};

double bound(const std::string& text, const char* option, double otherwise) {
  return text.empty() ? otherwise : quantity(text, Dimension::time, option);
}

std::optional<Frame> names_of(const Options& o) {
  if (o.names.empty()) return std::nullopt;
  Frame frame;
  if (!format_traits(o.names).names)
    throw Error(fmt::format(
        "--names {} is of a format without atom names; give a GRO, PDB or XYZ file", o.names));
  if (!open_frames(o.names)->next(frame))
    throw Error(
        fmt::format("--names {} contains no atoms; give a file of the same system", o.names));
  return frame;
}

void check_names(const Frame& frame, const Options& o) {
  if (!format_traits(o.out).names) return;
  for (const AtomKind& kind : frame.kinds)
    if (kind.name.empty())
      throw Error(
          fmt::format("'{}' has no atom names, which '{}' needs; add --names with a file of the "
                      "same atoms, for example --names conf.gro",
                      o.in, o.out));
}

int convert(const Options& o) {
  if (o.every == 0) throw Error("--every 0 selects no frame; it must be 1 or more");
  const double from = bound(o.from, "--from", -HUGE_VAL), to = bound(o.to, "--to", HUGE_VAL);
  if (from > to)
    throw Error(fmt::format("--from {} is later than --to {}; exchange them", o.from, o.to));
  const FormatTraits held = format_traits(o.out);
  const std::optional<Frame> names = names_of(o);
  const auto reader = open_frames(o.in, names ? &*names : nullptr);
  refuse_existing(o.out, o.force);
  Draft draft(o.out, Draft::Name::unique);
  auto writer = create_frames(draft.path(), {});

  const Callbacks callbacks = console();
  std::size_t read = 0, written = 0;
  bool lost = false;
  // Times in files are rounded, to floats or to some decimals.
  const auto slack = [](double time) { return 1e-6 * std::max(1.0, std::abs(time)); };
  for (Frame frame; reader->next(frame);) {
    if (callbacks.stopped()) {
      log("interrupted; no file was written\n");
      return 130;
    }
    callbacks.report({"converting", reader->fraction_read()});
    if (frame.time > to + slack(to)) break;
    if (frame.time < from - slack(from) || read++ % o.every != 0) continue;
    if (written == 0) check_names(frame, o);
    lost = lost || (frame.has_velocities && !held.velocities);
    complete_elements(frame);
    writer->write(frame);
    ++written;
  }
  if (written == 0)
    throw Error(fmt::format("'{}' has no frame between --from and --to; choose other times", o.in));
  writer->mark();
  writer.reset();
  draft.finish();
  if (lost) log("note: velocities are not written; the format {} has none\n", o.out);
  fmt::print("{} {} written to {}\n", written, written == 1 ? "frame" : "frames", o.out);
  return 0;
}

}  // namespace

Action convert_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("IN", o->in,
                 "file to read: .gro .pdb .xyz .xtc .trr .dcd .h5md, or a LAMMPS .data file")
      ->required();
  app.add_option("OUT", o->out, "file to write, of any of these formats but the last")->required();
  app.add_option("--names", o->names, "file with the atom names, if IN has none: XTC, TRR, DCD");
  app.add_option("--every", o->every, "take every Nth frame only");
  app.add_option("--from", o->from, "ignore frames before this time: \"10 ps\"");
  app.add_option("--to", o->to, "ignore frames after this time");
  app.add_flag("--force", o->force, "overwrite OUT if it exists");
  return [o] { return convert(*o); };
}

}  // namespace polhode::cli
