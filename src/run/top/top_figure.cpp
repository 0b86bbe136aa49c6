// SPDX-License-Identifier: MIT
#include "polhode/run/top/top_figure.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <ostream>

#include "polhode/base/error.hpp"
#include "polhode/io/gnuplot_text.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/rotor/free_rotor.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

using Curve = std::vector<Vec3<double>>;
constexpr double pi = std::numbers::pi;

/// Viewing direction [degrees], as in gnuplot's `set view`.
constexpr double tilt = 68, turn = 128;

/// Whether a point of the ellipsoid faces the viewer, i.e. its normal J ω points towards them.
bool is_visible(const Vec3<double>& J, const Vec3<double>& w) {
  const double a = tilt * pi / 180, b = turn * pi / 180;
  const Vec3<double> viewer{std::sin(a) * std::sin(b), -std::sin(a) * std::cos(b), std::cos(a)};
  return dot(scaled(J, w), viewer) > 0;
}

/// ω along the loop of L, once around; a single point if L is constant.
Curve polhode_of(const Vec3<double>& J, const Vec3<double>& L) {
  const ScaledTop top(J, L, 0);
  const auto omega = [&](const Vec3<double>& l) {
    return Vec3<double>{l.x / J.x, l.y / J.y, l.z / J.z};
  };
  if (Orbit::is_stationary(top)) return {omega(L)};
  const Orbit orbit(top);
  // On the separatrix the period is infinite: u from −10 to 10 covers nearly all of the loop.
  const double half = std::isinf(orbit.K) ? 10 : 2 * orbit.K;
  Curve curve;
  constexpr int points = 480;
  for (int n = 0; n <= points; ++n) {
    // denser where L moves slowly: equal steps of u are close together near the middle axis
    const double u = half * (2.0 * n / points - 1);
    curve.push_back(
        omega(top.in_units_of_caller(orbit.L_at(orbit.at(orbit.elapsed(u / orbit.p))))));
  }
  return curve;
}

/// Polhodes of the same energy, with L²/2E between the moments, on all sides of the ellipsoid.
std::vector<Curve> family(const Vec3<double>& J, double twice_E) {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](std::size_t i, std::size_t j) { return J[i] < J[j]; });
  const auto [low, middle, high] = axis;
  std::vector<Curve> curves;
  // In the plane of the extreme axes: L_l²/J_l + L_h²/J_h = 2E and L_l² + L_h² = 2E J.
  const auto start = [&](double moment) {
    Vec3<double> L;
    const double part = (moment - J[low]) / (J[high] - J[low]);
    L[high] = std::sqrt(twice_E * J[high] * part);
    L[low] = std::sqrt(twice_E * J[low] * (1 - part));
    return L;
  };
  const auto add = [&](double moment) {
    const Vec3<double> L = start(moment);
    for (const double s : {1.0, -1.0}) {
      Vec3<double> other = L;
      other[moment > J[middle] ? high : low] *= s;
      curves.push_back(polhode_of(J, other));
    }
  };
  for (const double f : {0.06, 0.22, 0.45, 0.7, 0.9}) {
    if (J[middle] > J[low]) add(J[low] + f * (J[middle] - J[low]));
    if (J[high] > J[middle]) add(J[high] + f * (J[middle] - J[high]));
  }
  if (J[middle] > J[low] && J[high] > J[middle]) {
    for (const double s :
         {1.0, -1.0}) {  // the separatrix: two plane ellipses through the middle axis
      const Vec3<double> L = start(J[middle]);
      Curve ellipse;
      for (int n = 0; n <= 480; ++n) {
        const double angle = 2 * pi * n / 480;
        Vec3<double> w;
        w[low] = L[low] / J[low] * std::sin(angle);
        w[high] = s * L[high] / J[high] * std::sin(angle);
        w[middle] = std::sqrt(twice_E / J[middle]) * std::cos(angle);
        ellipse.push_back(w);
      }
      curves.push_back(ellipse);
    }
  }
  return curves;
}

std::string data_text(const Vec3<double>& J, const Vec3<double>& L, double twice_E) {
  const Vec3<double> radius{std::sqrt(twice_E / J.x), std::sqrt(twice_E / J.y),
                            std::sqrt(twice_E / J.z)};
  std::string text = fmt::format(
      "# polhode top --J {},{},{} --L {},{},{}\n"
      "# omega1 omega2 omega3; blocks: 0 ellipsoid, 1 and 2 family behind and in front, 3 and 4 "
      "this "
      "top,\n# 5 the present omega\n",
      J.x, J.y, J.z, L.x, L.y, L.z);
  const auto point = [&](const Vec3<double>& w) {
    text += fmt::format("{:.7g} {:.7g} {:.7g}\n", w.x, w.y, w.z);
  };
  constexpr int rings = 64, sectors = 128;
  for (int i = 0; i <= rings; ++i) {
    const double a = pi * i / rings;
    for (int j = 0; j <= sectors; ++j) {
      const double b = 2 * pi * j / sectors;
      point(scaled(radius, {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)}));
    }
    text += '\n';
  }
  const auto block = [&](const std::vector<Curve>& curves, bool visible) {
    text += '\n';
    bool any_point = false;
    for (const Curve& curve : curves) {
      for (const Vec3<double>& w : curve) {
        if (is_visible(J, w) == visible) {
          point(w * 1.002);  // just above the surface
          any_point = true;
        } else {
          text += '\n';
        }
      }
      text += '\n';
    }
    if (!any_point) text += "NaN NaN NaN\n\n";
  };
  // Two blank lines would start a new block.
  const auto squeeze_blank_lines = [&](std::size_t from) {
    std::string out;
    for (std::size_t k = from; k < text.size(); ++k)
      if (!(text[k] == '\n' && out.size() >= 2 && out[out.size() - 1] == '\n' &&
            out[out.size() - 2] == '\n'))
        out += text[k];
    text.resize(from);
    while (!out.empty() && out.front() == '\n') out.erase(out.begin());
    text += '\n' + out;
  };
  const std::vector<Curve> others = family(J, twice_E);
  const std::vector<Curve> own{polhode_of(J, L)};
  for (const auto& [curves, visible] :
       {std::pair{&others, false}, {&others, true}, {&own, false}, {&own, true}}) {
    const std::size_t from = text.size();
    block(*curves, visible);
    squeeze_blank_lines(from);
  }
  text += '\n';
  point(Vec3<double>{L.x / J.x, L.y / J.y, L.z / J.z} * 1.004);
  return text;
}

