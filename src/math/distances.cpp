// SPDX-License-Identifier: MIT
#include "polhode/math/distances.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

struct Neighbour {
  std::size_t point;
  double length;
};
using Neighbours = std::vector<std::vector<Neighbour>>;

// An affine frame: an origin and up to three orthonormal directions.
struct Frame {
  Vec3<double> origin;
  std::array<Vec3<double>, 3> axes{};
  std::size_t dimension = 0;

  Vec3<double> rest(const Vec3<double>& r) const {
    Vec3<double> off = r - origin;
    for (std::size_t k = 0; k < dimension; ++k) off -= dot(off, axes[k]) * axes[k];
    return off;
  }
  void add(const Vec3<double>& direction) { axes[dimension++] = direction / norm(direction); }
};

// Because distances d are rounded, a point may appear to be outside the span of the other points.
// For such a point, the height h above the span satisfies h² ≈ 2 d times the round-off error. A
// point that violates the triangle inequality has h² < 0, and is detected because its distances do
// not fit.
bool is_flat(double height2, double length) {
  return height2 < 2 * std::max(length, distance_rounding) * distance_rounding;
}

// The placed neighbours of a point, ordered so that their directions are well separated.
struct Support {
  Frame frame;
  std::vector<Neighbour> spanning;  // spanning neighbours, frame.dimension + 1 of them
};

class Placing {
 public:
  Placing(std::size_t count, const Neighbours& neighbours)
      : neighbours_(neighbours), points_(count), placed_(count, false) {}

  // Places all points, starting from `first`, and returns whether this was possible.
  bool from(std::size_t first) {
    std::fill(placed_.begin(), placed_.end(), false);
    space_ = {};
    points_[first] = space_.origin = {};
    placed_[first] = true;
    left_ = points_.size() - 1;
    for (bool moved = true; moved && left_ > 0;) {
      moved = false;
      for (std::size_t i = 0; i < points_.size(); ++i)
        if (!placed_[i] && place(i)) moved = true;
    }
    return left_ == 0;
  }
  // A point that the last attempt could not place.
  std::size_t loose() const {
    return static_cast<std::size_t>(std::find(placed_.begin(), placed_.end(), false) -
                                    placed_.begin());
  }
  PlacedPoints result() && { return {std::move(points_), static_cast<int>(space_.dimension)}; }

 private:
  Support support(std::size_t i) const {
    Support s;
    std::vector<Neighbour> known;
    for (const Neighbour& n : neighbours_[i])
      if (placed_[n.point]) known.push_back(n);
    if (known.empty()) return s;
    s.frame.origin = points_[known.front().point];
    s.spanning.push_back(known.front());
    while (s.frame.dimension < 3) {
      const Neighbour* farthest = nullptr;
      Vec3<double> direction{};
      for (const Neighbour& n : known) {
        const Vec3<double> rest = s.frame.rest(points_[n.point]);
        if (norm2(rest) > norm2(direction)) farthest = &n, direction = rest;
      }
      if (farthest == nullptr ||
          is_flat(norm2(direction), norm(points_[farthest->point] - s.frame.origin)))
        break;
      s.frame.add(direction);
      s.spanning.push_back(*farthest);
    }
    return s;
  }

  bool place(std::size_t i) {
    const Support s = support(i);
    if (s.spanning.empty()) return false;
    // The difference |r − b|² − |r|² of squared distances is linear in the position r. Each axis
    // gives one equation, and the system of equations is triangular by construction.
    const double d2 = s.spanning[0].length * s.spanning[0].length;
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < s.frame.dimension; ++k) {
      const Neighbour& n = s.spanning[k + 1];
      const Vec3<double> b = points_[n.point] - s.frame.origin;
      double right = (d2 - n.length * n.length + norm2(b)) / 2;
      for (std::size_t m = 0; m < k; ++m) right -= dot(b, s.frame.axes[m]) * c[m];
      c[k] = right / dot(b, s.frame.axes[k]);
    }
    Vec3<double> r = s.frame.origin;
    double height2 = d2;
    for (std::size_t k = 0; k < 3; ++k) r += c[k] * s.frame.axes[k], height2 -= c[k] * c[k];
    if (s.frame.dimension < 3 && !is_flat(height2, s.spanning[0].length)) {
      if (s.frame.dimension < space_.dimension) return false;
      // The new point is outside the span of all points placed so far, so it adds an axis to the
      // space.
      Vec3<double> up;
      up[space_.dimension] = 1;
      space_.add(up);
      r += std::sqrt(height2) * up;
    }
    for (const Neighbour& n : neighbours_[i])
      if (placed_[n.point]) check(i, n, norm(r - points_[n.point]));
    points_[i] = r;
    placed_[i] = true;
    --left_;
    return true;
  }

  void check(std::size_t i, const Neighbour& n, double found) const {
    if (std::abs(found - n.length) > distance_tolerance)
      throw Error(
          fmt::format("the distance between points {} and {} is {} nm, but the other distances "
                      "give {:.6f} nm; both must agree within {} nm, or no such shape exists",
                      i + 1, n.point + 1, n.length, found, distance_tolerance));
  }

  const Neighbours& neighbours_;
  std::vector<Vec3<double>> points_;
  std::vector<bool> placed_;
  Frame space_;  // span of all placed points
  std::size_t left_ = 0;
};

Neighbours neighbours_of(std::size_t count, std::span<const Distance> distances) {
  Neighbours neighbours(count);
  for (const Distance& d : distances) {
    if (!(d.length > 0) || !std::isfinite(d.length))
      throw Error(
          fmt::format("the distance between points {} and {} is {} nm; it must be above 0 nm",
                      d.first + 1, d.second + 1, d.length));
    neighbours[d.first].push_back({d.second, d.length});
    neighbours[d.second].push_back({d.first, d.length});
  }
  return neighbours;
}

}  // namespace

PlacedPoints place_points(std::size_t count, std::span<const Distance> distances) {
  const Neighbours neighbours = neighbours_of(count, distances);
  Placing placing(count, neighbours);
  for (std::size_t first = 0; first < count; ++first)
    if (placing.from(first)) return std::move(placing).result();
  if (count == 0) return {};
  throw Error(
      fmt::format("{} distances do not determine the positions of {} points: point {}, for "
                  "example, can still move",
                  distances.size(), count, placing.loose() + 1));
}

}  // namespace polhode
