// SPDX-License-Identifier: MIT
#include "run/conversion/conversion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files/draft.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "run/output_files.hpp"

namespace polhode {
namespace {

std::optional<Frame> read_names(const std::string& file) {
  if (file.empty()) return std::nullopt;
  if (!format_traits(file).names)
    throw Error(fmt::format(
        "the format of '{}' has no atom names; give a GRO, PDB or XYZ file with the names", file));
  Frame frame;
  if (!open_frames(file)->next(frame))
    throw Error(fmt::format("'{}' contains no atoms; give a file of the same system", file));
  return frame;
}

void check_names(const Frame& frame, const Conversion& c) {
  if (!format_traits(c.to).names) return;
  for (const AtomKind& kind : frame.kinds)
    if (kind.name.empty())
      throw Error(
          fmt::format("'{}' has no atom names, but '{}' needs atom names; give a file with the "
                      "names of the same atoms, such as conf.gro",
                      c.from, c.to));
}

void check_selection(const Conversion& c) {
  if (c.every == 0) throw Error("the frame number is 0; it must be 1 or more");
  if (c.first > c.last)
    throw Error(fmt::format("the first time, {:g} ps, is later than the last, {:g} ps; swap them",
                            c.first, c.last));
}

// Times in files are rounded to floats or to a few decimals.
double slack(double time) { return 1e-6 * std::max(1.0, std::abs(time)); }

struct Written {
  ConversionResult result;
  bool velocities_lost = false;
};

Written write_frames(FrameReader& reader, const std::string& path, const Conversion& c,
                     const Callbacks& callbacks) {
  const bool velocities = format_traits(c.to).velocities;
  const auto writer = create_frames(path, {});
  Written written;
  std::size_t read = 0;
  for (Frame frame; reader.next(frame) && !(frame.time > c.last + slack(c.last));) {
    if (callbacks.stopped()) return {{0, true}};
    callbacks.report({"converting", reader.fraction_read()});
    if (frame.time < c.first - slack(c.first) || read++ % c.every != 0) continue;
    if (written.result.frames++ == 0) check_names(frame, c);
    written.velocities_lost |= frame.has_velocities && !velocities;
    complete_elements(frame);
    writer->write(frame);
  }
  if (written.result.frames == 0)
    throw Error(fmt::format(
        "'{}' has no frame between the first and the last time; choose other times", c.from));
  writer->mark();
  return written;
}

}  // namespace

ConversionResult convert(const Conversion& c, const OutputOptions& options,
                         const Callbacks& callbacks) {
  check_selection(c);
  const std::optional<Frame> names = read_names(c.names);
  const auto reader = c.particles ? open_particle_frames(c.from, *c.particles)
                                  : open_frames(c.from, names ? &*names : nullptr);
  check_outputs({c.to}, options.existing);
  Draft draft(c.to, Draft::Name::unique);
  const Written written = [&] {
    try {
      return write_frames(*reader, draft.path(), c, callbacks);
    } catch (const RunError& e) {
      throw RunError(draft.with_final_name(e.what()));
    } catch (const Error& e) {
      throw Error(draft.with_final_name(e.what()), e.where());
    }
  }();
  if (written.result.interrupted) return written.result;
  draft.finish();
  if (written.velocities_lost)
    callbacks.note(fmt::format(
        "note: velocities are not written, because the format of '{}' cannot store velocities",
        c.to));
  return written.result;
}

}  // namespace polhode
