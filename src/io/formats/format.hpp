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

  /// Begins a file, or goes on after a mark; null where a format is read alone.
  std::unique_ptr<FrameWriter> (*write)(const std::string& path, const Topology& topology,
                                        const FrameChoice& choice, const FileMark* mark);

  /// A reader of a file, for formats that are not read from its begin to its end.
  std::unique_ptr<FrameReader> (*open)(const std::string& path) = nullptr;
};

/// The format that a file's ending names.
/// @throws Error  if there is none
const Format& format_of(const std::string& path);

std::unique_ptr<FrameReader> gro_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> pdb_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> xyz_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> xtc_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> trr_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> dcd_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> h5md_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> lammps_data_reader(std::istream& in, const std::string& file);

std::unique_ptr<FrameReader> open_h5md(const std::string& path);

/// The time that a title tells as GROMACS writes it, "water t= 20.000 step= 10000" [ps]; else 0.
double title_time(std::string_view title);

/// Appends a frame to a file that holds `before` frames.
using AppendFrame = void (*)(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_gro(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_pdb(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_xyz(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_xtc(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_trr(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_dcd(std::iostream& file, const FrameView& frame, std::uint64_t before);

/// A writer of a file to whose end frames are appended.
std::unique_ptr<FrameWriter> stream_writer(AppendFrame append, const std::string& path,
                                           const Topology& topology, const FrameChoice& choice,
                                           const FileMark* mark);

std::unique_ptr<FrameWriter> h5md_writer(const std::string& path, const Topology& topology,
                                         const FrameChoice& choice, const FileMark* mark);

}  // namespace polhode
