// SPDX-License-Identifier: MIT
// Sine and cosine of packs.
#pragma once

#include <hwy/contrib/math/math-inl.h>

#include "base/pack.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

/// Sine and cosine of |a| < 39000; the error is at most 3 ULP.
template <class T>
Pack<T> sin(Pack<T> a) {
  return Pack<T>(hn::Sin(typename Pack<T>::Tag(), a.v));
}
template <class T>
Pack<T> cos(Pack<T> a) {
  return Pack<T>(hn::Cos(typename Pack<T>::Tag(), a.v));
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
