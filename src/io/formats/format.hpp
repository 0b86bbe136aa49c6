// SPDX-License-Identifier: MIT
// What a format is: how its frames are read, and how they are written.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "frame_view.hpp"
#include "polhode/io/frame_file.hpp"

namespace polhode {

struct Format {
  std::string_view ending;
  bool has_names;       ///< of atoms
  bool has_velocities;  ///< or can have them

  /// A reader of a stream, which must outlive it; `file` is its name in errors.
  std::unique_ptr<FrameReader> (*read)(std::istream& in, const std::string& file);

  /// Begins a file, or goes on after a mark.
  std::unique_ptr<FrameWriter> (*write)(const std::string& path, const Topology& topology,
                                        const FrameChoice& choice, const FileMark* mark);
};

/// The format that a file's ending names.
/// @throws Error  if there is none
const Format& format_of(const std::string& path);

std::unique_ptr<FrameReader> gro_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> xyz_reader(std::istream& in, const std::string& file);

/// Appends a frame to a stream that holds `before` frames.
using AppendFrame = void (*)(std::ostream& out, const FrameView& frame, std::uint64_t before);
void append_gro(std::ostream& out, const FrameView& frame, std::uint64_t before);
void append_xyz(std::ostream& out, const FrameView& frame, std::uint64_t before);

/// A writer of a file to whose end frames are appended.
std::unique_ptr<FrameWriter> stream_writer(AppendFrame append, const std::string& path,
                                           const Topology& topology, const FrameChoice& choice,
                                           const FileMark* mark);

}  // namespace polhode
