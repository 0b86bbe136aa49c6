// SPDX-License-Identifier: MIT
#include "run/properties/svg_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double width = 480, height = 260, left = 70, right = 20, top = 10, bottom = 40;

/// A range of numbers with a small margin.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double x) {
    if (!std::isfinite(x)) return;
    low = std::min(low, x), high = std::max(high, x);
  }
  bool empty() const { return !(low <= high); }
  void widen(double share) {
    const double by = high > low ? share * (high - low) : std::max(1e-3, 0.01 * std::abs(low));
    low -= by, high += by;
  }
};

/// The distance between ticks: 1, 2 or 5 times a power of ten.
double tick_of(const Span& span) {
  const double rough = (span.high - span.low) / 5,
               power = std::pow(10, std::floor(std::log10(rough)));
  for (const double nice : {1.0, 2.0, 5.0})
    if (nice * power >= rough) return nice * power;
  return 10 * power;
}

class Canvas {
 public:
  explicit Canvas(const SvgFigure& figure) : figure_(figure) {
    for (const SvgCurve& curve : figure.curves)
      for (std::size_t k = 0; k < curve.x.size(); ++k) {
        if (!std::isfinite(curve.y[k])) continue;
        const double error = curve.error.empty() ? 0 : curve.error[k];
        x_.include(curve.x[k]);
        y_.include(curve.y[k] - error);
        y_.include(curve.y[k] + error);
      }
    if (empty()) return;
    if (figure.from_zero) x_.include(0);
    x_.widen(figure.from_zero ? 0 : 0.03);
    y_.widen(0.05);
  }
  bool empty() const { return x_.empty() || y_.empty(); }

  std::string text() const {
    std::string out = axes();
    for (const SvgCurve& curve : figure_.curves) out += band(curve) + line(curve);
    for (const double mark : figure_.marks)
      out +=
          fmt::format("<line class=\"mark\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>",
                      px(mark), top, height - bottom);
    return out;
  }

 private:
  double px(double x) const {
    return left + (x - x_.low) / (x_.high - x_.low) * (width - left - right);
  }
  double py(double y) const {
    return height - bottom - (y - y_.low) / (y_.high - y_.low) * (height - top - bottom);
  }
  std::string axes() const {
    std::string out =
        fmt::format("<rect class=\"axis\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", left,
                    top, width - left - right, height - top - bottom);
    for (double step = tick_of(x_), x = std::ceil(x_.low / step) * step; x <= x_.high; x += step)
      out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>", px(x),
                         height - bottom + 16, std::abs(x) < step / 2 ? 0 : x);
    for (double step = tick_of(y_), y = std::ceil(y_.low / step) * step; y <= y_.high; y += step)
      out += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>", left - 6,
                         py(y) + 4, std::abs(y) < step / 2 ? 0 : y);
    return out +
           fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       (left + width - right) / 2, height - 6, html(figure_.x_label)) +
           fmt::format(
               "<text transform=\"translate(14 {}) rotate(-90)\" "
               "text-anchor=\"middle\">{}</text>",
               (top + height - bottom) / 2, html(figure_.y_label));
  }
  std::string points(const SvgCurve& curve, double share, bool backwards = false) const {
    std::string out;
    for (std::size_t n = 0; n < curve.x.size(); ++n) {
      const std::size_t k = backwards ? curve.x.size() - 1 - n : n;
      if (!std::isfinite(curve.y[k])) continue;
      const double error = curve.error.empty() ? 0 : curve.error[k];
      out += fmt::format("{:.1f},{:.1f} ", px(curve.x[k]), py(curve.y[k] + share * error));
    }
    return out;
  }
  std::string line(const SvgCurve& curve) const {
    return fmt::format("<polyline class=\"curve\" points=\"{}\"/>", points(curve, 0));
  }
  std::string band(const SvgCurve& curve) const {
    return curve.error.empty() ? ""
                               : fmt::format("<polygon class=\"band\" points=\"{}{}\"/>",
                                             points(curve, 1), points(curve, -1, true));
  }

  const SvgFigure& figure_;
  Span x_, y_;
};

}  // namespace

std::string html(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&'   ? "&amp;"
           : c == '<' ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

std::string svg(const SvgFigure& figure) {
  const Canvas canvas(figure);
  if (canvas.empty()) return "";
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>"
      "<figcaption>{}</figcaption></figure>\n",
      width, height, html(figure.title), canvas.text(), html(figure.title));
}

}  // namespace polhode
