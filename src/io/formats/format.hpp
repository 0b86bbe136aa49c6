// SPDX-License-Identifier: MIT
// Interface of the formats: readers and writers of frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "format_limits.hpp"
#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode {

/// A frame whose atoms are not all stored at once. A view visits the atoms one after another, and
/// stores only references to its sources.
struct FrameView {
  std::string title;
  std::vector<AtomKind> kinds;
  std::size_t atoms = 0;
  bool has_velocities = false;
  Box box;          ///< box [nm]
  double time = 0;  ///< time [ps]
  std::function<void(const std::function<void(const Atom&)>&)> each_atom;
};

FrameView view_of(const State& state, const Topology& topology, const FrameChoice& choice = {});

/// Makes a view of a frame. All atoms are written, because massless sites cannot be recognized
/// without masses.
FrameView view_of(const Frame& frame, const FrameChoice& choice = {});

/// A function that creates a reader of a stream, which must outlive the reader. `file` is the file
/// name in error messages.
using ReadFormat = std::unique_ptr<FrameReader>(std::istream& in, const std::string& file);

/// A function that creates a writer, which starts a file or, given a stored position (mark),
/// appends to the file.
using WriteFormat = std::unique_ptr<FrameWriter>(const std::string& path, const Topology& topology,
                                                 const FrameChoice& choice, const FileMark* mark);

struct Format {
  std::string_view extension;
  bool has_names;       ///< whether files contain names of atoms
  bool has_velocities;  ///< whether files contain velocities, at least optionally
  ReadFormat* read;
  WriteFormat* write;  ///< null if the format is read-only

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

ReadFormat gro_reader, pdb_reader, xyz_reader, xtc_reader, trr_reader, dcd_reader, h5md_reader;
ReadFormat lammps_data_reader, lammps_dump_reader;
/// Creates a reader of LAMMPS dump files with particles, each of which is a molecule. The frames
/// contain the sites of these molecules.
std::unique_ptr<FrameReader> lammps_particle_reader(std::istream& in, const std::string& file,
                                                    const Topology& topology);

std::unique_ptr<FrameReader> open_h5md(const std::string& path);

/// The time in a title written by GROMACS, such as "water t= 20.000 step= 10000" [ps]; 0 if there
/// is none.
double title_time(std::string_view title);

/// A function that appends a frame to a file that already has `before` frames.
using AppendFrame = void(std::iostream& file, const FrameView& frame, std::uint64_t before);
AppendFrame append_gro, append_pdb, append_xyz, append_xtc, append_trr, append_dcd;

/// End of the record that contains the number of frames in a DCD file.
constexpr std::uint64_t dcd_count_end = 92;

/// Creates a writer that appends frames to the end of a file.
/// @param head  end of the variable part of the file header
std::unique_ptr<FrameWriter> stream_writer(AppendFrame* append, std::uint64_t head,
                                           const std::string& path, const Topology& topology,
                                           const FrameChoice& choice, const FileMark* mark);

/// The reason why this build does not support H5MD files; empty if it does.
extern const std::string_view h5md_missing;

void check_h5md(const std::string& path, const FileMark& mark);
WriteFormat h5md_writer;

}  // namespace polhode
