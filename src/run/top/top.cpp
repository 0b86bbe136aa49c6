// SPDX-License-Identifier: MIT
#include "polhode/run/top/top.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <utility>

#include "io/files/split_words.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr const char* axis_names[] = {"1", "2", "3"};

void measure(TopTrack& track, const Vec3<double>& J, const Vec3<double>& L0,
             const FreeRotation& exact) {
  const auto energy = [&](const Vec3<double>& l) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += J[k] == 0 ? 0 : l[k] / J[k] * l[k];
    return sum;
  };
  const double E = energy(L0), l = norm(L0);
  track.energy_error = E == 0 ? 0 : energy(track.L) / E - 1;
  track.momentum_error = l == 0 ? 0 : norm(track.L) / l - 1;
  const Quaternion<double> off = conjugate(exact.rotation) * track.orientation;
  track.angle = 2 * std::atan2(norm(off.vector()), std::abs(off.w));
}

constexpr double steps_between_stops = 4096;  // number of steps between calls of stop(), about a
                                              // millisecond

/// Integrates a number of steps and adds their samples to the trajectory.
void integrate(TopTrajectory& trajectory, const Vec3<double>& J, const Vec3<double>& L,
               double steps, const std::function<bool()>& stop) {
  const double step = trajectory.step;
  std::vector<TopSample>& samples = trajectory.samples;
  const double shown = std::min(steps, 20.0);
  TopSample now{0, closed_rotation(J, L, 0), {{}, L}, {{}, L}};
  samples.push_back(now);
  double next = 1;
  for (double n = 1; n <= steps; ++n) {
    trajectory.interrupted = stop && std::fmod(n, steps_between_stops) == 0 && stop();
    if (trajectory.interrupted) return;
    const auto advance = [&](TopTrack& track, RotorMethod method) {
      const FreeRotation r = free_rotation(J, track.L, step, method);
      track.orientation = normalized(track.orientation * r.rotation);
      track.L = r.L;
    };
    advance(now.series, RotorMethod::series);
    advance(now.no_squish, RotorMethod::no_squish);
    if (n < std::floor(next * steps / shown)) continue;
    ++next;
    now.t = n * step;
    now.exact = closed_rotation(J, L, now.t);
    measure(now.series, J, L, now.exact);
    measure(now.no_squish, J, L, now.exact);
    samples.push_back(now);
  }
}

/// The cells of a line; a comma at the end of a line adds no cell.
std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> parts = parts_of(line, ',');
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

}  // namespace

void check_top(const Vec3<double>& J, const Vec3<double>& L, double t, const std::string& name_J,
               const std::string& where) {
  const auto refuse = [&](const std::string& text, const std::string& key) {
    throw Error(text, where + ", " + key);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string moment = name_J + axis_names[k], momentum = std::string("L") + axis_names[k];
    if (!std::isfinite(J[k]) || J[k] < 0)
      refuse(fmt::format(
                 "{} = {} is not a principal moment of inertia; it must be finite and at least 0",
                 moment, J[k]),
             moment);
    if (!std::isfinite(L[k]))
      refuse(fmt::format("{} = {} is not finite; give a finite number", momentum, L[k]), momentum);
    if (J[k] == 0 && L[k] != 0)
      refuse(
          fmt::format("{} = {} must be 0 where {} = 0: a linear body cannot spin about its axis; "
                      "set {} = 0",
                      momentum, L[k], moment, momentum),
          momentum);
  }
  if (!std::isfinite(t)) refuse(fmt::format("t = {} is not finite; give a finite number", t), "t");
  const int zeros = (J.x == 0) + (J.y == 0) + (J.z == 0);
  if (zeros > 1)
    refuse(fmt::format("{} of the three moments of inertia are 0; at most one may be 0: give the "
                       "moments of a linear or nonlinear body",
                       zeros),
           name_J + "1 to " + name_J + "3");
  for (std::size_t k = 0; k < 3; ++k) {
    const double others = J[(k + 1) % 3] + J[(k + 2) % 3];
    // Moments often have only five digits, so flat bodies with J3 = J1 + J2 may violate the
    // inequality because of rounding.
    if (J[k] > others * (1 + 1e-4))
      refuse(fmt::format("{}{} = {} is larger than the sum of the other two moments, {}; no mass "
                         "distribution has such moments: correct one of the three",
                         name_J, axis_names[k], J[k], others),
             name_J + axis_names[k]);
  }
}

