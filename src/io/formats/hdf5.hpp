// SPDX-License-Identifier: MIT
// The part of HDF5's C interface that H5MD files need.
#pragma once

#include <hdf5.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace polhode::hdf5 {

/// An open thing of the library, closed at the end of its scope.
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

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// No messages on stderr: what goes wrong is told by errors.
inline void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

inline bool has(hid_t where, const std::string& name) {
  for (auto end = name.find('/');; end = name.find('/', end + 1)) {
    if (H5Lexists(where, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == name.npos) return true;
  }
}

inline Handle group(hid_t where, const std::string& name) {
  return {H5Gopen2(where, name.c_str(), H5P_DEFAULT), H5Gclose};
}

inline Handle dataset(hid_t where, const std::string& name) {
  return {H5Dopen2(where, name.c_str(), H5P_DEFAULT), H5Dclose};
}

inline std::vector<hsize_t> extents(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extents(rank > 0 ? static_cast<std::size_t>(rank) : 0);
  if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

}  // namespace polhode::hdf5
