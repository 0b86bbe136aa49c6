// SPDX-License-Identifier: MIT
// Files to whose end frames are appended.
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "format.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// Waits until the disk has all that was handed to the operating system for a file.
bool synced(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool done = ::fsync(file) == 0;
  return ::close(file) == 0 && done;
}

void cut(const std::string& path, std::uint64_t bytes) {
  std::error_code failure;
  const auto length = std::filesystem::file_size(path, failure);
  if (failure)
    throw Error(fmt::format("there is no readable file '{}' to go on with; check its path", path));
  if (length < bytes)
    throw Error(
        fmt::format("'{}' is {} bytes long and was {} bytes long when the run was "
                    "interrupted; it must be the same file: bring it back or start anew",
                    path, length, bytes));
  std::filesystem::resize_file(path, bytes, failure);
}

class StreamWriter : public FrameWriter {
 public:
  StreamWriter(AppendFrame append, std::string path, const Topology& topology,
               const FrameChoice& choice, const FileMark* mark)
      : append_(append), path_(std::move(path)), topology_(topology), choice_(choice) {
    using std::ios;
    if (mark != nullptr) {
      cut(path_, mark->bytes);
      frames_ = mark->frames;
    }
    stream_.open(path_,
                 ios::binary | ios::in | ios::out | (mark != nullptr ? ios::ate : ios::trunc));
    if (!stream_)
      throw Error(
          fmt::format("'{}' cannot be written; check the folder and its permissions", path_));
  }

  void write(const State& state) override { append(view_of(state, topology_, choice_)); }
  void write(const Frame& frame) override { append(view_of(frame, choice_)); }
  FileMark mark() override {
    if (!stream_.flush() || !synced(path_)) refuse();
    return {frames_, static_cast<std::uint64_t>(stream_.tellp())};
  }

 private:
  void append(const FrameView& frame) {
    append_(stream_, frame, frames_);
    if (!stream_.flush()) refuse();
    ++frames_;
  }
  [[noreturn]] void refuse() const {
    throw RunError(fmt::format("'{}' could not be written to the end; is the disk full?", path_));
  }

  AppendFrame append_;
  std::string path_;
  Topology topology_;
  FrameChoice choice_;
  std::fstream stream_;
  std::uint64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<FrameWriter> stream_writer(AppendFrame append, const std::string& path,
                                           const Topology& topology, const FrameChoice& choice,
                                           const FileMark* mark) {
  return std::make_unique<StreamWriter>(append, path, topology, choice, mark);
}

}  // namespace polhode
