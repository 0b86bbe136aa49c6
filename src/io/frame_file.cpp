// SPDX-License-Identifier: MIT
#include "polhode/io/frame_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "formats/format.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "text_file.hpp"

namespace polhode {
namespace {

template <AppendFrame append>
std::unique_ptr<FrameWriter> appended(const std::string& path, const Topology& topology,
                                      const FrameChoice& choice, const FileMark* mark) {
  return stream_writer(append, path, topology, choice, mark);
}

// clang-format off
constexpr std::array formats = {
    //     ending  names  velocities
    Format{"gro",  true,  true,  gro_reader, appended<append_gro>},
    Format{"xyz",  true,  true,  xyz_reader, appended<append_xyz>},
};
// clang-format on

const Format& format_named(std::string_view ending, const std::string& file) {
  const auto format = std::ranges::find(formats, ending, &Format::ending);
  if (format != formats.end()) return *format;
  std::vector<std::string> known;
  for (const Format& f : formats) known.emplace_back(f.ending);
  throw Error(fmt::format("'{}' ends in none of the formats that are known{}; there are: {}", file,
                          did_you_mean(std::string(ending), known), listed(known)));
}

// Kinds and residues of atoms, from another file.
class Names {
 public:
  explicit Names(const Frame& frame) : kinds_(frame.kinds), source_(frame.source) {
    for (const Atom& atom : frame.atoms) atoms_.push_back({atom.kind, atom.residue});
  }
  void give(Frame& frame) const {
    if (frame.atoms.size() != atoms_.size())
      throw Error(fmt::format("the frame at {:g} ps has {} atoms and '{}', which names them, has "
                              "{}; it must have as many",
                              frame.time, frame.atoms.size(), source_, atoms_.size()),
                  frame.source);
    frame.kinds = kinds_;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      std::tie(frame.atoms[i].kind, frame.atoms[i].residue) = atoms_[i];
  }

 private:
  std::vector<AtomKind> kinds_;
  std::vector<std::pair<std::uint32_t, int>> atoms_;  // kind and residue
  std::string source_;
};

// Frames of a stream, named where the format does not.
class NamedReader : public FrameReader {
 public:
  NamedReader(std::istream& in, const Format& format, const std::string& file, const Frame* names)
      : frames_(format.read(in, file)) {
    if (names != nullptr && !format.has_names) names_.emplace(*names);
  }
  bool next(Frame& frame) override {
    if (!frames_->next(frame)) return false;
    if (names_) names_->give(frame);
    return true;
  }

 private:
  std::unique_ptr<FrameReader> frames_;
  std::optional<Names> names_;
};

// The same, with the file.
class FileReader : public FrameReader {
 public:
  FileReader(const std::string& path, const Frame* names)
      : stream_(opened(path)), frames_(stream_, format_of(path), path, names) {}
  bool next(Frame& frame) override { return frames_.next(frame); }

 private:
  std::ifstream stream_;
  NamedReader frames_;
};

}  // namespace

const Format& format_of(const std::string& path) {
  const auto point = path.rfind('.');
  return format_named(point == path.npos ? "" : std::string_view(path).substr(point + 1), path);
}

std::unique_ptr<FrameReader> open_frames(const std::string& path, const Frame* names) {
  format_of(path);  // refuses before the file is looked for
  return std::make_unique<FileReader>(path, names);
}

std::unique_ptr<FrameReader> read_frames(std::istream& in, std::string_view format,
                                         const std::string& file, const Frame* names) {
  return std::make_unique<NamedReader>(in, format_named(format, file), file, names);
}

std::unique_ptr<FrameWriter> create_frames(const std::string& path, const Topology& topology,
                                           const FrameChoice& choice) {
  return format_of(path).write(path, topology, choice, nullptr);
}

std::unique_ptr<FrameWriter> continue_frames(const std::string& path, const Topology& topology,
                                             const FileMark& mark, const FrameChoice& choice) {
  return format_of(path).write(path, topology, choice, &mark);
}

std::vector<std::string_view> readable_formats() {
  std::vector<std::string_view> endings;
  for (const Format& format : formats) endings.push_back(format.ending);
  return endings;
}

std::vector<std::string_view> writable_formats() { return readable_formats(); }

}  // namespace polhode
