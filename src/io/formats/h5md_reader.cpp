// SPDX-License-Identifier: MIT
// H5MD files [debuyl2014] of this and of other programs: positions, velocities and box of the first
// group of particles.
#include <fcntl.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <istream>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>

#include "format.hpp"
#include "h5md_moments.hpp"
#include "hdf5.hpp"
#include "io/settings/quantity.hpp"
#include "own_process.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

using hdf5::Handle;

constexpr std::size_t max_texts = 3;           // of an attribute: one for each direction
constexpr std::size_t max_text_length = 1024;  // maximum length in bytes

// Each text is followed by a zero byte. All texts together are shorter than the buffer of a pipe.
void read_texts_into(int pipe, hid_t attribute, hid_t type, std::size_t count) {
  std::array<char*, max_texts> texts{};
  if (H5Aread(attribute, type, texts.data()) < 0) throw std::runtime_error("no texts");
  std::string all;
  for (std::size_t k = 0; k < count; ++k) {
    if (texts[k] == nullptr) throw std::runtime_error("no text");
    all.append(texts[k], ::strnlen(texts[k], max_text_length)).push_back('\0');
  }
  if (::write(pipe, all.data(), all.size()) != static_cast<ssize_t>(all.size()))
    throw std::runtime_error("no room");
}

// The `count` strings of variable length of an attribute, which most programs use for units. The
// result is empty if the strings cannot be read. The strings are read in a separate process,
// because the HDF5 library (1.10) trusts the lengths in the file. A damaged file can make the HDF5
// library write out of bounds or loop forever.
std::vector<std::string> variable_texts(hid_t attribute, hid_t type, std::size_t count) {
  std::array<int, 2> pipe{};
  if (count > max_texts || ::pipe2(pipe.data(), O_CLOEXEC) != 0) return {};
  const bool done =
      done_in_own_process([&] { read_texts_into(pipe[1], attribute, type, count); }, 1);
  ::close(pipe[1]);
  std::string all(max_texts * (max_text_length + 1), '\0');
  const ssize_t length = TEMP_FAILURE_RETRY(::read(pipe[0], all.data(), all.size()));
  ::close(pipe[0]);
  if (!done || length < 0) return {};
  std::vector<std::string> texts;
  for (std::size_t k = 0, at = 0; k < count; ++k, at += texts.back().size() + 1)
    texts.emplace_back(all.c_str() + at);
  return texts;
}

// An H5MD element with a value at each step or time, or with a single constant value.
struct ReadSeries {
  Handle values;
  std::vector<hsize_t> extents;
  bool changes = false;
  double unit = 1;
  struct Pairing {  // The pairing of positions with values that have separate steps or times.
    Moments own, of_positions;
  };
  std::optional<Pairing> pairing;

  // The index of the value at the step or time of a frame of positions, if such a value exists.
  std::optional<hsize_t> place(hsize_t position) const {
    if (!changes) return 0;
    if (!pairing) return position;
    const auto found = pairing->own.find(pairing->of_positions.at(position));
    if (!found || *found >= extents[0]) return std::nullopt;
    return *found;
  }
};

class H5mdReader : public FrameReader {
 public:
  // Opens a file, or reads it from its bytes.
  H5mdReader(std::string file, const std::vector<char>* bytes) : name_(std::move(file)) {
    hdf5::be_quiet();
    if (bytes != nullptr)
      open_image(*bytes);
    else
      open_file();
    if (!file_.is_open()) refuse("the file is not HDF5, or it is damaged; give an H5MD file");
    at_place(name_, [&] { find_particles(); });
  }

