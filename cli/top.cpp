// SPDX-License-Identifier: MIT
// polhode top: the rotation of one free top, exact and with NO_SQUISH, or a table of tops.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "polhode/base/error.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/rotor/free_rotation.hpp"
#include "streams.hpp"
#include "top_figure.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct TopOptions {
  std::vector<double> J, L;
  double step = 0, length = 0;
  std::string table, output;
  RotorMethod method = RotorMethod::series;
  bool json = false, force = false;
};

constexpr const char* axis_names[] = {"1", "2", "3"};

/// Rejects input that is not a rigid body, or not a possible motion of one. `name_J` and `name_L`
/// are the names used in the input: "I" and "L" in a table.
void check_top(const Vec3<double>& J, const Vec3<double>& L, double t, const std::string& name_J,
               const std::string& where) {
  const auto refuse = [&](const std::string& text, const std::string& key) {
    throw Error(text, where + ", " + key);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string moment = name_J + axis_names[k], momentum = std::string("L") + axis_names[k];
    if (!std::isfinite(J[k]) || J[k] < 0)
      refuse(fmt::format("{} = {} is not a principal moment: it must be finite and at least 0, as "
                         "a sum of masses times squares; give the moments of a mass distribution",
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
    refuse(fmt::format("{} of three moments are 0, at most one may be: two vanish only for a "
                       "point; give the moments of a body, or of a linear one",
                       zeros),
           name_J + "1 to " + name_J + "3");
  for (std::size_t k = 0; k < 3; ++k) {
    const double others = J[(k + 1) % 3] + J[(k + 2) % 3];
    // Moments often have only five digits, so flat bodies, J3 = J1 + J2, may fail by rounding.
    if (J[k] > others * (1 + 1e-4))
      refuse(fmt::format("{}{} = {} is larger than the sum of the other two moments, {}, which no "
                         "mass distribution allows; correct one of the three",
                         name_J, axis_names[k], J[k], others),
             name_J + axis_names[k]);
  }
}

std::vector<std::string> cells(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> out;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const auto first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
    out.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return out;
}

/// Converts the columns I1 I2 I3 L1 L2 L3 t of a CSV file to the text for stdout. All rows are
/// checked and computed before the first is written.
std::string rotate_table(const std::string& file, RotorMethod method) {
  std::ifstream in(file);
  if (!in) throw Error("the table cannot be opened; check its name and permissions", file);
  std::string line;
  if (!std::getline(in, line))
    throw Error(
        "the table is empty; its first line must contain the column names I1,I2,I3,L1,L2,L3,t",
        file);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  const std::vector<std::string> names = cells(line);
  constexpr std::array<const char*, 7> wanted{"I1", "I2", "I3", "L1", "L2", "L3", "t"};
  std::array<std::size_t, 7> column{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto found = std::find(names.begin(), names.end(), wanted[k]);
    if (found == names.end())
      throw Error(fmt::format("column {} is missing; the first line must contain "
                              "I1,I2,I3,L1,L2,L3,t, in any order, and may contain other columns",
                              wanted[k]),
                  file + ":1");
    column[k] = static_cast<std::size_t>(found - names.begin());
  }
  std::string text = "P11,P12,P13,P21,P22,P23,P31,P32,P33,qw,qx,qy,qz,Lf1,Lf2,Lf3\n";
  for (int number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> row = cells(line);
    if (row.empty() || (row.size() == 1 && row[0].empty())) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    std::array<double, 7> value{};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (column[k] >= row.size())
        throw Error(fmt::format("the row has {} columns, but {} is column {}; complete the row",
                                row.size(), wanted[k], column[k] + 1),
                    where);
      const std::string& cell = row[column[k]];
      char* end = nullptr;
      value[k] = std::strtod(cell.c_str(), &end);
      if (cell.empty() || *end != '\0')
        throw Error(fmt::format("'{}' is not a number; write one, for example 1.5e-3", cell),
                    where + ", " + wanted[k]);
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

/// State of one of the two integrators during the run, with its errors.
struct Track {
  Quaternion<double> attitude;
  Vec3<double> L;
  double energy_error = 0, momentum_error = 0;  ///< relative
  double angle = 0;                             ///< between its attitude and that of the closed
                                                ///< form

  void measure(const Vec3<double>& J, const Vec3<double>& L0, const FreeRotation& exact) {
    const auto energy = [&](const Vec3<double>& l) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += J[k] == 0 ? 0 : l[k] / J[k] * l[k];
      return sum;
    };
    const double E = energy(L0), l = norm(L0);
    energy_error = E == 0 ? 0 : energy(L) / E - 1;
    momentum_error = l == 0 ? 0 : norm(L) / l - 1;
    const Quaternion<double> off = conjugate(exact.rotation) * attitude;
    angle = 2 * std::atan2(norm(off.vector()), std::abs(off.w));
  }
};

struct TopLine {
  double t;
  FreeRotation exact;
  Track series, no_squish;
};

std::vector<TopLine> integrate_top(const Vec3<double>& J, const Vec3<double>& L, double step,
                                   double steps) {
  std::vector<TopLine> lines;
  const double shown = std::min(steps, 20.0);
  TopLine now{0, closed_rotation(J, L, 0), {{}, L}, {{}, L}};
  lines.push_back(now);
  double next = 1;
  for (double n = 1; n <= steps; ++n) {
    const auto advance = [&](Track& track, RotorMethod method) {
      const FreeRotation r = free_rotation(J, track.L, step, method);
      track.attitude = normalized(track.attitude * r.rotation);
      track.L = r.L;
    };
    advance(now.series, RotorMethod::series);
    advance(now.no_squish, RotorMethod::no_squish);
    if (n < std::floor(next * steps / shown)) continue;
    ++next;
    now.t = n * step;
    now.exact = closed_rotation(J, L, now.t);
    now.series.measure(J, L, now.exact);
    now.no_squish.measure(J, L, now.exact);
    lines.push_back(now);
  }
  return lines;
}

void print_lines(const std::vector<TopLine>& lines, double step, double angle) {
  fmt::print(
      "step {:.6g}: the top initially turns by {:.3g} per step; errors of energy and |L| are "
      "relative,\nattitude is the angle [rad] from the closed form\n\n",
      step, angle);
  fmt::print("{:>10}  {:^32}  {:^29}  {:^29}\n", "", "exact, closed form",
             "exact, series step by step", "NO_SQUISH step by step");
  fmt::print("{:>10} {:>10} {:>10} {:>10}  {:>9} {:>9} {:>9}  {:>9} {:>9} {:>9}\n", "t", "L1", "L2",
             "L3", "energy", "|L|", "attitude", "energy", "|L|", "attitude");
  for (const TopLine& line : lines)
    fmt::print(
        "{:10.4g} {:10.5g} {:10.5g} {:10.5g}  {:9.1e} {:9.1e} {:9.1e}  {:9.1e} {:9.1e} {:9.1e}\n",
        line.t, line.exact.L.x, line.exact.L.y, line.exact.L.z, line.series.energy_error,
        line.series.momentum_error, line.series.angle, line.no_squish.energy_error,
        line.no_squish.momentum_error, line.no_squish.angle);
}

void print_json(const std::vector<TopLine>& lines, double step) {
  nlohmann::json out{{"step", step}, {"rows", nlohmann::json::array()}};
  const auto track = [](const Track& t) {
    return nlohmann::json{{"energy_error", t.energy_error},
                          {"momentum_error", t.momentum_error},
                          {"attitude_error", t.angle}};
  };
  for (const TopLine& line : lines) {
    const Quaternion<double>& q = line.exact.rotation;
    out["rows"].push_back({{"t", line.t},
                           {"L", {line.exact.L.x, line.exact.L.y, line.exact.L.z}},
                           {"rotation", {q.w, q.x, q.y, q.z}},
                           {"series", track(line.series)},
                           {"no_squish", track(line.no_squish)}});
  }
  fmt::print("{}\n", out.dump(2));
}

int top(const TopOptions& options) {
  if (!options.table.empty()) {
    fmt::print("{}", rotate_table(options.table, options.method));
    return 0;
  }
  if (options.J.size() != 3 || options.L.size() != 3)
    throw Error(
        "a top needs three principal moments and three components of angular momentum: write for "
        "example --J 1,2,3 --L 0.1,0.2,1, or give --table FILE.csv",
        "--J, --L");
  const Vec3<double> J{options.J[0], options.J[1], options.J[2]};
  const Vec3<double> L{options.L[0], options.L[1], options.L[2]};
  check_top(J, L, 0, "J", "--J, --L");
  double speed = 0;
  for (std::size_t k = 0; k < 3; ++k) speed = std::hypot(speed, J[k] == 0 ? 0 : L[k] / J[k]);
  const double step = options.step != 0 ? options.step : speed == 0 ? 1 : 0.2 / speed;
  const double length = options.length != 0 ? options.length : 200 * step;
  if (!(step > 0) || !std::isfinite(step) || !(length >= step) || !(length / step <= 1e8))
    throw Error(fmt::format("step = {} and length = {} must give 1 to 100000000 steps; give a "
                            "positive step and a length of at least one step",
                            step, length),
                "--step, --length");
  const TopFigure figure(options.output);
  if (!options.output.empty())
    for (const std::string& file : figure.files()) refuse_existing(file, options.force);
  const std::vector<TopLine> lines =
      integrate_top(J, L, step, std::floor(length / step * (1 + 1e-12)));
  if (options.json)
    print_json(lines, step);
  else
    print_lines(lines, step, speed * step);
  if (!options.output.empty()) {
    draw_top(figure, J, L);
    log("wrote {}, {}, {} and {}\n", figure.svg, figure.png, figure.data, figure.script);
  }
  return 0;
}

}  // namespace

Action top_verb(CLI::App& app) {
  auto options = std::make_shared<TopOptions>();
  app.add_option("--J", options->J, "principal moments, for example 1,2,3; any consistent units")
      ->delimiter(',');
  app.add_option("--L", options->L, "body-frame angular momentum, for example 0.1,0.2,1")
      ->delimiter(',');
  app.add_option("--step", options->step, "time step; default: the top turns by 0.2 per step");
  app.add_option("--length", options->length, "length of the trajectory; default: 200 steps");
  app.add_option("--output", options->output,
                 "draw the polhode on the inertia ellipsoid: PREFIX.svg, .png, .dat, .gp");
  app.add_flag("--json", options->json, "print JSON");
  app.add_flag("--force", options->force, "overwrite existing files");
  app.add_option(
      "--table", options->table,
      "read tops from a CSV file with columns I1,I2,I3,L1,L2,L3,t and print their rotations");
  const std::map<std::string, RotorMethod> methods{
      {"series", RotorMethod::series},       {"closed", RotorMethod::closed},
      {"theta", RotorMethod::theta},         {"recursive", RotorMethod::recursive},
      {"no-squish", RotorMethod::no_squish}, {"symmetric-product", RotorMethod::symmetric_product}};
  app.add_option("--method", options->method,
                 "for --table: series (default), closed, theta, recursive, no-squish, "
                 "symmetric-product")
      ->transform(CLI::CheckedTransformer(methods).description(""));
  return [options] { return top(*options); };
}

}  // namespace polhode::cli
