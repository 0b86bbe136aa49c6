// SPDX-License-Identifier: MIT
// A picture of a top's polhode on its inertia ellipsoid.
#pragma once

#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode::cli {

/// The files that a picture consists of, all beside each other.
struct TopFigure {
  std::string data, script, svg, png;
  explicit TopFigure(const std::string& prefix)
      : data(prefix + ".dat"), script(prefix + ".gp"), svg(prefix + ".svg"), png(prefix + ".png") {}
  std::vector<std::string> files() const { return {data, script, svg, png}; }
};

/// Writes data and script and lets gnuplot draw the picture: the ellipsoid Σ J_k ω_k² = 2E
/// (Poinsot), the polhodes of other angular momenta at the same energy faint, the one of this top
/// bold.
///
/// @param J  three positive principal moments, any consistent units
/// @param L  body-frame angular momentum, not zero
/// Without gnuplot a warning tells how to draw it later.
/// @throws Error  if a moment or L vanishes, or a file cannot be written
void draw_top(const TopFigure& figure, const Vec3<double>& J, const Vec3<double>& L);

}  // namespace polhode::cli