  bool next(Frame& frame) override {
    if (number_ == frames_) return false;
    frame.source = name_;
    frame.title.clear();
    frame.kinds = kinds_;
    frame.time = time_at(number_);
    frame.box = box_at(number_);
    frame.atoms.assign(atoms_.begin(), atoms_.end());
    take(position_, number_, values_);
    for (std::size_t i = 0; i < atoms_.size(); ++i) frame.atoms[i].r = vector(i, position_.unit);
    const auto moving = velocity_ ? velocity_->place(number_) : std::nullopt;
    frame.has_velocities = moving.has_value();
    if (moving) {
      take(*velocity_, *moving, values_);
      for (std::size_t i = 0; i < atoms_.size(); ++i) frame.atoms[i].v = vector(i, velocity_->unit);
    }
    ++number_;
    return true;
  }
  double fraction_read() override {
    return static_cast<double>(number_) / static_cast<double>(frames_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw Error(what, name_); }

  void open_image(const std::vector<char>& bytes) {
    bytes_ = bytes.size();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_core(access, 1 << 16, false);
    // The HDF5 library copies the bytes, although its interface declares the bytes as mutable.
    H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size());
    file_ = {H5Fopen("image", H5F_ACC_RDONLY, access), H5Fclose};
  }
  void open_file() {
    std::error_code unknown;
    bytes_ = std::filesystem::file_size(name_, unknown);
    const Handle access = hdf5::reading_access();
    file_ = {H5Fopen(name_.c_str(), H5F_ACC_RDONLY, access), H5Fclose};
    if (!file_.is_open())  // the file is being written, or its program was killed
      file_ = {H5Fopen(name_.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access), H5Fclose};
  }

  void find_particles() {
    if (!hdf5::has(file_, "particles"))
      refuse("there is no group 'particles'; an H5MD file must have one");
    const Handle particles = hdf5::group(file_, "particles");
    H5G_info_t info{};
    H5Gget_info(particles, &info);
    for (hsize_t k = 0; k < info.nlinks && root_.empty(); ++k) {
      std::array<char, 256> name{};
      if (H5Lget_name_by_idx(particles, ".", H5_INDEX_NAME, H5_ITER_INC, k, name.data(),
                             name.size(), H5P_DEFAULT) < 0)
        break;
      const std::string root = std::string("particles/") + name.data();
      if (hdf5::has(file_, root + std::string("/") + "position/value")) root_ = root + '/';
    }
    if (root_.empty())
      refuse(
          "no group below 'particles' has the dataset 'position/value'; an H5MD trajectory must "
          "have one");
    position_ = series("position", {Dimension::length});
    if (position_.extents.size() != 3 || position_.extents[2] != 3)
      refuse("'position/value' must have three dimensions: frames, atoms and 3");
    frames_ = position_.extents[0];
    const hsize_t atoms = position_.extents[1];
    if (atoms > bytes_)
      refuse(
          fmt::format("'position/value' has {} atoms, but their positions do not fit into the {} "
                      "bytes of the file",
                      atoms, bytes_));
    if (hdf5::has(file_, root_ + "velocity/value")) {
      velocity_ = series("velocity", {Dimension::length, Dimension::time});
      if (velocity_->extents.size() != 3 || velocity_->extents[1] != atoms ||
          velocity_->extents[2] != 3)
        refuse("'velocity/value' must have the dimensions of 'position/value'");
      pair(*velocity_, "velocity");
    }
    find_box();
    find_times();
    name_atoms(static_cast<std::size_t>(atoms));
  }

  // Finds the value of an element for each frame of positions.
  void pair(ReadSeries& series, const std::string& element) {
    for (const char* kind : {"/step", "/time"}) {
      const std::string own = element + kind, of_positions = std::string("position") + kind;
      if (!hdf5::has(file_, root_ + own) || !hdf5::has(file_, root_ + of_positions)) continue;
      ReadSeries::Pairing pairing{moments(own), moments(of_positions)};
      if (pairing.of_positions.is_list())
        frames_ = std::min<hsize_t>(frames_, pairing.of_positions.size());
      if (pairing.own == pairing.of_positions)
        frames_ = std::min(frames_, series.extents[0]);  // the file may be growing
      else
        series.pairing = std::move(pairing);
      return;
    }
    if (series.extents[0] != frames_)
      refuse(
          fmt::format("'{}' has {} frames, but 'position' has {}; both must have 'step' or 'time', "
                      "so that their frames can be matched",
                      element, series.extents[0], frames_));
  }

