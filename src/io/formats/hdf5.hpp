// SPDX-License-Identifier: MIT
// The part of HDF5's C interface that H5MD files need.
#pragma once

#include <hdf5.h>

#include <fmt/core.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"

namespace polhode::hdf5 {

/// An open HDF5 identifier. The HDF5 identifier is closed at the end of the scope.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }  // implicit: the C interface takes it everywhere
  bool is_open() const { return id_ >= 0; }
  /// Gives up the identifier without closing it. Closing an object that could not be written makes
  /// the HDF5 library (1.10) crash.
  void abandon() { id_ = -1; }
  /// Closes the identifier before the end of the scope. The result is negative if data could not be
  /// written.
  herr_t close() { return close_(std::exchange(id_, -1)); }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// Turns off the library's messages on stderr, because this program throws errors instead. Also
/// turns off writing at exit, because the library would crash on a full disk. Call this function
/// first.
inline void be_quiet() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Creates access properties that reject links to other files.
/// @param kind  H5P_LINK_ACCESS, or a derived access class
inline Handle inside(hid_t kind) {
  Handle access(H5Pcreate(kind), H5Pclose);
  const auto refuse = [](const char*, const char*, const char*, const char*, unsigned*, hid_t,
                         void*) -> herr_t { return -1; };
  H5Pset_elink_cb(access, refuse, nullptr);
  return access;
}

/// Number of attempts to read metadata with a valid checksum while another program writes. The
/// library waits 1 ns before the second attempt and doubles the waiting time for each further
/// attempt: 17 ms in total. With the default of 100 attempts, reading a damaged file would take
/// years.
inline constexpr unsigned read_attempts = 24;

/// Access properties for a file that another program may be writing.
inline Handle reading_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_metadata_read_attempts(access, read_attempts);
  return access;
}

/// Whether an object with a given name exists.
/// @throws Error  if the object is in another file
inline bool has(hid_t where, const std::string& name) {
  const Handle access = inside(H5P_LINK_ACCESS);
  for (auto end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    H5L_info_t link{};
    if (H5Lget_info(where, part.c_str(), &link, access) >= 0 && link.type >= H5L_TYPE_UD_MIN)
      throw Error(
          fmt::format("'{}' is a link to another file, and polhode does not follow such links; "
                      "copy the data into the file with h5repack or h5copy",
                      part));
    if (H5Lexists(where, part.c_str(), access) <= 0) return false;
    if (end == name.npos) return true;
  }
}

inline Handle group(hid_t where, const std::string& name) {
  return {H5Gopen2(where, name.c_str(), inside(H5P_GROUP_ACCESS)), H5Gclose};
}

/// Opens a dataset.
/// @throws Error  if its numbers are in another file
inline Handle dataset(hid_t where, const std::string& name) {
  Handle set(H5Dopen2(where, name.c_str(), inside(H5P_DATASET_ACCESS)), H5Dclose);
  if (!set.is_open()) return set;
  const Handle properties(H5Dget_create_plist(set), H5Pclose);
  if (H5Pget_layout(properties) == H5D_VIRTUAL || H5Pget_external_count(properties) > 0)
    throw Error(
        fmt::format("the numbers of '{}' are stored in another file, and polhode does not read "
                    "external files; copy the numbers into the file with h5repack",
                    name));
  return set;
}

inline Handle space_of(const std::vector<hsize_t>& extents) {
  return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose};
}

inline std::vector<hsize_t> extents(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extents(rank > 0 ? static_cast<std::size_t>(rank) : 0);
  if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

}  // namespace polhode::hdf5
