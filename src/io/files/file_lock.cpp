// SPDX-License-Identifier: MIT
#include "polhode/io/files/file_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <utility>

#include "base/printable.hpp"
#include "io/files/disk.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::string_view head = "polhode lock: ";

/// A text that identifies this process, such as "process 1234 on host node7 since 2026-11-22
/// 06:31:03 UTC".
std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on host {} since {:%Y-%m-%d %H:%M:%S} UTC", ::getpid(),
                     printable(host.data()), fmt::gmtime(std::time(nullptr)));
}

/// The first 512 bytes of an open file, or all bytes of a shorter file.
std::string text_of(int file) {
  std::array<char, 512> text{};
  const ssize_t length = TEMP_FAILURE_RETRY(::pread(file, text.data(), text.size(), 0));
  return {text.data(), length > 0 ? static_cast<std::size_t>(length) : 0};
}

/// The process that holds a lock, as stated in the lock file; "another process" while the lock file
/// is still empty.
std::string holder(const std::string& text) {
  const auto end = text.find('\n');
  if (!text.starts_with(head) || end == text.npos) return "another process";
  return printable(std::string_view(text).substr(head.size(), end - head.size()));
}

}  // namespace

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  check_name("the output", path_);
  check_folder(path_);
  try {
    do {
      if (file_ >= 0) ::close(file_);
      take();
    } while (!is_at_its_path());  // the owner may have removed the file while it was opened here
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
  const std::string text = std::string(head) + this_process() + "\n";
  // On a full disk the lock still works, but the lock file does not name its owner.
  [[maybe_unused]] const bool written =
      ::ftruncate(file_, 0) == 0 && ::pwrite(file_, text.data(), text.size(), 0) > 0;
}

void FileLock::take() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw Error("the lock file " + cannot_write(path_, errno) + ", or give another output");
  held_ = TEMP_FAILURE_RETRY(::flock(file_, LOCK_EX | LOCK_NB)) == 0;
  const bool others = !held_ && errno == EWOULDBLOCK;
  const std::string text = text_of(file_);
  if (!text.empty() && !text.starts_with(head))
    throw Error(
        fmt::format("'{}' exists but is not a lock file of polhode, and polhode needs this name "
                    "for its lock file; rename the existing file, or give another output",
                    path_));
  if (others)
    throw Error(
        fmt::format("'{}' is locked by {}: two processes would overwrite each other's files; wait "
                    "until that process has ended, or give another output",
                    path_, holder(text)));
}

bool FileLock::is_at_its_path() const {
  struct stat opened {
  }, named{};
  return ::fstat(file_, &opened) == 0 && ::stat(path_.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

FileLock::~FileLock() {
  ::unlink(path_.c_str());  // removed while locked, so that no other lock is removed
  ::close(file_);
}

void HeldFile::hold(const std::string& path) {
  file_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file_ < 0 || TEMP_FAILURE_RETRY(::flock(file_, LOCK_EX | LOCK_NB)) == 0 ||
      errno != EWOULDBLOCK)
    return;
  throw Error(
      fmt::format("another process is writing to '{}', perhaps through a link; wait until that "
                  "process has ended, or replace the link by a copy of the file",
                  path));
}

HeldFile::~HeldFile() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace polhode