  Moments moments(const std::string& name) const {
    const Handle numbers = hdf5::dataset(file_, root_ + name);
    if (!numbers.is_open()) refuse(fmt::format("'{}' cannot be read; it must be a dataset", name));
    check_numbers(numbers, name);
    return {numbers, name};
  }

  // The values of an element of the group, with their unit.
  ReadSeries series(const std::string& element, std::vector<Dimension> dimensions) const {
    ReadSeries found;
    const std::string place = root_ + element;
    found.changes = hdf5::has(file_, place + "/value");
    found.values = hdf5::dataset(file_, found.changes ? place + "/value" : place);
    if (!found.values.is_open())
      refuse(fmt::format("'{}' cannot be read; it must be a dataset", place));
    found.extents = hdf5::extents(found.values);
    check_numbers(found.values, place);
    found.unit = unit_of(found.values, element, dimensions);
    return found;
  }

  // Reads numbers, at most as many as the size of the file allows. The limit is needed because the
  // HDF5 library allocates whole chunks, and returns fill values for numbers that are not in the
  // file.
  void check_numbers(hid_t values, const std::string& place) const {
    const Handle type(H5Dget_type(values), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_FLOAT && kind != H5T_INTEGER)
      refuse(fmt::format("'{}' contains no numbers; it must contain at least one", place));
    const auto check_size = [&](const char* what, std::span<const hsize_t> extents) {
      double size = static_cast<double>(H5Tget_size(type));
      for (const hsize_t extent : extents) size *= static_cast<double>(extent);
      constexpr double deflated = 1032;  // largest expansion of a byte by deflate
      if (size > deflated * static_cast<double>(bytes_))
        refuse(fmt::format("{}'{}' is {:.3g} bytes long, more than the {} bytes of the file", what,
                           place, size, bytes_));
    };
    check_size("", hdf5::extents(values));
    const Handle properties(H5Dget_create_plist(values), H5Pclose);
    if (H5Pget_layout(properties) != H5D_CHUNKED) return;
    std::array<hsize_t, H5S_MAX_RANK> chunk{};
    const int rank = H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
    check_size("a chunk of ", std::span(chunk).first(static_cast<std::size_t>(std::max(0, rank))));
  }

