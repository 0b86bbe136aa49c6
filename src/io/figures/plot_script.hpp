// SPDX-License-Identifier: MIT
// gnuplot scripts: definitions of values, followed by a template from data/plots that plots the
// data.
#pragma once

#include <string>
#include <vector>

#include "io/figures/plot.hpp"

namespace polhode {

/// An image to be drawn.
struct Image {
  std::string name;    ///< name of the image file
  std::string format;  ///< format: "svg" or "png"
};

std::string script_of(const EnergyFigure& figure, const Image& image);
std::string script_of(const CurvesFigure& figure, const Image& image);
std::string script_of(const EfficiencyFigure& figure, const Image& image);
std::string script_of(const AdviceFigure& figure, const Image& image);
std::string script_of(const CanonicalFigure& figure, const Image& image);
std::string script_of(const PolhodeFigure& figure, const Image& image);

}  // namespace polhode
