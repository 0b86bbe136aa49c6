// SPDX-License-Identifier: MIT
// Columns hold one number per body, contiguous and aligned for the widest pack. Columns are padded
// to a whole number of packs, so that loops over packs need no remainder. Padding elements are set
// to a value that is safe in arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "polhode/base/aligned_allocator.hpp"
#include "polhode/base/quaternion.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {

template <class T>
class Column {
 public:
  Column() = default;
  explicit Column(std::size_t size, T value = T{}) : size_(size), data_(padded(size), value) {}

  std::size_t size() const { return size_; }
  std::size_t padded_size() const { return data_.size(); }
  T* data() { return data_.data(); }
  const T* data() const { return data_.data(); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  std::span<const T> values() const { return {data(), size_}; }

  static constexpr std::size_t padded(std::size_t n) {
    constexpr std::size_t width = pack_bytes / sizeof(T);
    return (n + width - 1) / width * width;
  }

 private:
  std::size_t size_ = 0;
  std::vector<T, AlignedAllocator<T>> data_;
};

/// One of several columns that share a block of memory, such as the x components of the positions
/// of all bodies.
class Component {
 public:
  Component() = default;
  std::size_t size() const { return size_; }
  std::size_t padded_size() const { return Column<double>::padded(size_); }
  double* data() { return data_; }
  const double* data() const { return data_; }
  double& operator[](std::size_t i) { return data_[i]; }
  const double& operator[](std::size_t i) const { return data_[i]; }
  std::span<const double> values() const { return {data_, size_}; }
  Component(const Component&) = delete;  // a copy would point into memory of another owner
  Component& operator=(const Component&) = delete;

 private:
  template <std::size_t>
  friend class Components;
  double* data_ = nullptr;
  std::size_t size_ = 0;
};

/// Owns the memory of `n` columns of equal size, placed at equal distances in memory. Other
/// languages can share this memory as one array with strides. Assigning columns of the same size
/// does not move the memory.
template <std::size_t n>
class Components {
 public:
  std::size_t size() const { return size_; }
  std::size_t padded_size() const { return Column<double>::padded(size_); }
  /// Distance in memory between a component and the next component of the same body, as a number of
  /// doubles.
  std::size_t stride() const { return stride_of(size_); }
  /// The k-th component of all bodies.
  std::span<double> component(std::size_t k) {
    return {memory_.data() + (size_ == 0 ? 0 : k * stride()), size_};
  }
  std::span<const double> component(std::size_t k) const {
    return {memory_.data() + (size_ == 0 ? 0 : k * stride()), size_};
  }

 protected:
  Components() = default;
  Components(std::size_t size, const std::array<double, n>& value)
      : size_(size), memory_(size == 0 ? 0 : n * stride_of(size)) {
    for (std::size_t k = 0; k < n && size > 0; ++k)
      std::fill_n(component(k).data(), padded_size(), value[k]);
  }
  /// Updates the component pointers after a move of the memory.
  void place(const std::array<Component*, n>& components) {
    for (std::size_t k = 0; k < n; ++k) {
      components[k]->data_ = component(k).data();
      components[k]->size_ = size_;
    }
  }
  void take(Components& other) {
    size_ = std::exchange(other.size_, 0);
    memory_ = std::exchange(other.memory_, {});
  }

 private:
  /// The stride is one pack larger than necessary. If components were whole pages apart, they would
  /// compete for the same few cache lines.
  static constexpr std::size_t stride_of(std::size_t size) {
    return Column<double>::padded(size) + pack_bytes / sizeof(double);
  }
  std::size_t size_ = 0;
  Column<double> memory_;
};

/// Three columns that hold one vector for each body.
struct Vec3Column : Components<3> {
  Component x, y, z;

  Vec3Column() = default;
  explicit Vec3Column(std::size_t size, Vec3<double> value = {})
      : Components(size, {value.x, value.y, value.z}) {
    place({&x, &y, &z});
  }
  Vec3Column(const Vec3Column& other) : Components(other) { place({&x, &y, &z}); }
  Vec3Column(Vec3Column&& other) noexcept { *this = std::move(other); }
  Vec3Column& operator=(const Vec3Column& other) {
    Components::operator=(other);
    place({&x, &y, &z});
    return *this;
  }
  Vec3Column& operator=(Vec3Column&& other) noexcept {
    if (this == &other) return *this;
    take(other);
    place({&x, &y, &z});
    other.place({&other.x, &other.y, &other.z});
    return *this;
  }
  ~Vec3Column() = default;

  Vec3<double> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3<double>& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  void add(std::size_t i, const Vec3<double>& v) { set(i, (*this)[i] + v); }
};

/// Multiplies the vectors of all bodies by a factor.
inline void scale(Vec3Column& vectors, double factor) {
  for (Component* const column : {&vectors.x, &vectors.y, &vectors.z})
    for (std::size_t i = 0; i < column->size(); ++i) (*column)[i] *= factor;
}

/// Four columns that hold one unit quaternion for each body; the padding is the identity.
struct QuaternionColumn : Components<4> {
  Component w, x, y, z;

  QuaternionColumn() = default;
  explicit QuaternionColumn(std::size_t size) : Components(size, {1, 0, 0, 0}) {
    place({&w, &x, &y, &z});
  }
  QuaternionColumn(const QuaternionColumn& other) : Components(other) { place({&w, &x, &y, &z}); }
  QuaternionColumn(QuaternionColumn&& other) noexcept { *this = std::move(other); }
  QuaternionColumn& operator=(const QuaternionColumn& other) {
    Components::operator=(other);
    place({&w, &x, &y, &z});
    return *this;
  }
  QuaternionColumn& operator=(QuaternionColumn&& other) noexcept {
    if (this == &other) return *this;
    take(other);
    place({&w, &x, &y, &z});
    other.place({&other.w, &other.x, &other.y, &other.z});
    return *this;
  }
  ~QuaternionColumn() = default;

  Quaternion<double> operator[](std::size_t i) const { return {w[i], x[i], y[i], z[i]}; }
  void set(std::size_t i, const Quaternion<double>& q) {
    w[i] = q.w;
    x[i] = q.x;
    y[i] = q.y;
    z[i] = q.z;
  }
};

}  // namespace polhode