  // The texts of an attribute, if it exists and can be read.
  std::vector<std::string> text_attribute(hid_t of, const char* name) const {
    if (H5Aexists(of, name) <= 0) return {};
    const Handle attribute(H5Aopen(of, name, H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (H5Tget_class(type) != H5T_STRING) return {};
    const auto count =
        static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
    if (count == 0 || count > max_texts) return {};
    if (H5Tis_variable_str(type) > 0) return variable_texts(attribute, type, count);
    const std::size_t width = H5Tget_size(type);
    if (width > max_text_length) return {};
    std::string letters(width * count, '\0');
    if (H5Aread(attribute, type, letters.data()) < 0) return {};
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < count; ++k) {
      texts.push_back(letters.substr(k * width, width));
      texts.back().resize(texts.back().find_last_not_of(std::string_view(" \0", 2)) + 1);
    }
    return texts;
  }

  // Parses the unit of a length, a time, or a length per time: "nm", "Angstrom", "nm ps-1".
  double unit_of(hid_t values, const std::string& element,
                 const std::vector<Dimension>& dimensions) const {
    const auto texts = text_attribute(values, "unit");
    if (texts.empty())
      refuse(fmt::format("'{}' has no attribute 'unit'; add the unit, for example \"{}\"", element,
                         dimensions.front() == Dimension::time ? "ps" : "nm"));
    const std::string& text = texts.front();
    std::string first = text.substr(0, text.find_first_of(" /"));
    std::string second = first.size() < text.size() ? text.substr(first.size() + 1) : "";
    if (second.ends_with("-1")) second.resize(second.size() - 2);
    const auto known = [](const std::string& symbol) {
      return symbol == "Angstrom" || symbol == "angstrom" ? std::string("A") : symbol;
    };
    try {
      const double one = unit(known(first), dimensions[0]);
      if (dimensions.size() == 1 && second.empty()) return one;
      if (dimensions.size() == 2) return one / unit(known(second), dimensions[1]);
    } catch (const Error& e) {
      throw e.at(fmt::format("{}, {}", name_, element));
    }
    refuse(fmt::format("'{}' has the unit '{}'; it must be a single unit, such as \"nm\"", element,
                       text));
  }

  void find_box() {
    const Handle box = hdf5::group(file_, root_ + "box");
    if (!box.is_open() || !(hdf5::has(box, "edges")))
      refuse("the particles have no 'box/edges'; polhode needs these edges as the periodic box");
    if (H5Aexists(box, "boundary") > 0) {
      const auto boundary = text_attribute(box, "boundary");
      if (boundary.empty() || std::any_of(boundary.begin(), boundary.end(),
                                          [](const auto& b) { return b != "periodic"; }))
        refuse(fmt::format("the boundary of the box is '{}'; it must be periodic in all directions",
                           fmt::join(boundary, ", ")));
    }
    edges_ = series("box/edges", {Dimension::length});
    const std::size_t rank = edges_.extents.size() - (edges_.changes ? 1 : 0);
    const bool fits = !edges_.extents.empty() && (rank == 1 || rank == 2) &&
                      std::all_of(edges_.extents.end() - static_cast<std::ptrdiff_t>(rank),
                                  edges_.extents.end(), [](hsize_t extent) { return extent == 3; });
    if (!fits) refuse("'box/edges' must be 3 edges or 3 by 3 numbers");
    if (edges_.changes) pair(edges_, "box/edges");
  }

  void find_times() {
    if (!hdf5::has(file_, root_ + "position/time")) return;
    times_ = moments("position/time");
    const Handle numbers = hdf5::dataset(file_, root_ + "position/time");
    if (H5Aexists(numbers, "unit") > 0)
      time_unit_ = unit_of(numbers, "position/time", {Dimension::time});
    if (times_->is_list()) frames_ = std::min<hsize_t>(frames_, times_->size());
  }

  double time_at(hsize_t number) const {
    return times_ ? times_->at(number) * time_unit_ : static_cast<double>(number);
  }

  Box box_at(hsize_t number) {
    const auto place = edges_.place(number);
    if (!place)
      refuse(fmt::format("frame {} has no box at its step or time; every frame must have a box",
                         number + 1));
    take(edges_, *place, values_);
    if (values_.size() == 9) {
      for (std::size_t k = 0; k < 9; ++k)
        if (k % 4 != 0 && values_[k] != 0)
          refuse(
              "the box is triclinic, and only rectangular (orthorhombic) boxes are supported; "
              "build the system in a rectangular box");
      values_ = {values_[0], values_[4], values_[8]};
    }
    for (const double edge : values_)
      if (!(edge > 0) || !std::isfinite(edge))
        refuse(fmt::format("a box edge is {}; it must be longer than 0", edge));
    return {edges_.unit * Vec3<double>{values_[0], values_[1], values_[2]}};
  }

  // The values of one frame.
  void take(const ReadSeries& series, hsize_t number, std::vector<double>& into) const {
    std::vector<hsize_t> from(series.extents.size(), 0), count = series.extents;
    if (series.changes) {
      from[0] = number;
      count[0] = 1;
    }
    std::size_t size = 1;
    for (const hsize_t extent : count) size *= extent;
    into.resize(size);
    const Handle file_space(H5Dget_space(series.values), H5Sclose);
    const Handle space = hdf5::space_of(count);
    if (H5Sselect_hyperslab(file_space, H5S_SELECT_SET, from.data(), nullptr, count.data(),
                            nullptr) < 0 ||
        H5Dread(series.values, H5T_NATIVE_DOUBLE, space, file_space, H5P_DEFAULT, into.data()) < 0)
      refuse(fmt::format("frame {} cannot be read; the file is damaged", number + 1));
  }

  Vec3<double> vector(std::size_t i, double unit) const {
    const Vec3<double> v =
        unit * Vec3<double>{values_[3 * i], values_[3 * i + 1], values_[3 * i + 2]};
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      refuse(fmt::format("a coordinate or velocity of atom {} in frame {} is not finite", i + 1,
                         number_ + 1));
    return v;
  }

  // H5MD does not define names of atoms, but files of this program contain them.
  void name_atoms(std::size_t count) {
    atoms_.resize(count);
    kinds_.assign(1, {});
    const auto names = texts("name"), residue_names = texts("residue_name"),
               elements = texts("element");
    const auto species = integers("species", count), residues = integers("residue", count);
    if (names.empty() || residue_names.size() != names.size() || elements.size() != names.size())
      return;
    if (species.size() != count || residues.size() != count) return;
    for (const int kind : species)
      if (kind < 0 || static_cast<std::size_t>(kind) >= names.size())
        refuse(
            fmt::format("an atom has the species number {}; species numbers must be from 0 to {}",
                        kind, names.size() - 1));
    kinds_.clear();
    for (std::size_t k = 0; k < names.size(); ++k)
      kinds_.push_back({residue_names[k], names[k], elements[k]});
    for (std::size_t i = 0; i < count; ++i) {
      atoms_[i].kind = static_cast<std::uint32_t>(species[i]);
      atoms_[i].residue = residues[i];
    }
  }

  std::vector<int> integers(const std::string& element, std::size_t count) const {
    const std::string place = root_ + element;
    if (!hdf5::has(file_, place)) return {};
    const Handle values = hdf5::dataset(file_, place);
    if (!values.is_open() || hdf5::extents(values) != std::vector<hsize_t>{count}) return {};
    check_numbers(values, place);
    std::vector<int> numbers(count);
    if (H5Dread(values, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
      refuse(fmt::format("'{}' cannot be read; the file is damaged", place));
    return numbers;
  }

  std::vector<std::string> texts(const char* name) const {
    const std::string place = std::string("parameters/species/") + name;
    if (!hdf5::has(file_, place)) return {};
    const Handle values = hdf5::dataset(file_, place);
    if (!values.is_open()) return {};
    const Handle type(H5Dget_type(values), H5Tclose);
    const auto extents = hdf5::extents(values);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || extents.size() != 1)
      return {};
    const std::size_t width = H5Tget_size(type);
    if (extents[0] == 0 || width > bytes_ / extents[0]) return {};
    std::string letters(width * extents[0], '\0');
    if (H5Dread(values, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()) < 0) return {};
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < extents[0]; ++k)
      texts.emplace_back(letters.substr(k * width, width).c_str());
    return texts;
  }

  std::string name_, root_;
  std::uint64_t bytes_ = 0;  // size of the file
  Handle file_;
  ReadSeries position_, edges_;
  std::optional<ReadSeries> velocity_;
  std::optional<Moments> times_;
  double time_unit_ = 1;
  std::vector<AtomKind> kinds_;
  std::vector<Atom> atoms_;  // names of the atoms
  std::vector<double> values_;
  hsize_t frames_ = 0, number_ = 0;
};

}  // namespace

std::unique_ptr<FrameReader> h5md_reader(std::istream& in, const std::string& file) {
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  return std::make_unique<H5mdReader>(file, &bytes);
}

std::unique_ptr<FrameReader> open_h5md(const std::string& path) {
  return std::make_unique<H5mdReader>(path, nullptr);
}

}  // namespace polhode
