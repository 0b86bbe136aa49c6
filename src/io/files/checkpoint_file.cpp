// SPDX-License-Identifier: MIT
#include "io/files/checkpoint_file.hpp"
#include "base/output_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <ostream>
#include <sstream>
#include <utility>

#include "io/files/checksum.hpp"

namespace polhode {
namespace {

constexpr std::string_view magic = "polhode restart\n";
constexpr std::uint64_t format_version = 10;
constexpr std::size_t length_at = magic.size() + sizeof(std::uint64_t);
constexpr std::size_t number = sizeof(std::uint64_t);

std::string contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (in) bytes << in.rdbuf();
  if (!in || !bytes)
    throw DamagedCheckpoint(fmt::format("there is no readable checkpoint '{}'", path));
  return std::move(bytes).str();
}

std::uint64_t number_at(std::string_view bytes, std::size_t at) {
  std::uint64_t n;
  std::memcpy(&n, bytes.data() + at, number);
  return n;
}

}  // namespace

CheckpointWriter::CheckpointWriter(std::ostream& out, const ProgramVersion& program) : out_(out) {
  put(magic.data(), magic.size());
  (*this)(format_version);
  const std::uint64_t length = 0;  // is filled in at the end
  out_.write(reinterpret_cast<const char*>(&length), number);
  (*this)(program.version);
  (*this)(program.instruction_set);
}

void CheckpointWriter::put(const void* bytes, std::size_t n) {
  sum_ = crc64(bytes, n, sum_);
  out_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(n));
}

void CheckpointWriter::operator()(double x) { put(&x, sizeof x); }
void CheckpointWriter::operator()(std::uint64_t n) { put(&n, sizeof n); }
void CheckpointWriter::operator()(bool yes) { (*this)(std::uint64_t{yes}); }
void CheckpointWriter::operator()(const std::string& text) {
  (*this)(std::uint64_t{text.size()});
  put(text.data(), text.size());
}
void CheckpointWriter::operator()(const Vec3<double>& v) {
  for (std::size_t d = 0; d < 3; ++d) (*this)(v[d]);
}
template <class Columns>
void CheckpointWriter::columns(const Columns& values, std::size_t components) {
  (*this)(std::uint64_t{values.size()});
  for (std::size_t k = 0; k < components; ++k) {
    const std::span<const double> component = values.component(k);
    put(component.data(), component.size_bytes());
  }
}
template void CheckpointWriter::columns(const Vec3Column&, std::size_t);
template void CheckpointWriter::columns(const QuaternionColumn&, std::size_t);

void CheckpointWriter::end() {
  out_.write(reinterpret_cast<const char*>(&sum_), number);
  const auto length = static_cast<std::uint64_t>(out_.tellp());
  out_.seekp(length_at);
  out_.write(reinterpret_cast<const char*>(&length), number);
}

CheckpointReader::CheckpointReader(const std::string& path, const ProgramVersion& reader)
    : CheckpointReader(contents(path), path, reader) {}

CheckpointReader::CheckpointReader(std::string bytes, const std::string& path,
                                   const ProgramVersion& reader)
    : bytes_(std::move(bytes)), path_(path), rest_(bytes_) {
  constexpr std::size_t head = length_at + number;
  if (bytes_.size() < head + number || !rest_.starts_with(magic))
    throw DamagedCheckpoint(fmt::format(
        "'{}' is not a checkpoint: the file does not begin like a polhode checkpoint", path_));
  if (const std::uint64_t length = number_at(rest_, length_at); length != rest_.size())
    throw DamagedCheckpoint(fmt::format("the checkpoint '{}' is incomplete: it has {} bytes of {}",
                                        path_, rest_.size(), length));
  const std::size_t sum_at = rest_.size() - number;
  const std::uint64_t sum =
      crc64(rest_.data() + head, sum_at - head, crc64(rest_.data(), length_at));
  if (sum != number_at(rest_, sum_at))
    throw DamagedCheckpoint(
        fmt::format("the checkpoint '{}' is damaged: its checksum is wrong", path_));
  // All versions of the checkpoint format use the same kind of checksum. If the version number
  // differs and the checksum is wrong, the file is therefore damaged.
  if (const std::uint64_t version = number_at(rest_, magic.size()); version != format_version)
    throw OutputError(
        fmt::format("the checkpoint '{}' has format {}, but this program reads format {}; resume "
                    "with the program that wrote the checkpoint, or start over",
                    path_, version, format_version));
  rest_ = rest_.substr(head, sum_at - head);
  ProgramVersion program;
  (*this)(program.version);
  (*this)(program.instruction_set);
  if (program.version != reader.version)
    throw OutputError(fmt::format(
        "the checkpoint '{}' was written by polhode {}, but this program is polhode {}, which "
        "cannot resume the run bit for bit; use the earlier program, or start over",
        path_, program.version, reader.version));
  if (reader.instruction_set != any_instruction_set &&
      program.instruction_set != reader.instruction_set)
    throw Error(
        fmt::format("the checkpoint '{0}' was written with the instruction set {1}, but this run "
                    "uses {2}, whose sums differ in the last digits; set the environment variable "
                    "POLHODE_INSTRUCTION_SET={1}",
                    path_, program.instruction_set, reader.instruction_set));
}

std::string_view CheckpointReader::take(std::size_t n) {
  if (n > rest_.size())
    throw DamagedCheckpoint(fmt::format("the checkpoint '{}' contains too little data", path_));
  const std::string_view taken = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return taken;
}

void CheckpointReader::operator()(double& x) { std::memcpy(&x, take(sizeof x).data(), sizeof x); }
void CheckpointReader::operator()(std::uint64_t& n) { n = number_at(take(number), 0); }
void CheckpointReader::operator()(bool& yes) {
  std::uint64_t n;
  (*this)(n);
  yes = n != 0;
}
void CheckpointReader::operator()(std::string& text) {
  std::uint64_t n;
  (*this)(n);
  text = take(n);
}
void CheckpointReader::operator()(Vec3<double>& v) {
  for (std::size_t d = 0; d < 3; ++d) (*this)(v[d]);
}
template <class Columns>
void CheckpointReader::columns(Columns& values, std::size_t components) {
  std::uint64_t n;
  (*this)(n);
  const std::size_t bytes = n > rest_.size() ? n : n * sizeof(double);  // bytes of a component
  std::string_view all = take(n > rest_.size() ? n : components * bytes);
  values = Columns(n);
  for (std::size_t k = 0; k < components; ++k) {
    std::copy_n(all.data(), bytes, reinterpret_cast<char*>(values.component(k).data()));
    all.remove_prefix(bytes);
  }
}
template void CheckpointReader::columns(Vec3Column&, std::size_t);
template void CheckpointReader::columns(QuaternionColumn&, std::size_t);

void CheckpointReader::end() const {
  if (!rest_.empty())
    throw DamagedCheckpoint(fmt::format("the checkpoint '{}' contains too much data", path_));
}

}  // namespace polhode
