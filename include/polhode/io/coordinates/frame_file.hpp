// SPDX-License-Identifier: MIT
// Files of frames, read and written one frame at a time. A coordinate file holds one frame, and a
// trajectory any number of frames. Files are never held in memory as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/coordinates/frame.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Reads the frames of a coordinate file in order.
class FrameReader {
 public:
  virtual ~FrameReader() = default;
  /// Reads the next frame into `frame`. The old contents of `frame` are replaced, and its memory is
  /// reused.
  /// @return  false at the end of the file
  /// @throws Error  with file, line or offset, the text found and the text expected
  virtual bool next(Frame& frame) = 0;
  /// Fraction of the file that has been read, from 0 to 1.
  virtual double fraction_read() { return 0; }
};

/// Opens a file; the format is chosen by the file extension.
/// @param names  kinds and residues of atoms for formats without names (XTC, TRR, DCD), in the
///   order of the file; if null, all atoms are of one unnamed kind
/// @throws Error  if the file cannot be read or its extension belongs to no format
std::unique_ptr<FrameReader> open_frames(const std::string& path, const Frame* names = nullptr);

/// Opens a LAMMPS dump file in which each particle is a molecule of the topology, in the order of
/// ids. The frames contain all sites of the molecules.
/// @throws Error  under the same conditions as open_frames(), or if the file has another format
std::unique_ptr<FrameReader> open_particle_frames(const std::string& path,
                                                  const Topology& topology);

/// Reads frames from a stream, as open_frames() does from a file. The stream must outlive the
/// reader.
/// @param format  file extension of the format, such as "gro"
/// @param file    name of the stream in error messages
std::unique_ptr<FrameReader> read_frames(std::istream& in, std::string_view format,
                                         const std::string& file, const Frame* names = nullptr);

/// Position in a coordinate file after a number of whole frames.
struct FileMark {
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;  ///< length of the file; 0 for formats whose marks do not use bytes
  /// CRC-64 of the file up to this position, without the bytes that change with each frame.
  std::uint64_t checksum = 0;
};

/// A named number that is stored with each frame, if the format can store numbers besides atoms.
struct FrameNumber {
  std::string_view name;  ///< "potential_energy"
  std::string_view unit;  ///< unit in H5MD notation, such as "kJ mol-1"
  double value;
};

/// Appends frames to a file.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;
  /// Appends the frame of a state. Formats that can store rigid bodies also receive the bodies.
  /// @throws RunError  if the file cannot be written completely
  virtual void write(const State& state) = 0;
  /// Writes a frame with observables. Every frame must have the same observables; formats that
  /// cannot store numbers ignore them.
  virtual void write(const State& state, std::span<const FrameNumber> /*observables*/) {
    write(state);
  }
  /// Appends a frame that was read from another file.
  virtual void write(const Frame& frame) = 0;
  /// Syncs all frames to disk and returns the position in the file.
  virtual FileMark mark() = 0;
};

/// Selects which data of a state are written.
struct FrameChoice {
  MasslessSites massless = MasslessSites::keep;
  bool velocities = true;  ///< whether to write velocities if the format has them
};

/// Creates a file, replacing an existing one.
/// @throws Error  if the file cannot be written or its extension is not in `writable_formats()`
std::unique_ptr<FrameWriter> create_frames(const std::string& path, const Topology& topology,
                                           const FrameChoice& choice = {});

/// Rejects a file if the contents before a mark have changed. Reads the file up to the mark.
/// @throws Error  if the contents have changed
void check_frames(const std::string& path, const FileMark& mark);

/// Resumes a file at a mark: keeps the frames before the mark, and removes everything after it.
/// @throws Error  if the file is shorter than the mark
std::unique_ptr<FrameWriter> resume_frames(const std::string& path, const Topology& topology,
                                           const FileMark& mark, const FrameChoice& choice = {});

/// Checks before a run that a file can hold the frames of the run.
/// @throws Error  if the format cannot hold that many atoms, or coordinates in a box of that size
void check_fit(const std::string& path, const State& state, const Topology& topology,
               const FrameChoice& choice = {});

/// The data that a file format can store.
/// @throws Error  if the extension belongs to no format
struct FormatTraits {
  bool names;       ///< whether the format stores names of atoms
  bool velocities;  ///< whether the format stores velocities of atoms
};
FormatTraits format_traits(const std::string& path);

/// Extensions of the formats that can be written, without the dot, such as "gro".
std::vector<std::string_view> writable_formats();

/// Reads an initial configuration: the built-in "w512", or the first frame of a file in any format
/// with atom names.
Frame read_start(const std::string& name_or_path);

}  // namespace polhode
