// SPDX-License-Identifier: MIT
// Files of frames, read and written one frame at a time: a coordinate file holds one, a trajectory
// any number, and none is ever held whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/frame.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Frames of a file in their order.
class FrameReader {
 public:
  virtual ~FrameReader() = default;
  /// Reads the next frame; what `frame` held is replaced and its memory used again.
  /// @return  false where the file ends
  /// @throws Error  with the file and line or offset: what was found, and what was expected
  virtual bool next(Frame& frame) = 0;
  /// How much of the file has been read, 0 to 1.
  virtual double fraction_read() { return 0; }
};

/// Opens a file of the format that its ending names.
/// @param names  kinds and residues of the atoms for formats that have none (XTC, TRR, DCD), in the
///               file's order; without it such atoms are of one kind without a name
/// @throws Error  if the file cannot be read or its ending is none of `readable_formats()`
std::unique_ptr<FrameReader> open_frames(const std::string& path, const Frame* names = nullptr);

/// The same from a stream, which must outlive the reader.
/// @param format  one of `readable_formats()`
/// @param file    its name in errors
std::unique_ptr<FrameReader> read_frames(std::istream& in, std::string_view format,
                                         const std::string& file, const Frame* names = nullptr);

/// Where a file stands after whole frames.
struct FileMark {
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;  ///< length of the file; 0 where the format does not count in bytes
};

/// A number of a frame, for formats that hold such beside the atoms.
struct FrameNumber {
  std::string_view name;  ///< "potential_energy"
  std::string_view unit;  ///< as H5MD writes it: "kJ mol-1"
  double value;
};

/// Appends frames to a file.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;
  /// Appends the frame of a state; formats that know of bodies write these as well.
  /// @throws Error     if the format cannot hold such a frame, of which nothing is written then
  /// @throws RunError  if the file cannot be written to its end
  virtual void write(const State& state) = 0;
  /// The same with observables, which must be the same ones at each frame; formats that hold none
  /// leave them out.
  virtual void write(const State& state, std::span<const FrameNumber> /*observables*/) {
    write(state);
  }
  /// Appends a frame as another file gave it.
  virtual void write(const Frame& frame) = 0;
  /// Hands all frames to the operating system and to the disk, and tells where the file stands.
  virtual FileMark mark() = 0;
};

/// What is written of a state.
struct FrameChoice {
  MasslessSites massless = MasslessSites::kept;
  bool velocities = true;  ///< where the format has them
};

/// Begins a file; what was there is lost.
/// @throws Error  if the file cannot be written or its ending is none of `writable_formats()`
std::unique_ptr<FrameWriter> create_frames(const std::string& path, const Topology& topology,
                                           const FrameChoice& choice = {});

/// Goes on with a file after the frames of a mark; what was written later is cut off.
/// @throws Error  if the file is shorter than the mark
std::unique_ptr<FrameWriter> continue_frames(const std::string& path, const Topology& topology,
                                             const FileMark& mark, const FrameChoice& choice = {});

/// Whether frames of a run can be written to a file, before it is begun.
/// @throws Error  if its format cannot hold so many atoms, or the coordinates of such a box
void check_fit(const std::string& path, const State& state, const Topology& topology,
               const FrameChoice& choice = {});

/// What the format of a file's ending can hold.
/// @throws Error  if the ending is none of `readable_formats()`
struct FormatTraits {
  bool names;       ///< of atoms
  bool velocities;  ///< of atoms
};
FormatTraits format_traits(const std::string& path);

/// Endings without their dot: "gro", "pdb", "xyz", "xtc", "trr", "dcd", "h5md"; and read alone,
/// LAMMPS data files: "data", "lmp".
std::vector<std::string_view> readable_formats();
std::vector<std::string_view> writable_formats();

/// A start configuration: "w512", which is within the program, or the first frame of a file of any
/// format that names atoms.
Frame read_start(const std::string& name_or_path);

}  // namespace polhode
