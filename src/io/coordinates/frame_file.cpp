// SPDX-License-Identifier: MIT
#include "polhode/io/coordinates/frame_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <tuple>
#include <utility>

#include "base/suggest.hpp"
#include "io/coordinates/gro.hpp"
#include "io/files/checksum.hpp"
#include "io/files/embedded.hpp"
#include "io/files/text_file.hpp"
#include "io/formats/format.hpp"
#include "io/topology/lammps_data.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace polhode {
namespace {

template <AppendFrame* append, std::uint64_t head = 0>
std::unique_ptr<FrameWriter> append_writer(const std::string& path, const Topology& topology,
                                           const FrameChoice& choice, const FileMark* mark) {
  return stream_writer(append, head, path, topology, choice, mark);
}

template <std::uint64_t head>
void checked_bytes(const std::string& path, const FileMark& mark) {
  check_crc64(path, std::min(head, mark.bytes), mark.bytes, mark.checksum);
}

// clang-format off
constexpr std::array formats = {
    //     extension  names  velocities
    Format{"gro",  true,  true,  gro_reader,  append_writer<append_gro>, checked_bytes<0>},
    Format{"pdb",  true,  false, pdb_reader,  append_writer<append_pdb>, checked_bytes<0>, nullptr, pdb_limits},
    Format{"xyz",  true,  true,  xyz_reader,  append_writer<append_xyz>, checked_bytes<0>},
    Format{"xtc",  false, false, xtc_reader,  append_writer<append_xtc>, checked_bytes<0>, nullptr, xtc_limits},
    Format{"trr",  false, true,  trr_reader,  append_writer<append_trr>, checked_bytes<0>, nullptr, trr_limits},
    Format{"dcd",  false, false, dcd_reader,  append_writer<append_dcd, dcd_count_end>, checked_bytes<dcd_count_end>, nullptr, dcd_limits},
    Format{"h5md", false, true,  h5md_reader, h5md_writer, check_h5md, open_h5md, h5md_limits},
    Format{"data", true,  true,  lammps_data_reader, nullptr, nullptr},
    Format{"lmp",  true,  true,  lammps_data_reader, nullptr, nullptr},
    Format{"dump", true,  true,  lammps_dump_reader, nullptr, nullptr, nullptr, {}, true},
    Format{"lammpstrj", true, true, lammps_dump_reader, nullptr, nullptr, nullptr, {}, true},
};
// clang-format on

const Format& format_named(std::string_view extension, const std::string& file) {
  if (extension == "h5md" && !h5md_missing.empty()) throw Error(std::string(h5md_missing), file);
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const Format& f) { return f.extension == extension; });
  if (format != formats.end()) return *format;
  std::vector<std::string> known;
  for (const Format& f : formats) known.emplace_back(f.extension);
  const auto near = nearest_name(extension, known);
  throw Error(fmt::format(
      "the extension of '{}' is unknown{}; the known extensions are: {} (the name of a LAMMPS data "
      "file must end in .data or .lmp)",
      file, near ? fmt::format(" (did you mean '{}'?)", *near) : "", join_names(known)));
}

const Format& writable_format(const std::string& path) {
  const Format& format = format_of(path);
  if (format.write != nullptr) return format;
  const auto written = writable_formats();
  throw Error(fmt::format(
      "files with the extension '.{}' can only be read; extensions of files that can be written: "
      "{}",
      format.extension, join_names(std::vector<std::string>(written.begin(), written.end()))));
}

// A writer that checks, before writing a frame, whether the format can store it.
class FittingWriter : public FrameWriter {
 public:
  FittingWriter(std::unique_ptr<FrameWriter> writer, const Format& format, const Topology& topology,
                const FrameChoice& choice)
      : writer_(std::move(writer)),
        fit_(format.extension, format.limits),
        topology_(topology),
        choice_(choice) {}
  void write(const State& state) override { write(state, {}); }
  void write(const State& state, std::span<const FrameNumber> observables) override {
    fit_.check(extent_of(state, topology_, choice_));
    writer_->write(state, observables);
  }
  void write(const Frame& frame) override {
    fit_.check(extent_of(frame));
    writer_->write(frame);
  }
  FileMark mark() override { return writer_->mark(); }

 private:
  std::unique_ptr<FrameWriter> writer_;
  FrameFit fit_;
  Topology topology_;
  FrameChoice choice_;
};

std::unique_ptr<FrameWriter> writer(const std::string& path, const Topology& topology,
                                    const FrameChoice& choice, const FileMark* mark) {
  const Format& format = writable_format(path);
  return std::make_unique<FittingWriter>(format.write(path, topology, choice, mark), format,
                                         topology, choice);
}

// Adds the atom kinds and residues of another file to the frames of a format without atom names.
class NamedReader : public FrameReader {
 public:
  NamedReader(std::unique_ptr<FrameReader> frames, const Frame& names)
      : frames_(std::move(frames)), kinds_(names.kinds), source_(names.source) {
    for (const Atom& atom : names.atoms) atoms_.push_back({atom.kind, atom.residue});
  }
  bool next(Frame& frame) override {
    if (!frames_->next(frame)) return false;
    if (frame.atoms.size() != atoms_.size())
      throw Error(fmt::format("the frame at {:g} ps has {} atoms, but the file with the atom "
                              "names, '{}', has {}; both numbers must be equal",
                              frame.time, frame.atoms.size(), source_, atoms_.size()),
                  frame.source);
    frame.kinds = kinds_;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      std::tie(frame.atoms[i].kind, frame.atoms[i].residue) = atoms_[i];
    return true;
  }
  double fraction_read() override { return frames_->fraction_read(); }

