// SPDX-License-Identifier: MIT
// Files to whose end frames are appended.
#include <fmt/core.h>

#include <fstream>
#include <utility>

#include "format.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/disk.hpp"

namespace polhode {
namespace {

class StreamWriter : public FrameWriter {
 public:
  StreamWriter(AppendFrame append, std::string path, const Topology& topology,
               const FrameChoice& choice, const FileMark* mark)
      : append_(append), path_(std::move(path)), topology_(topology), choice_(choice) {
    using std::ios;
    if (mark != nullptr) {
      cut_file(path_, mark->bytes);
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
    if (!stream_.flush()) refuse();
    sync_file(path_);
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
