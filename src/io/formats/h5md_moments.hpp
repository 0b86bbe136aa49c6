// SPDX-License-Identifier: MIT
// The steps or times at which an H5MD element has values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hdf5.hpp"

namespace polhode {

/// The steps or times of a series: one number for each value, or an offset and an increment for all
/// values [debuyl2014, "time-dependent elements"].
class Moments {
 public:
  /// Reads the steps or times.
  /// @param dataset  dataset 'step' or 'time', which is a list, or a scalar with an optional
  ///   attribute 'offset'
  /// @throws Error  if the dataset cannot be read, or if a number is not finite
  Moments(hid_t dataset, const std::string& name) {
    const auto extents = hdf5::extents(dataset);
    if (extents.size() > 1)
      throw Error(fmt::format(
          "'{}' must be one number for each frame, or one number for all frames", name));
    is_list_ = !extents.empty();
    numbers_.resize(is_list_ ? extents[0] : 1);
    const bool read = numbers_.empty() || H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                                                  H5P_DEFAULT, numbers_.data()) >= 0;
    if (!is_list_) read_offset(dataset);
    numbers_.push_back(offset_);
    if (!read ||
        std::any_of(numbers_.begin(), numbers_.end(), [](double x) { return !std::isfinite(x); }))
      throw Error(fmt::format("'{}' must hold finite numbers; the file is damaged", name));
    numbers_.pop_back();
    if (is_list_) sort();
  }

  bool is_list() const { return is_list_; }
  std::size_t size() const { return numbers_.size(); }  ///< number of steps or times in the list

  double at(std::size_t n) const {
    return is_list_ ? numbers_[n] : offset_ + static_cast<double>(n) * numbers_[0];
  }

  /// The index of the value at a given step or time, if that step or time exists.
  std::optional<std::size_t> find(double moment) const {
    if (is_list_) {
      const auto found =
          std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{moment, std::size_t{0}});
      if (found == sorted_.end() || found->first != moment) return std::nullopt;
      return found->second;
    }
    const double place = (moment - offset_) / numbers_[0];
    const double whole = std::nearbyint(place);
    constexpr double rounding = 1e-6;  // relative round-off of computed times
    if (!(whole >= 0 && whole < 0x1p53 && std::abs(place - whole) <= rounding)) return std::nullopt;
    return static_cast<std::size_t>(whole);
  }

  bool operator==(const Moments& other) const {
    return is_list_ == other.is_list_ && offset_ == other.offset_ && numbers_ == other.numbers_;
  }

 private:
  void read_offset(hid_t dataset) {
    if (H5Aexists(dataset, "offset") <= 0) return;
    const hdf5::Handle attribute(H5Aopen(dataset, "offset", H5P_DEFAULT), H5Aclose);
    const hdf5::Handle space(H5Aget_space(attribute), H5Sclose);
    const bool single = H5Sget_simple_extent_npoints(space) == 1;
    if (!single || H5Aread(attribute, H5T_NATIVE_DOUBLE, &offset_) < 0)
      offset_ = std::numeric_limits<double>::quiet_NaN();  // this value is rejected
  }
  void sort() {
    for (std::size_t n = 0; n < numbers_.size(); ++n) sorted_.emplace_back(numbers_[n], n);
    std::sort(sorted_.begin(), sorted_.end());
  }

  bool is_list_ = false;
  double offset_ = 0;
  std::vector<double> numbers_;  // list of numbers, or only the increment
  std::vector<std::pair<double, std::size_t>> sorted_;
};

}  // namespace polhode
