// SPDX-License-Identifier: MIT
#include "polhode/io/draft.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include "polhode/base/error.hpp"
#include "polhode/io/disk.hpp"

namespace polhode {
namespace {

/// A temporary name in the same folder, with the same extension.
std::string name_beside(const std::string& path) {
  static std::random_device random;
  const std::filesystem::path file(path);
  return (file.parent_path() /
          fmt::format("unfinished-{:08x}-{}", random(), file.filename().string()))
      .string();
}

}  // namespace

Draft::Draft(const std::string& path, Name name) : path_(path) {
  if (name == Name::none) {
    file_ = ::open(folder_of(path).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    draft_ = fmt::format("/proc/self/fd/{}", file_);
    if (file_ >= 0 && ::access(draft_.c_str(), W_OK) == 0) return;
    if (file_ >= 0) ::close(file_);
  }
  create_named();
}

std::string Draft::with_final_name(std::string message) const {
  if (const auto at = message.find(draft_); at != message.npos)
    message.replace(at, draft_.size(), path_);
  return message;
}

void Draft::create_named() {
  do {
    draft_ = name_beside(path_);
    file_ = ::open(draft_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0)
    throw Error(fmt::format("'{}' cannot be written ({}); give another output, or free disk space",
                            path_, std::strerror(errno)));
  has_name_ = true;
}

bool Draft::link(const std::string& name) {
  if (::linkat(AT_FDCWD, draft_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
    return true;
  if (errno != EEXIST) refuse(errno);
  return false;
}

void Draft::finish(const std::string& keep) {
  if (::fsync(file_) != 0) refuse(errno);
  std::error_code unknown;
  if (!keep.empty() && std::filesystem::exists(path_, unknown) &&
      std::rename(path_.c_str(), keep.c_str()) != 0)
    refuse(errno);
  if (has_name_ || !link(path_)) replace();
  sync_folder(path_);
}

// The old file is replaced atomically: at no time is there no file.
void Draft::replace() {
  if (!has_name_) {
    std::string name;
    do name = name_beside(path_);
    while (!link(name));
    draft_ = name;
    has_name_ = true;
  }
  if (std::rename(draft_.c_str(), path_.c_str()) != 0) refuse(errno);
  has_name_ = false;  // the draft's
}

void Draft::refuse(int error) const {
  throw RunError(fmt::format("'{}' could not be written completely ({}); free disk space", path_,
                             std::strerror(error)));
}

Draft::~Draft() {
  if (has_name_) ::unlink(draft_.c_str());
  ::close(file_);
}

}  // namespace polhode
