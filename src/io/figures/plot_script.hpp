// SPDX-License-Identifier: MIT
// gnuplot scripts: values and data blocks, followed by a template from data/plots.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/figures/plot.hpp"

namespace polhode {

/// An image to be drawn.
struct Image {
  std::string name;    ///< of the file
  std::string format;  ///< "svg" or "png"
};

std::string energy_script(const EnergyFigure& figure, const std::string& csv, const Image& image);

std::string curves_script(const CurvesFigure& figure, const std::string& csv, const Image& image);

std::string efficiency_script(const EfficiencyFigure& figure, const Image& image);

std::string advice_script(const AdviceFigure& figure, const Image& image);

std::string canonical_script(const CanonicalFigure& figure, const Image& image);

std::string polhode_script(const PolhodeFigure& figure, const Image& image);

}  // namespace polhode