 private:
  std::unique_ptr<FrameReader> frames_;
  std::vector<AtomKind> kinds_;
  std::vector<std::pair<std::uint32_t, int>> atoms_;  // kind and residue of each atom
  std::string source_;
};

std::unique_ptr<FrameReader> with_names(std::unique_ptr<FrameReader> frames, const Format& format,
                                        const Frame* names) {
  if (names == nullptr || (format.has_names && !format.may_lack_names)) return frames;
  return std::make_unique<NamedReader>(std::move(frames), *names);
}

// A reader together with its input stream.
class FileReader : public FrameReader {
 public:
  /// Opens a file for a reader.
  /// @param read  function that makes the reader of the stream
  template <class Read>
  FileReader(const std::string& path, const Read& read)
      : stream_(open_text_file(path)), frames_(read(stream_, path)) {
    std::error_code unknown;
    bytes_ = static_cast<double>(std::filesystem::file_size(path, unknown));
  }
  bool next(Frame& frame) override { return frames_->next(frame); }
  double fraction_read() override {
    return static_cast<double>(std::max<std::streamoff>(0, stream_.tellg())) / bytes_;
  }

 private:
  double bytes_;
  std::ifstream stream_;
  std::unique_ptr<FrameReader> frames_;
};

}  // namespace

const Format& format_of(const std::string& path) {
  const auto point = path.rfind('.');
  return format_named(point == path.npos ? "" : std::string_view(path).substr(point + 1), path);
}

std::unique_ptr<FrameReader> open_frames(const std::string& path, const Frame* names) {
  const Format& format = format_of(path);
  open_text_file(path);  // throws a more precise error if the file cannot be opened
  std::error_code unknown;
  if (std::filesystem::is_regular_file(path, unknown) && std::filesystem::is_empty(path, unknown))
    throw Error(
        "the file is empty; it must contain at least one frame: give a file that was written "
        "completely",
        path + ":1");
  if (format.open != nullptr) return with_names(format.open(path), format, names);
  return with_names(std::make_unique<FileReader>(path, format.read), format, names);
}

std::unique_ptr<FrameReader> open_particle_frames(const std::string& path,
                                                  const Topology& topology) {
  if (format_of(path).read != lammps_dump_reader)
    throw Error(fmt::format(
        "'{}' is not a LAMMPS dump file of particles; its extension must be .dump or .lammpstrj",
        path));
  return std::make_unique<FileReader>(path, [&](std::istream& in, const std::string& file) {
    return lammps_particle_reader(in, file, topology);
  });
}

std::unique_ptr<FrameReader> read_frames(std::istream& in, std::string_view format,
                                         const std::string& file, const Frame* names) {
  const Format& f = format_named(format, file);
  return with_names(f.read(in, file), f, names);
}

std::unique_ptr<FrameWriter> create_frames(const std::string& path, const Topology& topology,
                                           const FrameChoice& choice) {
  return writer(path, topology, choice, nullptr);
}

void check_frames(const std::string& path, const FileMark& mark) {
  writable_format(path).check(path, mark);
}

std::unique_ptr<FrameWriter> resume_frames(const std::string& path, const Topology& topology,
                                           const FileMark& mark, const FrameChoice& choice) {
  return writer(path, topology, choice, &mark);
}

void check_fit(const std::string& path, const State& state, const Topology& topology,
               const FrameChoice& choice) {
  const Format& format = writable_format(path);
  at_place(path, [&] {
    FrameFit(format.extension, format.limits).check(extent_of(state, topology, choice));
  });
}

FormatTraits format_traits(const std::string& path) {
  const Format& format = format_of(path);
  return {format.has_names, format.has_velocities};
}

std::vector<std::string_view> writable_formats() {
  std::vector<std::string_view> extensions;
  for (const Format& format : formats)
    if (format.write != nullptr) extensions.push_back(format.extension);
  return extensions;
}

Frame read_start(const std::string& name_or_path) {
  const std::string path = "start/" + name_or_path + ".gro";
  if (const auto text = embedded_text(path)) return parse_gro(*text, path);
  open_text_file(name_or_path);  // throws a more precise error if the file cannot be opened
  if (!format_of(name_or_path).has_names)
    throw Error(
        fmt::format("the format of '{0}' has no atom names, but an initial configuration needs "
                    "them; convert the file to GRO, with the atom names of another file",
                    name_or_path));
  if (is_data_file(name_or_path)) return frame_of(read_lammps_data(name_or_path));
  Frame frame;
  if (!open_frames(name_or_path)->next(frame))
    throw Error("the file ends before its first frame", name_or_path + ":1");
  if (!frame.atoms.empty() && frame.kind(frame.atoms.front()).name.empty())
    throw Error(
        "the dump file has no column 'element', but an initial configuration needs one; write the "
        "file with 'dump ID group custom N FILE id mol element x y z vx vy vz' and 'dump_modify ID "
        "element ...'",
        name_or_path);
  return frame;
}

}  // namespace polhode
