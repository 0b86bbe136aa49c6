// SPDX-License-Identifier: MIT
// Generates gnuplot scripts.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/plot.hpp"

namespace polhode {

std::string energy_script(const std::string& csv, const std::string& image,
                          const std::string& title, const std::string& format);

std::string curves_script(const CurvesFigure& figure, const std::string& csv,
                          const std::string& image, const std::string& format);

std::string efficiency_script(const std::vector<EfficiencyCurve>& curves, const std::string& image,
                              const std::string& format, double highest);

std::string advice_script(const AdviceFigure& figure, const std::string& image,
                          const std::string& format);

}  // namespace polhode
