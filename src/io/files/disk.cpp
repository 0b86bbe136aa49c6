// SPDX-License-Identifier: MIT
#include "io/files/disk.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/output_error.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

/// Syncs a file. Returns 0 on success, and otherwise the errno.
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

std::string remedy_of(int error) {
  if (error == EMFILE) {
    rlimit files{};
    ::getrlimit(RLIMIT_NOFILE, &files);
    return fmt::format(
        "this process may have at most {} files open: raise this limit with 'ulimit -n'",
        files.rlim_cur);
  }
  if (error == ENFILE) return "the whole system has too many files open: end other programs";
  if (error == ENOSPC || error == EDQUOT || error == EFBIG) return "free disk space";
  return "check the folder and its permissions";
}

std::string cannot_write(const std::string& path, int error) {
  return fmt::format("'{}' cannot be written ({}); {}", path, std::strerror(error),
                     remedy_of(error));
}

void check_folder(const std::string& path) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw Error(fmt::format(
        "there is no folder '{}' for the output '{}'; create the folder, or give another output",
        folder.string(), path));
  if (::access(folder.c_str(), W_OK) != 0)
    throw Error(fmt::format(
        "no file can be created in the folder '{}' ({}); give another folder for the output '{}'",
        folder.string(), std::strerror(errno), path));
}

void remove_output(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) throw Error(cannot_write(path, errno));
}

void sync_file(const std::string& path) {
  if (const int error = sync(path))
    throw RunError(fmt::format("'{}' could not be synced to disk ({}); {}", path,
                               std::strerror(error), remedy_of(error)));
}

void sync_folder(const std::string& path) { sync(folder_of(path).string()); }

void check_length(const std::string& path, std::uint64_t bytes) {
  std::error_code error;
  const std::uintmax_t length = fs::file_size(path, error);
  if (error)
    throw OutputError(
        fmt::format("'{}' cannot be opened for appending ({}); restore the file, or start over",
                    path, error.message()));
  if (length < bytes)
    throw OutputError(
        fmt::format("'{}' has {} bytes, but had {} when the checkpoint was written, so data are "
                    "missing; restore the file, or start over",
                    path, length, bytes));
}

void cut_file(const std::string& path, std::uint64_t bytes) {
  check_length(path, bytes);
  std::error_code error;
  fs::resize_file(path, bytes, error);
  if (error)
    throw Error(fmt::format("'{}' cannot be truncated to {} bytes ({}); check its permissions",
                            path, bytes, error.message()));
}

}  // namespace polhode