TopTrajectory integrate_top(const Vec3<double>& J, const Vec3<double>& L, double step,
                            double length, const std::function<bool()>& stop) {
  check_top(J, L, 0, "J", "J, L");
  double speed = 0;
  for (std::size_t k = 0; k < 3; ++k) speed = std::hypot(speed, J[k] == 0 ? 0 : L[k] / J[k]);
  if (step == 0) step = speed == 0 ? 1 : 0.2 / speed;
  if (length == 0) length = 200 * step;
  if (!(step > 0) || !std::isfinite(step) || !(length >= step) || !(length / step <= 1e8))
    throw Error(fmt::format("step = {} and length = {} must give 1 to 100000000 steps; give a "
                            "positive step and a length of at least one step",
                            step, length),
                "step, length");
  TopTrajectory trajectory{step, speed * step, {}};
  integrate(trajectory, J, L, std::floor(length / step * (1 + 1e-12)), stop);
  return trajectory;
}

Quantities quantities(const TopTrajectory& top) {
  std::vector<Quantities> samples;
  for (const TopSample& s : top.samples) {
    const auto number = [](const char* label, double x, int digits) {
      return Quantity{"", "", x, "", label, "", "", digits};
    };
    samples.push_back({number("t", s.t, 4), number("L1", s.exact.L.x, 5),
                       number("L2", s.exact.L.y, 5), number("L3", s.exact.L.z, 5)});
    for (const auto& [name, track] :
         {std::pair("series", &s.series), {"NO_SQUISH", &s.no_squish}}) {
      const auto error = [&, of = std::string(name) + ": "](const char* what, double x) {
        samples.back().push_back(number((of + what).c_str(), x, 2));
      };
      error("energy", track->energy_error);
      error("|L|", track->momentum_error);
      error("orientation", track->angle);
    }
  }
  return {{"", "", samples, "",
           fmt::format("step {:.6g}, in which the top initially turns by {:.3g} rad\nL is computed "
                       "from the closed form. Errors of the step-by-step rotations: energy and |L| "
                       "relative,\norientation as the angle [rad] to the closed form",
                       top.step, top.angle)}};
}

std::string rotate_table(const std::string& file, RotorMethod method) {
  std::ifstream in(file);
  if (!in) throw Error("the table cannot be opened; check its name and permissions", file);
  std::string head, line;
  if (!std::getline(in, head))
    throw Error(
        "the table is empty; its first line must contain the column names I1,I2,I3,L1,L2,L3,t",
        file);
  const std::vector<std::string_view> names = cells(without_mark(head));
  constexpr std::array<const char*, 7> columns{"I1", "I2", "I3", "L1", "L2", "L3", "t"};
  std::array<std::size_t, 7> column{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto found = std::find(names.begin(), names.end(), columns[k]);
    if (found == names.end())
      throw Error(fmt::format("column {} is missing; the first line must contain "
                              "I1,I2,I3,L1,L2,L3,t, in any order, and may contain other columns",
                              columns[k]),
                  file + ":1");
    column[k] = static_cast<std::size_t>(found - names.begin());
  }
  std::string text = "P11,P12,P13,P21,P22,P23,P31,P32,P33,qw,qx,qy,qz,Lf1,Lf2,Lf3\n";
  for (int number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string_view> row = cells(line);
    if (row.empty() || (row.size() == 1 && row[0].empty())) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    std::array<double, 7> value{};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (column[k] >= row.size())
        throw Error(fmt::format("the row has {} columns, but {} is column {}; complete the row",
                                row.size(), columns[k], column[k] + 1),
                    where);
      const std::string cell(row[column[k]]);
      char* end = nullptr;
      value[k] = std::strtod(cell.c_str(), &end);
      if (cell.empty() || *end != '\0')
        throw Error(fmt::format("'{}' is not a number; write one, for example 1.5e-3", cell),
                    where + ", " + columns[k]);
    }
    const Vec3<double> J{value[0], value[1], value[2]}, L{value[3], value[4], value[5]};
    check_top(J, L, value[6], "I", where);
    const FreeRotation r = free_rotation(J, L, value[6], method);
    const Quaternion<double> q = r.rotation.w < 0 ? scaled(r.rotation, -1.0) : r.rotation;
    const Mat3<double> P = matrix_S(q);
    for (std::size_t i = 0; i < 3; ++i)
      text += fmt::format("{:.17g},{:.17g},{:.17g},", P[i].x, P[i].y, P[i].z);
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", q.w, q.x, q.y,
                        q.z, r.L.x, r.L.y, r.L.z);
  }
  return text;
}

}  // namespace polhode
