// SPDX-License-Identifier: MIT
// polhode convert IN OUT: converts frames from one format to another.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "run/requests.hpp"

namespace polhode::cli {
namespace {

struct ConvertOptions : RequestOptions<ConversionRequest> {
  std::string from, to;
};

int convert_frames(const ConvertOptions& o) {
  const Conversion conversion = o.request.conversion(o.from, o.to);
  const ConversionResult result = convert(conversion, o.output(), console());
  if (result.interrupted) return interrupted("; no file was written");
  fmt::print("{} {} written to {}\n", result.frames, result.frames == 1 ? "frame" : "frames",
             conversion.to);
  return 0;
}

}  // namespace

Action convert_verb(Command& command) {
  auto o = std::make_shared<ConvertOptions>();
  command.add_option("IN", o->from,
                     fmt::format("file to read: .{}, or a LAMMPS .data or .dump file",
                                 fmt::join(writable_formats(), " .")),
                     required);
  command.add_option("OUT", o->to, "file to write; .data and .dump can only be read", required);
  command.add_request(o->request);
  o->declare_force(command);
  return [o] { return convert_frames(*o); };
}

}  // namespace polhode::cli
