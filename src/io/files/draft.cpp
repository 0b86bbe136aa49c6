// SPDX-License-Identifier: MIT
#include "io/files/draft.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <string_view>
#include <utility>

#include "io/files/disk.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::string_view front = "unfinished-";
constexpr std::size_t digits = 8,
                      longer = front.size() + digits + 1;  // added length of a draft's name

/// A temporary file name in the same folder, with the same extension.
std::string name_beside(const std::string& path) {
  static std::random_device random;
  const std::filesystem::path file(path);
  return (file.parent_path() /
          fmt::format("{}{:0{}x}-{}", front, random(), digits, file.filename().string()))
      .string();
}

/// The name that a draft has after it is finished; empty if `name` is not the name of a draft.
std::string_view final_name(std::string_view name) {
  if (!name.starts_with(front) || name.size() <= longer || name[longer - 1] != '-') return {};
  const std::string_view number = name.substr(front.size(), digits);
  return number.find_first_not_of("0123456789abcdef") == number.npos ? name.substr(longer)
                                                                     : std::string_view();
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
  if (file_ < 0) throw Error(cannot_write(path_, errno));
  ::close(std::exchange(file_, -1));  // its writer may create the file again
  has_name_ = true;
}

bool Draft::link(const std::string& name) {
  if (::linkat(AT_FDCWD, draft_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
    return true;
  if (errno != EEXIST) refuse(errno);
  return false;
}

void Draft::finish(const std::string& keep) {
  if (has_name_)
    sync_file(draft_);
  else if (::fsync(file_) != 0)
    refuse(errno);
  std::error_code unknown;
  if (!keep.empty() && std::filesystem::exists(path_, unknown) &&
      std::rename(path_.c_str(), keep.c_str()) != 0)
    refuse(errno);
  if (has_name_ || !link(path_)) replace();
  sync_folder(path_);
}

// The existing file is replaced atomically, so that a complete file exists at all times.
void Draft::replace() {
  if (!has_name_) {
    std::string name;
    do name = name_beside(path_);
    while (!link(name));
    draft_ = name;
    has_name_ = true;
  }
  if (std::rename(draft_.c_str(), path_.c_str()) != 0) refuse(errno);
  has_name_ = false;  // name of the draft
}

void Draft::refuse(int error) const {
  throw RunError(fmt::format("'{}' could not be written completely ({}); {}", path_,
                             std::strerror(error), remedy_of(error)));
}

Draft::~Draft() {
  if (has_name_) ::unlink(draft_.c_str());
  if (file_ >= 0) ::close(file_);
}

void check_length_of_name(const std::string& path) {
  const std::size_t length = std::filesystem::path(path).filename().string().size();
  const long limit = ::pathconf(folder_of(path).c_str(), _PC_NAME_MAX);
  const std::size_t max_length = (limit > 0 ? static_cast<std::size_t>(limit) : 255) - longer;
  if (length > max_length)
    throw Error(
        fmt::format("the file name of the output '{}' has {} bytes; the maximum is {} bytes, since "
                    "the temporary file has a name that is {} bytes longer",
                    path, length, max_length, longer));
}

void remove_drafts(const std::vector<std::string>& files) {
  if (files.empty()) return;
  namespace fs = std::filesystem;
  std::error_code unknown;
  std::vector<std::string> drafts;
  for (fs::directory_iterator entry(folder_of(files.front()), unknown), end;
       !unknown && entry != end; entry.increment(unknown)) {
    const std::string name = entry->path().filename().string();
    const bool is_ours = std::any_of(files.begin(), files.end(), [&](const std::string& file) {
      return final_name(name) == fs::path(file).filename().string();
    });
    if (is_ours && fs::is_regular_file(entry->symlink_status(unknown)))
      drafts.push_back(entry->path().string());
  }
  for (const std::string& draft : drafts) fs::remove(draft, unknown);
}

}  // namespace polhode
