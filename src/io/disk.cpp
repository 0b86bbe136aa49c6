// SPDX-License-Identifier: MIT
#include "polhode/io/disk.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

/// 0, or what went wrong.
int sync(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return error;
}

}  // namespace

fs::path folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void check_folder(const std::string& path) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw Error(fmt::format("there is no folder '{}' for the output '{}'; make it, or name another",
                            folder.string(), path));
  if (::access(folder.c_str(), W_OK) != 0)
    throw Error(
        fmt::format("the folder '{}' takes no new files ({}); name another for the output "
                    "'{}'",
                    folder.string(), std::strerror(errno), path));
}

void sync_file(const std::string& path) {
  if (const int error = sync(path))
    throw RunError(
        fmt::format("'{}' could not be brought to the disk ({})", path, std::strerror(error)));
}

void sync_folder(const std::string& path) { sync(folder_of(path).string()); }

void check_length(const std::string& path, std::uint64_t bytes) {
  std::error_code error;
  const std::uintmax_t length = fs::file_size(path, error);
  if (error)
    throw Error(
        fmt::format("'{}' cannot be gone on with ({}); bring it back, or begin the run "
                    "anew with --force",
                    path, error.message()));
  if (length < bytes)
    throw Error(
        fmt::format("'{}' has {} bytes and had {} when the checkpoint was written: "
                    "what is missing cannot be made up; bring it back, or begin the "
                    "run anew with --force",
                    path, length, bytes));
}

void cut_file(const std::string& path, std::uint64_t bytes) {
  check_length(path, bytes);
  std::error_code error;
  fs::resize_file(path, bytes, error);
  if (error)
    throw Error(fmt::format("'{}' cannot be cut to {} bytes ({}); check its permissions", path,
                            bytes, error.message()));
}

}  // namespace polhode
