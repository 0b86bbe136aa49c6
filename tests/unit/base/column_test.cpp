// SPDX-License-Identifier: MIT
// Where columns are in memory.
#include "polhode/base/column.hpp"

#include <doctest/doctest.h>

#include <cstdint>

using namespace polhode;

namespace {

template <class T>
std::uintptr_t address(const Column<T>& column) {
  return reinterpret_cast<std::uintptr_t>(column.data());
}

}  // namespace

TEST_CASE("columns start where packs may, and large ones at a large page") {
  const Column<float> one(1);
  const Column<double> below(2 * large_page_bytes / sizeof(double) - 8),
      large(2 * large_page_bytes / sizeof(double));
  CHECK(address(one) % pack_bytes == 0);
  CHECK(address(below) % pack_bytes == 0);
  CHECK(address(large) % large_page_bytes == 0);
  CHECK(one.padded_size() * sizeof(float) == pack_bytes);
}