/// Settings of the plot, whose axes end at 1.22 of the largest omega.
std::string settings_text(const TopFigure& figure, double max_omega) {
  const double plot_range = 1.22 * max_omega;
  return fmt::format(
      R"(# Drawn by: gnuplot {}
set view {}, {}, 1.72
set origin 0,-0.03
set view equal xyz
unset border
unset xtics
unset ytics
unset ztics
unset key
unset colorbox
set cbrange [-1:1]
set xyplane at {:.6g}
set xrange [{:.6g}:{:.6g}]
set yrange [{:.6g}:{:.6g}]
set zrange [{:.6g}:{:.6g}]
set pm3d depthorder lighting primary 0.28 specular 0.1
set lmargin 0
set rmargin 0
set bmargin 0
set tmargin 0
set palette defined (0 '#e9eef5', 1 '#cfdbe8')
)",
      gnuplot_comment(fs::path(figure.script).filename().string()), tilt, turn, -plot_range,
      -plot_range, plot_range, -plot_range, plot_range, -plot_range, plot_range);
}

/// Axes and title.
std::string marks_text(const Vec3<double>& J, const Vec3<double>& L, double twice_E,
                       double max_omega) {
  std::string marks;
  const std::array<const char*, 3> names{"1", "2", "3"};
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3<double> from, to, label;
    from[k] = std::sqrt(twice_E / J[k]);
    to[k] = from[k] + 0.24 * max_omega;
    label[k] = to[k] + 0.09 * max_omega;
    marks += fmt::format(
        "set arrow from {:.6g},{:.6g},{:.6g} to {:.6g},{:.6g},{:.6g} head filled size screen "
        "0.012,18 lc rgb '#555555' lw 1.2 front\n"
        "set label '{{/:Italic ω}}_{}' at {:.6g},{:.6g},{:.6g} center front tc rgb '#333333'\n",
        from.x, from.y, from.z, to.x, to.y, to.z, names[k], label.x, label.y, label.z);
  }
  marks += fmt::format(
      "set label \"{{/:Italic J}} = ({:.5g}, {:.5g}, {:.5g})   {{/:Italic L}} = ({:.5g}, {:.5g}, "
      "{:.5g})   {{/:Italic L}}²/2{{/:Italic E}} = {:.5g}\" at screen 0.5,0.955 center tc rgb "
      "'#333333'\n",
      J.x, J.y, J.z, L.x, L.y, L.z, norm2(L) / twice_E);
  return marks;
}

std::string script_text(const TopFigure& figure, const Vec3<double>& J, const Vec3<double>& L,
                        double twice_E) {
  const double max_omega = std::sqrt(twice_E / std::min({J.x, J.y, J.z}));
  // Lines are drawn after the surface, which would otherwise hide them.
  const std::string plot = fmt::format(
      "set multiplot\n"
      "splot {0} index 0 using 1:2:3:(0) with pm3d\n"
      "{1}"
      "splot {0} index 2 with lines lc rgb '#6f8aa8' lw 1.1, \\\n"
      "      {0} index 4 with lines lc rgb '#c8352b' lw 3.4, \\\n"
      "      {0} index 5 with points pt 7 ps 2 lc rgb '#8e1f18'\n"
      "unset multiplot\nunset label\nunset arrow\n",
      gnuplot_file(figure.data), marks_text(J, L, twice_E, max_omega));
  return settings_text(figure, max_omega) +
         fmt::format(
             "set terminal svg size 900,820 enhanced font 'Helvetica,17' background '#ffffff'\n"
             "set output {}\n{}",
             gnuplot_file(figure.svg), plot) +
         fmt::format(
             "set terminal pngcairo size 1800,1640 enhanced font 'Helvetica,17' fontscale 2 "
             "linewidth 2\nset output {}\n{}",
             gnuplot_file(figure.png), plot);
}

}  // namespace

void draw_top(const TopFigure& figure, const Vec3<double>& J, const Vec3<double>& L,
              const Callbacks& callbacks) {
  const double twice_E = L.x * L.x / J.x + L.y * L.y / J.y + L.z * L.z / J.z;
  if (!(twice_E > 0) || !std::isfinite(twice_E))
    throw Error(
        "the inertia ellipsoid of this top has no three finite axes (J = 0, L = 0, or overflow in "
        "these units), so it cannot be drawn; leave out the figure");
  write_file(figure.data, [&](std::ostream& out) { out << data_text(J, L, twice_E); });
  write_file(figure.script, [&](std::ostream& out) { out << script_text(figure, J, L, twice_E); });
  pass_messages(callbacks, [&](std::ostream& warnings) { run_gnuplot(figure.script, warnings); });
}

}  // namespace polhode
