// SPDX-License-Identifier: MIT
#include "h5md_series.hpp"

#include <array>

#include "base/output_error.hpp"
#include "format.hpp"
#include "io/files/checksum.hpp"
#include "io/files/disk.hpp"

namespace polhode {
namespace h5md {
namespace {

using hdf5::Handle;

constexpr std::array names_of_series = {step,
                                        time,
                                        "particles/all/box/edges",
                                        "particles/all/position",
                                        "particles/all/velocity",
                                        "particles/bodies/position",
                                        "particles/bodies/orientation",
                                        "particles/bodies/attitude",  // name up to version 0.1
                                        "particles/bodies/momentum",
                                        "particles/bodies/angular_momentum"};

}  // namespace

std::string value_path(const std::string& name) {
  return name == step || name == time ? name : name + "/value";
}

std::vector<std::string> links(hid_t group) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
  return names;
}

std::map<std::string, Series> series_of(hid_t file) {
  std::map<std::string, Series> all;
  const auto take = [&](const std::string& name) {
    if (!hdf5::has(file, value_path(name))) return;
    Series series{hdf5::dataset(file, value_path(name)), {}};
    const auto extents = hdf5::extents(series.values);
    if (!extents.empty()) series.row.assign(extents.begin() + 1, extents.end());
    all.emplace(name, std::move(series));
  };
  for (const char* name : names_of_series) take(name);
  if (hdf5::has(file, "observables"))
    for (const std::string& name : links(hdf5::group(file, "observables")))
      take("observables/" + name);
  return all;
}

Handle row_space(const Series& series, std::uint64_t frame) {
  std::vector<hsize_t> from{frame}, count{1};
  for (const hsize_t extent : series.row) from.push_back(0), count.push_back(extent);
  Handle space(H5Dget_space(series.values), H5Sclose);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, from.data(), nullptr, count.data(), nullptr);
  return space;
}

std::optional<std::uint64_t> frame_checksum(const std::map<std::string, Series>& all,
                                            std::uint64_t frame, std::uint64_t before) {
  std::vector<char> bytes;
  for (const auto& [name, series] : all) {
    const Handle type(H5Dget_type(series.values), H5Tclose);
    hsize_t count = 1;
    for (const hsize_t extent : series.row) count *= extent;
    bytes.resize(H5Tget_size(type) * count);
    const Handle memory = hdf5::space_of({count});
    const Handle place = row_space(series, frame);
    if (H5Dread(series.values, type, memory, place, H5P_DEFAULT, bytes.data()) < 0) return {};
    before = crc64(bytes.data(), bytes.size(), before);
  }
  return before;
}

}  // namespace h5md

void check_h5md(const std::string& path, const FileMark& mark) {
  hdf5::be_quiet();
  check_length(path, 0);
  const hdf5::Handle file(
      H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, hdf5::reading_access()), H5Fclose);
  std::optional<std::uint64_t> sum;
  if (file.is_open()) {
    sum = 0;
    const auto series = h5md::series_of(file);
    for (std::uint64_t frame = 0; sum && frame < mark.frames; ++frame)
      sum = h5md::frame_checksum(series, frame, *sum);
  }
  if (sum != mark.checksum && mark.frames > 0) throw OutputError(not_the_file(path));
}

}  // namespace polhode
