// SPDX-License-Identifier: MIT
// A figure of a top's polhode on its inertia ellipsoid.
#pragma once

#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {

/// The files of a figure of a top, all in the same folder.
struct TopFigure {
  std::string prefix, command;
  /// Constructs the file names, and checks that the files can be written.
  /// @throws Error  if a file cannot be written, or exists and must not be replaced
  TopFigure(const std::string& common, const OutputOptions& output);
  std::string data() const { return prefix + ".dat"; }
  std::vector<std::string> files() const {
    return {prefix + ".svg", prefix + ".png", data(), prefix + ".gp"};
  }
};

/// Draws the figure of a top: writes data and script, and runs gnuplot. The figure shows Poinsot's
/// ellipsoid Σ J_k ω_k² = 2E. The polhode of this top is bold, and polhodes of other angular
/// momenta at the same energy are in a light colour. A second panel shows the corresponding curves
/// of L on Σ L_k²/J_k = 2E. If gnuplot is missing, a warning gives the command that draws the
/// figure later.
///
/// @param J  three positive principal moments in any consistent units
/// @param L  body-frame angular momentum, not zero
/// @throws Error  if a moment or L is zero, or a file cannot be written
void draw_top(const TopFigure& figure, const Vec3<double>& J, const Vec3<double>& L,
              const Callbacks& callbacks = {});

}  // namespace polhode
