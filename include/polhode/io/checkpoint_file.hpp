// SPDX-License-Identifier: MIT
// Checkpoint files: numbers in their own bits, sealed, so that what is cut short, changed or made
// by another program is known before any of it is used.
//
// A file is, with whole numbers of 64 bits in the byte order of the processor: 16 bytes that name
// the format; its version; the length of the file; version and instruction set of the program that
// wrote it; what was put into it; and a CRC-64 of all but the length.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "polhode/base/column.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// Which program wrote a file. Only the same goes on with the same bits.
struct Maker {
  std::string version;
  std::string target;  ///< instruction set
};

/// A checkpoint that is missing, cut short or changed: an earlier one may serve.
class DamagedCheckpoint : public Error {
  using Error::Error;
};

/// Puts values into a file one after the other, without holding them.
class CheckpointWriter {
 public:
  /// @param out  a stream in which one can go back
  CheckpointWriter(std::ostream& out, const Maker& maker);
  ~CheckpointWriter();
  void operator()(double x);
  void operator()(std::uint64_t n);
  void operator()(bool yes);
  void operator()(const std::string& text);
  void operator()(const Vec3<double>& v);
  void operator()(const Column<double>& column);
  /// Seals the file; nothing may follow.
  void end();

 private:
  void put(const void* bytes, std::size_t n);
  struct Sum;
  std::ostream& out_;
  std::unique_ptr<Sum> sum_;
};

/// Takes the values out again, in the same order.
class CheckpointReader {
 public:
  /// Reads a file whole and looks at its seal.
  /// @throws DamagedCheckpoint  if it is not there, is none of these, cut short or changed
  /// @throws Error              if another program or instruction set wrote it
  CheckpointReader(const std::string& path, const Maker& reader);
  /// The same of bytes that were read from `path`.
  CheckpointReader(std::string bytes, const std::string& path, const Maker& reader);
  void operator()(double& x);
  void operator()(std::uint64_t& n);
  void operator()(bool& yes);
  void operator()(std::string& text);
  void operator()(Vec3<double>& v);
  void operator()(Column<double>& column);
  /// @throws DamagedCheckpoint  unless all was taken
  void end() const;

 private:
  std::string_view take(std::size_t n);
  std::string bytes_, path_;
  std::string_view rest_;
};

}  // namespace polhode
