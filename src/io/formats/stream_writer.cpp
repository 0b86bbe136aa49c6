// SPDX-License-Identifier: MIT
// Files to which frames are appended.
#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <utility>

#include "format.hpp"
#include "io/files/checksum.hpp"
#include "io/files/disk.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/files/file_lock.hpp"

namespace polhode {
namespace {

class StreamWriter : public FrameWriter {
 public:
  StreamWriter(AppendFrame* append, std::uint64_t head, std::string path, const Topology& topology,
               const FrameChoice& choice, const FileMark* mark)
      : append_(append), head_(head), path_(std::move(path)), topology_(topology), choice_(choice) {
    using std::ios;
    if (mark == nullptr) {
      remove_output(path_);
    } else {
      held_.hold(path_);
      cut_file(path_, mark->bytes);
      frames_ = mark->frames;
      summed_ = mark->bytes;
      checksum_ = mark->checksum;
    }
    stream_.open(path_,
                 ios::binary | ios::in | ios::out | (mark != nullptr ? ios::ate : ios::trunc));
    if (!stream_) throw Error(cannot_write(path_, errno));
    if (mark == nullptr) held_.hold(path_);
  }

  void write(const State& state) override { append(view_of(state, topology_, choice_)); }
  void write(const Frame& frame) override { append(view_of(frame, choice_)); }
  FileMark mark() override {
    if (!stream_.flush()) refuse();
    sync_file(path_);
    const auto bytes = static_cast<std::uint64_t>(stream_.tellp());
    const std::uint64_t from = std::min(std::max(summed_, head_), bytes);
    checksum_ = file_crc64(path_, from, bytes, checksum_);
    summed_ = bytes;
    return {frames_, bytes, checksum_};
  }

 private:
  void append(const FrameView& frame) {
    append_(stream_, frame, frames_);
    if (!stream_.flush()) refuse();
    ++frames_;
  }
  [[noreturn]] void refuse() const {
    throw RunError(fmt::format("'{}' could not be written completely; is the disk full?", path_));
  }

  AppendFrame* append_;
  std::uint64_t head_;
  std::string path_;
  Topology topology_;
  FrameChoice choice_;
  HeldFile held_;
  std::fstream stream_;
  std::uint64_t frames_ = 0;
  std::uint64_t summed_ = 0, checksum_ = 0;  // bytes until the last mark and their checksum
};

}  // namespace

std::unique_ptr<FrameWriter> stream_writer(AppendFrame* append, std::uint64_t head,
                                           const std::string& path, const Topology& topology,
                                           const FrameChoice& choice, const FileMark* mark) {
  return std::make_unique<StreamWriter>(append, head, path, topology, choice, mark);
}

}  // namespace polhode
