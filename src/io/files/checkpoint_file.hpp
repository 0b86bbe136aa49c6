// SPDX-License-Identifier: MIT
// Checkpoint files: numbers in binary, with a checksum. A file that is truncated, altered or
// written by another program is recognized before its data are used.
//
// A file begins with 16 bytes that identify the format, the version of the format, and the length
// of the file. The file continues with program version, instruction set, contents, and a CRC-64 of
// everything except the length. Integers have 64 bits in the byte order of the processor.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "polhode/base/column.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// The version of the program that wrote a file. Only the same version of the program resumes a run
/// bitwise identically.
struct ProgramVersion {
  std::string version;
  std::string instruction_set;
};

/// Represents any instruction set, for readers that do not need bitwise identical results.
inline constexpr auto any_instruction_set = "any";

/// An error for a checkpoint that is missing, truncated or altered; an earlier checkpoint may be
/// usable.
class DamagedCheckpoint : public Error {
  using Error::Error;
};

/// Writes the values of a checkpoint in sequence, without buffering all values.
class CheckpointWriter {
 public:
  /// Constructs the writer.
  /// @param out  seekable stream
  CheckpointWriter(std::ostream& out, const ProgramVersion& program);
  void operator()(double x);
  void operator()(std::uint64_t n);
  void operator()(bool yes);
  void operator()(const std::string& text);
  void operator()(const Vec3<double>& v);
  void operator()(const Vec3Column& vectors) { columns(vectors, 3); }
  void operator()(const QuaternionColumn& orientations) { columns(orientations, 4); }
  /// Writes the length and the checksum; nothing may be written afterwards.
  void end();

 private:
  template <class Columns>
  void columns(const Columns& values, std::size_t components);
  void put(const void* bytes, std::size_t n);
  std::ostream& out_;
  std::uint64_t sum_ = 0;
};

/// Reads the values of a checkpoint in the order in which they were written.
class CheckpointReader {
 public:
  /// Reads the whole file and verifies its checksum.
  /// @throws DamagedCheckpoint  if the file is missing, not a checkpoint, truncated or altered
  /// @throws Error              if another program or instruction set wrote the file
  CheckpointReader(const std::string& path, const ProgramVersion& reader);
  /// Reads a checkpoint from bytes that were already read from the file `path`, and verifies their
  /// checksum.
  CheckpointReader(std::string bytes, const std::string& path, const ProgramVersion& reader);
  void operator()(double& x);
  void operator()(std::uint64_t& n);
  void operator()(bool& yes);
  void operator()(std::string& text);
  void operator()(Vec3<double>& v);
  void operator()(Vec3Column& vectors) { columns(vectors, 3); }
  void operator()(QuaternionColumn& orientations) { columns(orientations, 4); }
  /// Checks that the reader is at the end of the file.
  /// @throws DamagedCheckpoint  if data remain to be read
  void end() const;

 private:
  template <class Columns>
  void columns(Columns& values, std::size_t components);
  std::string_view take(std::size_t n);
  std::string bytes_, path_;
  std::string_view rest_;
};

}  // namespace polhode
