// SPDX-License-Identifier: MIT
// H5MD files [debuyl2014], written so that they can be read at any time and remain readable if the
// program is killed.
#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <span>
#include <stdexcept>

#include "base/version.hpp"
#include "format.hpp"
#include "h5md_series.hpp"
#include "hdf5.hpp"
#include "io/files/disk.hpp"
#include "io/files/draft.hpp"
#include "own_process.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

const std::string_view h5md_missing;

namespace {

using h5md::links;
using h5md::Series;
using h5md::value_path;
using hdf5::Handle;

// Size of a chunk [bytes] that contains several short rows. Data are not compressed, because most
// bits of positions and momenta are noise. Deflate would reduce a file by only 7 % and triple the
// computing time for writing a frame.
constexpr hsize_t small_row = 4096;
constexpr std::size_t chunks_in_memory = 1;       // chunks of a series: only the one being filled
constexpr std::size_t index_in_memory = 1 << 20;  // size of the index of a file in memory [bytes]

class H5mdWriter : public FrameWriter {
 public:
  H5mdWriter(std::string path, const Topology& topology, const FrameChoice& choice,
             const FileMark* mark)
      : path_(std::move(path)), topology_(topology), choice_(choice) {
    hdf5::be_quiet();
    if (mark != nullptr && mark->frames > 0) {
      reopen(mark->frames);
      summed_ = mark->frames;
      checksum_ = mark->checksum;
    } else {
      create();
    }
  }

  ~H5mdWriter() override {
    if (broken_) abandon();
  }

  void write(const State& state) override { write(state, {}); }
  void write(const State& state, std::span<const FrameNumber> observables) override {
    const FrameView frame = view_of(state, topology_, choice_);
    if (!started_) begin(frame, &state, observables);
    append(frame);
    append(state);
    for (const FrameNumber& observable : observables) {
      const auto series = series_.find("observables/" + std::string(observable.name));
      if (series != series_.end()) put(series->second, H5T_NATIVE_DOUBLE, &observable.value);
    }
    finish_frame();
  }
  void write(const Frame& frame) override {
    const FrameView view = view_of(frame, choice_);
    if (!started_) begin(view, nullptr, {});
    append(view);
    finish_frame();
  }
  FileMark mark() override {
    check(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    sync_file(path_);
    for (; summed_ < frames_; ++summed_) {
      const auto sum = h5md::frame_checksum(series_, summed_, checksum_);
      if (!sum) refuse();
      checksum_ = *sum;
    }
    return {frames_, 0, checksum_};
  }

 private:
  [[noreturn]] void refuse() const {
    broken_ = true;
    throw RunError(fmt::format("'{}' could not be written completely; is the disk full?", path_));
  }
  template <class Result>
  Result check(Result result) const {
    if (result < 0) refuse();
    return result;
  }
  void abandon() {
    for (auto& [name, series] : series_) series.values.abandon();
    file_.abandon();
  }
  Handle make_handle(hid_t id, herr_t (*close)(hid_t)) const { return {check(id), close}; }

  void create() {
    remove_output(path_);
    const Handle properties = timeless(H5P_FILE_CREATE), access = access_properties();
    errno = 0;
    file_ = {H5Fcreate(path_.c_str(), H5F_ACC_EXCL, properties, access), H5Fclose};
    if (!file_.is_open()) throw Error(cannot_write(path_, errno));
    bound_memory();
  }

  // A file can be read while it is being written only in the latest file format. Data are written
  // immediately, because a chunk cache would only grow by the bytes of each short row.
  Handle access_properties() const {
    Handle access = make_handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    check(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST));
    check(H5Pset_cache(access, 0, chunks_in_memory, small_row, 1.0));
    return access;
  }

  // The index of chunks grows with the number of frames. Parts of the index that are not in memory
  // are read again.
  void bound_memory() const {
    H5AC_cache_config_t metadata{};
    metadata.version = H5AC__CURR_CACHE_CONFIG_VERSION;
    check(H5Fget_mdc_config(file_, &metadata));
    metadata.set_initial_size = true;
    metadata.initial_size = metadata.min_size = metadata.max_size = index_in_memory;
    check(H5Fset_mdc_config(file_, &metadata));
  }

  // Creation properties without timestamps, so that equal runs write equal bytes.
  Handle timeless(hid_t kind) const {
    Handle properties = make_handle(H5Pcreate(kind), H5Pclose);
    check(H5Pset_obj_track_times(properties, false));
    return properties;
  }

