// SPDX-License-Identifier: MIT
// Counting sort, and pairs from items sorted by cells.
#include "model/cell_list.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "polhode/math/random.hpp"

using namespace polhode;

TEST_CASE("a counting sort orders items by key, and items of a key as before") {
  const std::vector<std::size_t> keys{3, 0, 3, 1, 0, 3};
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < keys.size(); ++i) visit(keys[i], i);
  };
  std::vector<std::uint32_t> ends{9, 9, 9, 9, 9};  // of an earlier sort
  std::vector<std::size_t> sorted(10, 99);
  counting_sort(ends, 4, each, [&](std::uint32_t place, std::size_t i) { sorted[place] = i; });
  CHECK(sorted == std::vector<std::size_t>{99, 99, 99, 99, 1, 4, 3, 0, 2, 5});
  CHECK(ends == std::vector<std::uint32_t>{6, 7, 7, 10, 10});
  CHECK(begin_of(ends, 0, 4) == 4);
  CHECK(begin_of(ends, 2, 4) == 7);
}

TEST_CASE("a wrapped position is its image in the box") {
  const Box box{{2, 3, 4}};
  const Vec3<double> r = wrapped({-0.5, 3, 9}, box);
  CHECK(r == Vec3<double>{1.5, 0, 1});
  CHECK(wrapped(-1e-18, 2) == 2);  // rounded
  CHECK(wrapped(1.7, 0.1) == 0);   // x/edge rounds up to 17, and 17 · 0.1 > 1.7
}

namespace {

struct Point {
  Vec3<double> r;
  std::size_t number;
};

std::vector<Point> scattered(std::size_t count, const Box& box) {
  Random random(3);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back({scaled(box.edge, Vec3<double>{3 * x - 1, z, 2 * y - 1}), i});
  }
  return points;
}

}  // namespace

TEST_CASE("a cell list visits every close pair once, in boxes of one, two and many cells") {
  for (const Box& box : {Box{{1.5, 1.5, 1.5}}, Box{{1.5, 2.5, 9}}, Box{{6, 5, 4}}}) {
    const std::vector<Point> points = scattered(200, box);
    const CellList list(points, box, 1.0);
    std::map<std::pair<std::size_t, std::size_t>, int> visits;
    constexpr std::size_t shares = 3;
    for (std::size_t share = 0; share < shares; ++share)
      list.each_pair(
          [&](const Point& a, const Point& b) { ++visits[std::minmax(a.number, b.number)]; }, share,
          shares);
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = a + 1; b < points.size(); ++b)
        if (norm(box.minimum_image(points[a].r - points[b].r)) < 1.0) CHECK(visits[{a, b}] == 1);
    for (const auto& [pair, times] : visits) CHECK(times <= 1);
    if (box.volume() > 100) CHECK(visits.size() < 199 * 100);
  }
}
