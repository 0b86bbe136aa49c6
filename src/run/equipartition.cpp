// SPDX-License-Identifier: MIT
#include "polhode/run/equipartition.hpp"

#include <cmath>

#include "polhode/io/nested_scheme_text.hpp"

namespace polhode {

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves) {
  std::vector<EquipartitionFit> fits;
  for (const Curve& curve : curves) {
    EquipartitionFit fit{.scheme = curve.scheme, .axes = {}};
    if (const int order = nested_scheme_of(curve.scheme).order(); order > 0) fit.order = order;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> x;
      std::vector<Estimate> y;
      for (std::size_t i = 0; i < curve.usable; ++i)
        if (const auto& excess = curve.points[i].excess[k]; excess && excess->error > 0) {
          x.push_back(std::pow(curve.points[i].step, fit.order));
          y.push_back(*excess);
        }
      if (x.size() > 1) fit.axes[k] = weighted_line(x, y);
    }
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace polhode