  // The file of a killed program can be read but not safely changed, because the header may not
  // record all used space. A resumed run therefore appends to a copy of the file, which then
  // replaces the file atomically.
  void reopen(std::uint64_t frames) {
    Draft copy(path_, Draft::Name::unique);  // needed because the library resolves names
    const char* const part = copy.path().c_str();
    try {
      open_to_resume();  // throws an error that names missing parts
      // The HDF5 library (1.10) crashes when it closes a file on a full disk.
      const bool copied = done_in_own_process([&] {
        Handle file = make_handle(
            H5Fcreate(part, H5F_ACC_TRUNC, timeless(H5P_FILE_CREATE), access_properties()),
            H5Fclose);
        copy_all(open_to_resume(), file);
        check(file.close());
      });
      if (!copied) refuse();
      file_ = make_handle(H5Fopen(part, H5F_ACC_RDWR, access_properties()), H5Fclose);
      bound_memory();
      take_all_series(frames);
      start();
      check(H5Fflush(file_, H5F_SCOPE_GLOBAL));
      copy.finish();
    } catch (...) {
      if (broken_) abandon();  // a constructor that throws has no destructor
      throw;
    }
  }

  void take_all_series(std::uint64_t frames) {
    series_ = h5md::series_of(file_);
    for (const auto& [name, series] : series_) cut(name, series, frames);
    if (!series_.contains("particles/all/position"))
      throw Error(fmt::format(
          "'{}' has no positions to append to; restore the file that the run wrote, or start over",
          path_));
    if (series_.contains("particles/bodies/attitude"))
      throw Error(fmt::format(
          "'{}' was written by an earlier version of polhode, in which 'orientation' was called "
          "'particles/bodies/attitude'; resume the run with that version, or start over",
          path_));
    frames_ = frames;
  }

