// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/step_model.hpp"

#include <cmath>

#include "math/prediction.hpp"

namespace polhode {

StepModel::StepModel(int order, const std::vector<StepPoint>& points)
    : order_(order == 0 ? 2 : order) {
  std::vector<double> squares;
  for (const StepPoint& point : points) squares.push_back(point.step * point.step);
  mean_square_ = mean(squares).value;
  const std::size_t starts = points.front().ratios.size();
  double variance = 0;
  for (const StepPoint& point : points) {
    std::vector<double> logs;
    for (const double ratio : point.ratios) logs.push_back(std::log(ratio));
    const double error = mean(logs).error;
    variance += error * error * static_cast<double>(starts) / static_cast<double>(points.size());
  }
  scatter_ = std::sqrt(variance);
  for (std::size_t r = 0; r < starts; ++r) {
    std::vector<double> y;
    for (const StepPoint& point : points)
      y.push_back(std::log(point.ratios[r]) - order_ * std::log(point.step));
    lines_.push_back({mean(y).value, points.size() > 1 ? slope(squares, y).value : 0.0});
  }
}

double StepModel::value(const Line& line, double step) const {
  return line.at_mean + line.slope * (step * step - mean_square_) + order_ * std::log(step);
}

Estimate StepModel::log_ratio(double step) const {
  std::vector<double> values;
  for (const Line& line : lines_) values.push_back(value(line, step));
  return mean(values);
}

double StepModel::bound(double step, double probability) const {
  const Estimate log = log_ratio(step);
  const double t = t_quantile(probability, static_cast<double>(lines_.size() - 1));
  return std::exp(log.value + t * std::hypot(log.error, scatter_));
}

double StepModel::exponent(double step) const {
  double c = 0;
  for (const Line& line : lines_) c += line.slope / static_cast<double>(lines_.size());
  return order_ + 2 * c * step * step;
}

double StepModel::max_step(double ratio, double probability, double limit) const {
  // The search reduces the step in small decrements, because below the measured range of steps the
  // bound may increase again.
  constexpr double factor = 0.998;
  double step = limit;
  while (bound(step, probability) > ratio && step > 0.01 * limit) step *= factor;
  return step;
}

}  // namespace polhode
