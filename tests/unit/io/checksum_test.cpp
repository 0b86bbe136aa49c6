// SPDX-License-Identifier: MIT
#include "io/files/checksum.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string_view>

#include "../errors.hpp"

using namespace polhode;
namespace fs = std::filesystem;

TEST_CASE("CRC-64 has the check value of the XZ format, in one piece or in many") {
  constexpr std::string_view digits = "123456789";
  CHECK(crc64(digits.data(), digits.size()) == 0x995dc9bbdf1939fa);
  CHECK(crc64(nullptr, 0) == 0);
  std::mt19937_64 random(1);
  std::string bytes(1000, 0);
  for (char& c : bytes) c = static_cast<char>(random());
  const std::uint64_t whole = crc64(bytes.data(), bytes.size());
  for (int n = 0; n < 100; ++n) {
    const std::size_t cut = random() % (bytes.size() + 1);
    const std::uint64_t first = crc64(bytes.data(), cut);
    CHECK(crc64(bytes.data() + cut, bytes.size() - cut, first) == whole);
  }
}

TEST_CASE("a changed byte of a file is detected, and bytes after the checked part are not read") {
  const fs::path path = fs::temp_directory_path() / ("polhode-crc-" + std::to_string(::getpid()));
  const std::string file = path.string();
  std::ofstream(file) << "0123456789, and more";
  const std::uint64_t sum = file_crc64(file, 0, 10);
  CHECK(sum == crc64("0123456789", 10));
  CHECK(file_crc64(file, 4, 10, file_crc64(file, 0, 4)) == sum);
  check_crc64(file, 0, 10, sum);
  std::ofstream(file) << "0123456789, and less of it";
  check_crc64(file, 0, 10, sum);
  std::ofstream(file) << "0123456780";
  check_error([&] { check_crc64(file, 0, 10, sum); }, {file.c_str(), "checksum", "start over"});
  std::ofstream(file) << "012345678";
  check_error([&] { check_crc64(file, 0, 10, sum); }, {file.c_str(), "9 bytes", "10"});
  fs::remove(path);
}
