// SPDX-License-Identifier: MIT
#include "polhode/math/distances.hpp"

#include <cmath>

#include "../errors.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/shape.hpp"

using namespace polhode;

namespace {

std::vector<Distance> all_distances(const Shape& shape) {
  std::vector<Distance> list;
  for (std::size_t i = 0; i < shape.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) list.push_back({k, i, norm(shape[i] - shape[k])});
  return list;
}

const Shape water = {{0, 0, 0}, {0.1, 0, 0}, {-0.0333, 0.0943, 0}};
const Shape rod = {{0, 0, 0}, {0.116, 0, 0}, {-0.116, 0, 0}};
const Shape chiral = {
    {0, 0, 0}, {0.1, 0, 0}, {0.02, 0.15, 0}, {0.03, 0.04, 0.12}, {-0.1, -0.02, 0.05}};

}  // namespace

TEST_CASE("all distances of a shape determine it, except for its mirror image") {
  for (const auto& [shape, dimension] : {std::pair{water, 2}, {rod, 1}, {chiral, 3}}) {
    const PlacedPoints found = place_points(shape.size(), all_distances(shape));
    CHECK(found.dimension == dimension);
    // Roots of differences of squares, each about 1e-2 nm², lose half of the digits at worst.
    CHECK(std::min(difference(found.points, shape), difference(mirror_image(found.points), shape)) <
          1e-8);
  }
  CHECK(place_points(1, {}).points.size() == 1);
}

TEST_CASE("a plane of six points stays a plane although its distances are rounded") {
  Shape ring;
  for (int k = 0; k < 6; ++k)
    ring.push_back({0.14 * std::cos(k * units::pi / 3), 0.14 * std::sin(k * units::pi / 3), 0});
  std::vector<Distance> some;
  for (const Distance& d : all_distances(ring))
    some.push_back({d.first, d.second, std::round(d.length * 1e5) / 1e5});
  const PlacedPoints found = place_points(6, some);
  CHECK(found.dimension == 2);  // although each length is rounded to five decimals
  CHECK(difference(found.points, ring) < distance_tolerance);
}

TEST_CASE(
    "distances that determine no shape are refused with the undetermined point or the wrong "
    "distance") {
  const auto refused = [](std::size_t count, std::vector<Distance> list,
                          std::initializer_list<const char*> parts) {
    check_error([&] { place_points(count, list); }, parts);
  };
  refused(3, {{0, 1, 0.1}, {0, 2, 0.1}},
          {"2 distances do not determine the positions of 3 points", "can still move"});
  refused(2, {}, {"0 distances do not determine the positions of 2 points"});
  refused(3, {{0, 1, 0.1}, {0, 2, 0.1}, {1, 2, 0.3}},
          {"the distance between points", "the other distances give"});
  refused(2, {{0, 1, 0}}, {"the distance between points 1 and 2 is 0 nm; it must be above 0 nm"});
  auto list = all_distances(chiral);
  list[5].length += 0.01;
  refused(5, list, {"or no such shape exists"});
  // A hinge: two triangles with a common edge fold.
  refused(4, {{0, 1, 0.1}, {0, 2, 0.1}, {1, 2, 0.1}, {1, 3, 0.1}, {2, 3, 0.1}, {0, 3, 0.3}},
          {"the distance between points"});
}

TEST_CASE("a nearly linear shape is made linear, others are unchanged") {
  Shape bent = rod;
  bent[0].y = 0.0015;
  const Shape line = straighten(bent);
  CHECK(norm(cross(line[1] - line[0], line[2] - line[0])) < 1e-16);
  CHECK(difference(line, bent) < 0.002);
  CHECK(difference(straighten(water), water) < 1e-15);
}
