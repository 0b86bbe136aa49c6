// SPDX-License-Identifier: MIT
#include "run/top/top_figure.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ostream>

#include "base/printable.hpp"
#include "base/version.hpp"
#include "io/figures/plot.hpp"
#include "io/files/write_file.hpp"
#include "polhode/base/error.hpp"
#include "polhode/rotor/free_rotor.hpp"
#include "run/output_files.hpp"

namespace polhode {
namespace {

using Curve = std::vector<Vec3<double>>;
constexpr double pi = std::numbers::pi;

/// The polhode: the angular velocity ω during one period of L. The polhode is a single point if L
/// is constant.
Curve polhode_of(const Vec3<double>& J, const Vec3<double>& L) {
  const ScaledTop top(J, L, 0);
  const auto omega = [&](const Vec3<double>& l) {
    return Vec3<double>{l.x / J.x, l.y / J.y, l.z / J.z};
  };
  if (Orbit::is_stationary(top)) return {omega(L)};
  const Orbit orbit(top);
  // At the separatrix the period is infinite, and the range from −10 to 10 of the argument u covers
  // nearly all of the loop.
  const double half = std::isinf(orbit.K) ? 10 : 2 * orbit.K;
  Curve curve;
  constexpr int points = 480;
  for (int n = 0; n <= points; ++n) {
    // points are denser where L moves slowly, because equal steps of u are close together near the
    // middle axis
    const double u = half * (2.0 * n / points - 1);
    curve.push_back(
        omega(top.in_units_of_caller(orbit.L_at(orbit.at(orbit.elapsed(u / orbit.p))))));
  }
  return curve;
}

/// Polhodes of the same energy but other values of L², on all sides of the ellipsoid; L²/2E is
/// between the principal moments.
std::vector<Curve> family(const Vec3<double>& J, double twice_E) {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](std::size_t i, std::size_t j) { return J[i] < J[j]; });
  const std::size_t low = axis[0], middle = axis[1], high = axis[2];
  std::vector<Curve> curves;
  // In the plane of the axes with the largest and the smallest moment, L_l²/J_l + L_h²/J_h = 2E and
  // L_l² + L_h² = 2E J.
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
         {1.0, -1.0}) {  // the separatrix consists of two plane ellipses through the middle axis
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

/// The circles of latitude of an ellipsoid.
std::vector<Curve> ellipsoid(const Vec3<double>& radius) {
  constexpr int rings = 64, sectors = 128;
  std::vector<Curve> circles;
  for (int i = 0; i <= rings; ++i) {
    const double a = pi * i / rings;
    Curve& circle = circles.emplace_back();
    for (int j = 0; j <= sectors; ++j) {
      const double b = 2 * pi * j / sectors;
      circle.push_back(
          scaled(radius, {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)}));
    }
  }
  return circles;
}

void write_data(std::ostream& out, const std::string& command, const Vec3<double>& J,
                const Vec3<double>& L, double twice_E) {
  fmt::print(
      out,
      "# polhode {}\n# command: {}\n"
      "# omega1 omega2 omega3; blocks: 0 ellipsoid, 1 polhodes of the same energy, 2 of this "
      "top,\n# 3 its omega\n",
      version(), printable(command));
  std::vector<Curve> same_energy = family(J, twice_E);
  same_energy.insert(same_energy.begin(),
                     Curve{{std::nan(""), 0, 0}});  // gnuplot needs a point in every block
  const std::vector<Curve> blocks[] = {
      ellipsoid({std::sqrt(twice_E / J.x), std::sqrt(twice_E / J.y), std::sqrt(twice_E / J.z)}),
      same_energy,
      {polhode_of(J, L)},
      {Curve{{L.x / J.x, L.y / J.y, L.z / J.z}}}};
  // A blank line ends a curve, and two blank lines separate blocks.
  for (const std::vector<Curve>& block : blocks) {
    if (&block != blocks) out << '\n';
    for (const Curve& curve : block) {
      for (const Vec3<double>& w : curve) fmt::print(out, "{:.7g} {:.7g} {:.7g}\n", w.x, w.y, w.z);
      out << '\n';
    }
  }
}

}  // namespace

TopFigure::TopFigure(const std::string& common, const OutputOptions& output)
    : prefix(common), command(output.command) {
  check_prefix(prefix);
  check_outputs(files(), output.existing);
}

void draw_top(const TopFigure& figure, const Vec3<double>& J, const Vec3<double>& L,
              const Callbacks& callbacks) {
  const double twice_E = L.x * L.x / J.x + L.y * L.y / J.y + L.z * L.z / J.z;
  if (!(twice_E > 0) || !std::isfinite(twice_E))
    throw Error(
        "the inertia ellipsoid of this top does not have three finite axes (J = 0, L = 0, or an "
        "overflow in these units); leave out the figure");
  write_file(figure.data(),
             [&](std::ostream& out) { write_data(out, figure.command, J, L, twice_E); });
  pass_messages(callbacks, [&](std::ostream& warnings) {
    polhode_plot({figure.data(), J, L}, warnings);
  });
}

}  // namespace polhode
