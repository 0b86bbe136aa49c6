// SPDX-License-Identifier: MIT
// Columns: one number per body, contiguous, aligned for the widest pack and padded to a whole
// number of packs, so that loops over packs need no remainder. The padding holds a harmless value.
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <vector>

#include "polhode/base/quaternion.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {

/// Bytes of the widest pack; columns start and end at multiples of it.
inline constexpr std::size_t pack_bytes = 64;

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{pack_bytes}));
  }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{pack_bytes}); }
  friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

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

/// Three columns that hold one vector per body.
struct Vec3Column {
  Column<double> x, y, z;

  Vec3Column() = default;
  explicit Vec3Column(std::size_t size, Vec3<double> value = {})
      : x(size, value.x), y(size, value.y), z(size, value.z) {}
  std::size_t size() const { return x.size(); }
  std::size_t padded_size() const { return x.padded_size(); }
  Vec3<double> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3<double>& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  void add(std::size_t i, const Vec3<double>& v) { set(i, (*this)[i] + v); }
};

/// Four columns that hold one unit quaternion per body; the padding is the identity.
struct QuaternionColumn {
  Column<double> w, x, y, z;

  QuaternionColumn() = default;
  explicit QuaternionColumn(std::size_t size) : w(size, 1.0), x(size), y(size), z(size) {}
  std::size_t size() const { return w.size(); }
  Quaternion<double> operator[](std::size_t i) const { return {w[i], x[i], y[i], z[i]}; }
  void set(std::size_t i, const Quaternion<double>& q) {
    w[i] = q.w;
    x[i] = q.x;
    y[i] = q.y;
    z[i] = q.z;
  }
};

}  // namespace polhode
