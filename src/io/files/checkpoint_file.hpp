// SPDX-License-Identifier: MIT
// Checkpoint files: numbers in binary, with a checksum, so that a file that is truncated, altered
// or written by another program is recognized before any of it is used.
//
// A file consists of, with 64-bit integers in the byte order of the processor: 16 bytes that
// identify the format; its version; the length of the file; version and instruction set of the
// program that wrote it; the contents; and a CRC-64 of everything but the length.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "polhode/base/column.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// The program that wrote a file. Only the same program continues bitwise identically.
struct ProgramVersion {
  std::string version;
  std::string instruction_set;
};

/// In place of an instruction set: a reader that does not resume bit for bit accepts each.
inline constexpr auto any_instruction_set = "any";

/// A checkpoint that is missing, truncated or altered; an earlier one may be usable.
class DamagedCheckpoint : public Error {
  using Error::Error;
};

/// Writes values to a file one after the other, without buffering them all.
class CheckpointWriter {
 public:
  /// @param out  a seekable stream
  CheckpointWriter(std::ostream& out, const ProgramVersion& program);
  void operator()(double x);
  void operator()(std::uint64_t n);
  void operator()(bool yes);
  void operator()(const std::string& text);
  void operator()(const Vec3<double>& v);
  void operator()(const Vec3Column& vectors) { columns(vectors, 3); }
  void operator()(const QuaternionColumn& orientations) { columns(orientations, 4); }
  /// Writes length and checksum; nothing may follow.
  void end();

 private:
  template <class Columns>
  void columns(const Columns& values, std::size_t components);
  void put(const void* bytes, std::size_t n);
  std::ostream& out_;
  std::uint64_t sum_ = 0;
};

/// Reads the values back in the same order.
class CheckpointReader {
 public:
  /// Reads the whole file and verifies its checksum.
  /// @throws DamagedCheckpoint  if it is missing, not a checkpoint, truncated or altered
  /// @throws Error              if it was written by another program or instruction set
  CheckpointReader(const std::string& path, const ProgramVersion& reader);
  /// The same for bytes that were read from `path`.
  CheckpointReader(std::string bytes, const std::string& path, const ProgramVersion& reader);
  void operator()(double& x);
  void operator()(std::uint64_t& n);
  void operator()(bool& yes);
  void operator()(std::string& text);
  void operator()(Vec3<double>& v);
  void operator()(Vec3Column& vectors) { columns(vectors, 3); }
  void operator()(QuaternionColumn& orientations) { columns(orientations, 4); }
  /// @throws DamagedCheckpoint  unless everything has been read
  void end() const;

 private:
  template <class Columns>
  void columns(Columns& values, std::size_t components);
  std::string_view take(std::size_t n);
  std::string bytes_, path_;
  std::string_view rest_;
};

}  // namespace polhode
