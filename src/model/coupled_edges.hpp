// SPDX-License-Identifier: MIT
// Groups of box edges that a barostat scales by a common factor.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "polhode/base/vec3.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The group that a text names: "xy" means the edges x and y. The result is empty if the text is
/// not one or more of x, y and z, each at most once.
inline std::optional<CoupledEdges> coupled_edges(std::string_view text) {
  CoupledEdges edges{};
  for (const char c : text) {
    if (c < 'x' || c > 'z' || edges[static_cast<std::size_t>(c - 'x')]) return std::nullopt;
    edges[static_cast<std::size_t>(c - 'x')] = true;
  }
  return text.empty() ? std::nullopt : std::optional(edges);
}

/// Whether an edge is in more than one group.
inline bool overlap(std::span<const CoupledEdges> groups) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::ranges::count_if(groups, [&](const CoupledEdges& group) { return group[k]; }) > 1)
      return true;
  return false;
}

inline double count(const CoupledEdges& edges) {
  return static_cast<double>(std::ranges::count(edges, true));
}

/// The factor that scales the edges of a group so that the volume changes by `volume_ratio`.
inline double factor_of(const CoupledEdges& edges, double volume_ratio) {
  return std::pow(volume_ratio, 1 / count(edges));
}

/// The mean of the components of a vector along the edges of a group.
inline double mean_along(const CoupledEdges& edges, const Vec3<double>& v) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (edges[k]) sum += v[k];
  return sum / count(edges);
}

/// Whether the factors by which edges of different groups have changed since the first move stay
/// within a ratio. A single group cannot change the shape of the box.
/// @param moved         the group that the move scales by `factor`
/// @param edges, first  the box edges before the move, and before the first move
/// @param max_change    the largest ratio
inline bool keeps_shape(std::span<const CoupledEdges> groups, const CoupledEdges& moved,
                        double factor, const Vec3<double>& edges, const Vec3<double>& first,
                        double max_change) {
  if (groups.size() == 1) return true;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const CoupledEdges& group : groups)
    for (std::size_t k = 0; k < 3; ++k)
      if (group[k]) {
        const double change = edges[k] * (moved[k] ? factor : 1) / first[k];
        low = std::min(low, change);
        high = std::max(high, change);
      }
  return high <= max_change * low;
}

}  // namespace polhode
