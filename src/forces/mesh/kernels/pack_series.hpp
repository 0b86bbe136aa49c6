// SPDX-License-Identifier: MIT
// Arrays for pocketfft transforms of packs. pocketfft itself allocates its arrays in each call.
// Arrays of packs use memory that the thread keeps, so that force evaluations allocate no memory
// after the first evaluation.
#pragma once

#include <array>
#include <cstddef>

#include "base/pack.hpp"
#include "math/pocketfft.hpp"
#include "polhode/base/column.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

/// An array of uninitialized numbers. Arrays must be released in the reverse order of their
/// allocation.
template <class Number>
class PackSeries {
 public:
  explicit PackSeries(std::size_t size) {
    Column<std::byte>& memory = kept.at(in_use++);
    if (memory.size() < size * sizeof(Number)) memory = Column<std::byte>(size * sizeof(Number));
    numbers_ = reinterpret_cast<Number*>(memory.data());
  }
  ~PackSeries() { --in_use; }
  PackSeries(const PackSeries&) = delete;
  PackSeries& operator=(const PackSeries&) = delete;

  Number& operator[](std::size_t i) { return numbers_[i]; }
  Number* data() { return numbers_; }

 private:
  // Memory for two arrays of a caller, and for the scratch space that pocketfft needs to transform
  // a series.
  static inline thread_local std::array<Column<std::byte>, 3> kept;
  static inline thread_local std::size_t in_use = 0;
  Number* numbers_;
};

}  // namespace
}  // namespace polhode::POLHODE_LOOPS

namespace pocketfft::detail {

template <class T>
class arr<polhode::Pack<T>> : public polhode::POLHODE_LOOPS::PackSeries<polhode::Pack<T>> {
  using polhode::POLHODE_LOOPS::PackSeries<polhode::Pack<T>>::PackSeries;
};
template <class T>
class arr<cmplx<polhode::Pack<T>>>
    : public polhode::POLHODE_LOOPS::PackSeries<cmplx<polhode::Pack<T>>> {
  using polhode::POLHODE_LOOPS::PackSeries<cmplx<polhode::Pack<T>>>::PackSeries;
};

}  // namespace pocketfft::detail