  Handle open_to_resume() const {
    Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, hdf5::reading_access()),
                H5Fclose);
    if (!file.is_open())
      throw Error(fmt::format(
          "there is no H5MD file '{}' to append to; restore the file, or start over", path_));
    return file;
  }

  // All objects are copied in one call, so that hard links are preserved.
  void copy_all(hid_t from, hid_t to) const {
    check(H5Ocopy(from, "/", to, "all", H5P_DEFAULT, H5P_DEFAULT));
    {
      const Handle all = hdf5::group(to, "all");
      for (const std::string& name : links(all))
        check(H5Lmove(all, name.c_str(), to, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    }
    check(H5Ldelete(to, "all", H5P_DEFAULT));
  }

  void cut(const std::string& name, const Series& series, std::uint64_t frames) const {
    auto extents = hdf5::extents(series.values);
    if (extents.empty() || extents[0] < frames)
      throw Error(
          fmt::format("'{}' has {} rows of {}, but had {} when the run was interrupted; restore "
                      "the original file, or start over",
                      path_, extents.empty() ? 0 : extents[0], name, frames));
    extents[0] = frames;
    check(H5Dset_extent(series.values, extents.data()));
  }

  void attribute(hid_t of, const char* name, const std::string& text) const {
    const Handle type = make_handle(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type, H5T_VARIABLE));
    check(H5Tset_cset(type, H5T_CSET_UTF8));
    const Handle space = make_handle(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle a =
        make_handle(H5Acreate2(of, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const char* value = text.c_str();
    check(H5Awrite(a, type, &value));
  }
  void attribute(hid_t of, const char* name, const std::vector<int>& numbers) const {
    const Handle space = check(numbers.size() == 1 ? Handle(H5Screate(H5S_SCALAR), H5Sclose)
                                                   : hdf5::space_of({numbers.size()}));
    const Handle a =
        make_handle(H5Acreate2(of, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(a, H5T_NATIVE_INT, numbers.data()));
  }
  Handle new_group(const std::string& name) const {
    make_parents(name);
    return make_handle(
        H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, timeless(H5P_GROUP_CREATE), H5P_DEFAULT),
        H5Gclose);
  }
  void make_parents(const std::string& name) const {
    const auto slash = name.rfind('/');
    if (slash != name.npos && !hdf5::has(file_, name.substr(0, slash)))
      new_group(name.substr(0, slash));
  }
  Handle new_constants(const std::string& name, hid_t type, hsize_t size) const {
    make_parents(name);
    const Handle space = check(hdf5::space_of({size}));
    return make_handle(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT,
                                  timeless(H5P_DATASET_CREATE), H5P_DEFAULT),
                       H5Dclose);
  }

  void begin_series(const std::string& name, hid_t type, std::vector<hsize_t> row,
                    const std::string& unit) {
    hsize_t bytes = H5Tget_size(type);
    for (const hsize_t extent : row) bytes *= std::max<hsize_t>(extent, 1);
    std::vector<hsize_t> extents{0}, max_extents{H5S_UNLIMITED};
    std::vector<hsize_t> chunk{
        bytes < small_row ? std::max<hsize_t>(1, small_row / std::max<hsize_t>(1, bytes)) : 1};
    for (const hsize_t extent : row) {
      extents.push_back(extent);
      max_extents.push_back(extent);
      chunk.push_back(std::max<hsize_t>(extent, 1));
    }
    const Handle space = make_handle(
        H5Screate_simple(static_cast<int>(extents.size()), extents.data(), max_extents.data()),
        H5Sclose);
    const Handle properties = timeless(H5P_DATASET_CREATE);
    check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
    const bool has_group = value_path(name) != name;
    if (has_group) {
      const Handle group = new_group(name);
      for (const char* shared : {h5md::step, h5md::time})
        check(H5Lcreate_hard(file_, shared, group,
                             std::string(shared).substr(std::string(shared).rfind('/') + 1).c_str(),
                             H5P_DEFAULT, H5P_DEFAULT));
    }
    Series series{make_handle(H5Dcreate2(file_, value_path(name).c_str(), type, space, H5P_DEFAULT,
                                         properties, H5P_DEFAULT),
                              H5Dclose),
                  std::move(row)};
    if (!unit.empty()) attribute(series.values, "unit", unit);
    series_.emplace(name, std::move(series));
  }

  template <class T>
  void constants(const std::string& name, hid_t file_type, hid_t type, const std::vector<T>& values,
                 const char* unit = nullptr) {
    const Handle set = new_constants(name, file_type, values.size());
    if (!values.empty()) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    if (unit != nullptr) attribute(set, "unit", unit);
  }
  void constants(const std::string& name, const std::vector<std::string>& texts) {
    std::size_t width = 1;
    for (const std::string& text : texts) width = std::max(width, text.size());
    std::vector<char> letters(width * texts.size());
    for (std::size_t k = 0; k < texts.size(); ++k)
      std::copy(texts[k].begin(), texts[k].end(),
                letters.begin() + static_cast<std::ptrdiff_t>(k * width));
    const Handle type = make_handle(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type, width));
    check(H5Tset_strpad(type, H5T_STR_NULLPAD));
    const Handle set = new_constants(name, type, texts.size());
    if (!texts.empty()) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()));
  }

  // Creates the constant data and the datasets of the series. No dataset can be added while other
  // programs read the file.
  void begin(const FrameView& frame, const State* state, std::span<const FrameNumber> observables) {
    attribute(new_group("h5md"), "version", std::vector<int>{1, 1});
    attribute(new_group("h5md/author"), "name", "unknown");
    const Handle creator = new_group("h5md/creator");
    attribute(creator, "name", "polhode");
    attribute(creator, "version", version());
    attribute(new_group("h5md/modules/units"), "version", std::vector<int>{1, 0});
    new_group("particles/all");
    begin_series(h5md::step, H5T_STD_I64LE, {}, "");
    begin_series(h5md::time, H5T_IEEE_F64LE, {}, "ps");
    const Handle box = new_group("particles/all/box");
    attribute(box, "dimension", std::vector<int>{3});
    periodic(box);
    begin_series("particles/all/box/edges", H5T_IEEE_F64LE, {3, 3}, "nm");
    begin_series("particles/all/position", H5T_IEEE_F32LE, {frame.atoms, 3}, "nm");
    if (frame.has_velocities)
      begin_series("particles/all/velocity", H5T_IEEE_F32LE, {frame.atoms, 3}, "nm ps-1");
    name_sites(frame);
    if (state != nullptr) {
      describe_sites();
      new_group("particles/bodies");
      check(H5Lcreate_hard(file_, "particles/all/box", file_, "particles/bodies/box", H5P_DEFAULT,
                           H5P_DEFAULT));
      const hsize_t n = state->size();
      begin_series("particles/bodies/position", H5T_IEEE_F64LE, {n, 3}, "nm");
      begin_series("particles/bodies/orientation", H5T_IEEE_F64LE, {n, 4}, "");
      begin_series("particles/bodies/momentum", H5T_IEEE_F64LE, {n, 3}, "u nm ps-1");
      begin_series("particles/bodies/angular_momentum", H5T_IEEE_F64LE, {n, 3}, "u nm2 ps-1");
    }
    if (!observables.empty()) new_group("observables");
    for (const FrameNumber& o : observables)
      begin_series("observables/" + std::string(o.name), H5T_IEEE_F64LE, {}, std::string(o.unit));
    start();
  }

  void periodic(hid_t box) const {
    const Handle type = make_handle(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type, H5T_VARIABLE));
    const Handle space = check(hdf5::space_of({3}));
    const Handle a =
        make_handle(H5Acreate2(box, "boundary", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const std::array<const char*, 3> text = {"periodic", "periodic", "periodic"};
    check(H5Awrite(a, type, text.data()));
  }

  void name_sites(const FrameView& frame) {
    std::vector<std::int32_t> species, residues;
    frame.each_atom([&](const Atom& atom) {
      species.push_back(static_cast<std::int32_t>(atom.kind));
      residues.push_back(atom.residue);
    });
    constants("particles/all/species", H5T_STD_I32LE, H5T_NATIVE_INT32, species);
    constants("particles/all/residue", H5T_STD_I32LE, H5T_NATIVE_INT32, residues);
    std::vector<std::string> residue_names, names, elements;
    for (const AtomKind& kind : frame.kinds) {
      residue_names.push_back(kind.residue_name);
      names.push_back(kind.name);
      elements.push_back(kind.element);
    }
    constants("parameters/species/residue_name", residue_names);
    constants("parameters/species/name", names);
    constants("parameters/species/element", elements);
  }

  void describe_sites() {
    std::vector<double> mass, charge;
    for (const auto& [molecule, count] : topology_.parts)
      for (std::size_t copy = 0; copy < count; ++copy)
        for (const Site& site : molecule.sites) {
          if (site.mass == 0 && choice_.massless == MasslessSites::omit) continue;
          mass.push_back(site.mass);
          charge.push_back(site.charge);
        }
    constants("particles/all/mass", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, mass, "u");
    constants("particles/all/charge", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, charge, "e");
  }

  void start() {
    check(H5Fstart_swmr_write(file_));
    started_ = true;
  }

  void put(const Series& series, hid_t type, const void* values) {
    std::vector<hsize_t> extents{frames_ + 1};
    extents.insert(extents.end(), series.row.begin(), series.row.end());
    check(H5Dset_extent(series.values, extents.data()));
    const Handle file_space = h5md::row_space(series, frames_);
    extents[0] = 1;
    const Handle space = check(hdf5::space_of(extents));
    check(H5Dwrite(series.values, type, space, file_space, H5P_DEFAULT, values));
  }

  void put(const char* name, const std::vector<double>& values) {
    const auto series = series_.find(name);
    if (series == series_.end()) return;
    hsize_t expected = 1;
    for (const hsize_t extent : series->second.row) expected *= extent;
    if (expected != values.size())
      throw std::logic_error("a frame differs from the earlier frames in its number of atoms");
    put(series->second, H5T_NATIVE_DOUBLE, values.data());
  }

  void append(const FrameView& frame) {
    const auto number =
        static_cast<std::int64_t>(frames_);  // a step number, which frames do not contain
    put(series_.at(h5md::step), H5T_NATIVE_INT64, &number);
    put(series_.at(h5md::time), H5T_NATIVE_DOUBLE, &frame.time);
    // The box is stored as full vectors, because some readers do not support the shorter form.
    const Vec3<double> edge = frame.box.edge;
    put("particles/all/box/edges", {edge.x, 0, 0, 0, edge.y, 0, 0, 0, edge.z});
    std::vector<double> r, v;
    frame.each_atom([&](const Atom& atom) {
      for (std::size_t k = 0; k < 3; ++k) {
        r.push_back(atom.r[k]);
        v.push_back(atom.v[k]);
      }
    });
    put("particles/all/position", r);
    put("particles/all/velocity", v);
  }

  void append(const State& state) {
    std::vector<double> q, orientation, p, ell;
    const auto add = [](std::vector<double>& to, const Vec3<double>& v) {
      to.insert(to.end(), {v.x, v.y, v.z});
    };
    for (std::size_t i = 0; i < state.size(); ++i) {
      add(q, state.q[i]);
      add(p, state.p[i]);
      add(ell, state.ell[i]);
      const Quaternion<double> a = state.orientation[i];
      orientation.insert(orientation.end(), {a.w, a.x, a.y, a.z});
    }
    put("particles/bodies/position", q);
    put("particles/bodies/orientation", orientation);
    put("particles/bodies/momentum", p);
    put("particles/bodies/angular_momentum", ell);
  }

  void finish_frame() {
    check(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    ++frames_;
  }

  std::string path_;
  Topology topology_;
  FrameChoice choice_;
  Handle file_;
  std::map<std::string, Series> series_;  // closed before the file
  std::uint64_t frames_ = 0;
  std::uint64_t summed_ = 0, checksum_ = 0;  // frames until the last mark and their checksum
  bool started_ = false;
  mutable bool broken_ = false;  // whether a write has failed
};

}  // namespace

std::unique_ptr<FrameWriter> h5md_writer(const std::string& path, const Topology& topology,
                                         const FrameChoice& choice, const FileMark* mark) {
  return std::make_unique<H5mdWriter>(path, topology, choice, mark);
}

}  // namespace polhode
