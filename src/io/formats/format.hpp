// SPDX-License-Identifier: MIT
// Interface of the formats: readers and writers of frames.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "format_limits.hpp"
#include "frame_view.hpp"
#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode {

struct Format {
  std::string_view extension;
  bool has_names;       ///< whether files contain names of atoms
  bool has_velocities;  ///< whether files contain velocities, at least optionally

  /// Creates a reader of a stream, which must outlive the reader; `file` is the file name in error
  /// messages.
  std::unique_ptr<FrameReader> (*read)(std::istream& in, const std::string& file);

  /// Creates a writer that starts a file or, given a stored position (mark), appends to the file;
  /// null if the format is read-only.
  std::unique_ptr<FrameWriter> (*write)(const std::string& path, const Topology& topology,
                                        const FrameChoice& choice, const FileMark* mark);

  /// Throws an Error if a file has changed since its position (mark) was stored; null if the format
  /// is read-only.
  void (*check)(const std::string& path, const FileMark& mark);

  /// Creates a reader of a file, for formats that are not read sequentially.
  std::unique_ptr<FrameReader> (*open)(const std::string& path) = nullptr;

  FormatLimits limits = {};
  bool may_lack_names = false;  ///< true if atom names are optional in files of the format
};

// In PDB files, a coordinate has eight columns and a box edge has nine, in Å with three decimals.
// Serials have five characters.
inline constexpr FormatLimits pdb_limits{
    .atoms = 87'440'031, .min = -99.9999, .max = 999.9999, .edge = 9999.9999};
// Coordinates are integers in units of 0.001 nm; the differences of coordinates must also fit in 32
// bits.
inline constexpr FormatLimits xtc_limits{
    .atoms = 2'147'483'647, .min = -1'073'741.8, .max = 1'073'741.8};
// The lengths of TRR and DCD records are signed 32-bit numbers. A record has 12 bytes per atom in
// TRR and 4 in DCD.
inline constexpr FormatLimits trr_limits{.atoms = 2'147'483'647 / 12};
inline constexpr FormatLimits dcd_limits{
    .atoms = 2'147'483'647 / 4, .same_atoms = true, .even_times = true};
inline constexpr FormatLimits h5md_limits{.same_atoms = true, .same_velocities = true};

/// The format with the extension of a file.
/// @throws Error  if no format has this extension
const Format& format_of(const std::string& path);

std::unique_ptr<FrameReader> gro_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> pdb_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> xyz_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> xtc_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> trr_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> dcd_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> h5md_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> lammps_data_reader(std::istream& in, const std::string& file);
std::unique_ptr<FrameReader> lammps_dump_reader(std::istream& in, const std::string& file);
/// Creates a reader of LAMMPS dump files with particles, each of which is a molecule. The frames
/// contain the sites of these molecules.
std::unique_ptr<FrameReader> lammps_particle_reader(std::istream& in, const std::string& file,
                                                    const Topology& topology);

std::unique_ptr<FrameReader> open_h5md(const std::string& path);

/// The time in a title written by GROMACS, such as "water t= 20.000 step= 10000" [ps]; 0 if there
/// is none.
double title_time(std::string_view title);

/// A function that appends a frame to a file that already has `before` frames.
using AppendFrame = void (*)(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_gro(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_pdb(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_xyz(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_xtc(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_trr(std::iostream& file, const FrameView& frame, std::uint64_t before);
void append_dcd(std::iostream& file, const FrameView& frame, std::uint64_t before);

/// How frames are appended to a file, and where the variable part of the file header ends.
struct Appending {
  AppendFrame append;
  std::uint64_t head;
};
/// End of the record that contains the number of frames in a DCD file.
constexpr std::uint64_t dcd_count_end = 92;

/// Creates a writer that appends frames to the end of a file.
std::unique_ptr<FrameWriter> stream_writer(Appending appending, const std::string& path,
                                           const Topology& topology, const FrameChoice& choice,
                                           const FileMark* mark);

/// The reason why this build does not support H5MD files; empty if it does.
extern const std::string_view h5md_missing;

void check_h5md(const std::string& path, const FileMark& mark);
std::unique_ptr<FrameWriter> h5md_writer(const std::string& path, const Topology& topology,
                                         const FrameChoice& choice, const FileMark* mark);

}  // namespace polhode
