// SPDX-License-Identifier: MIT
// Free rotations compared with independent reference tables (reference/rotor/README.md,
// make_rows.py).
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "polhode/rotor/free_rotation.hpp"

using namespace polhode;

namespace {

struct TruthRow {
  std::string top;  ///< class of the top
  std::map<std::string, double> value;
  double operator()(const std::string& column) const { return value.at(column); }
};

constexpr const char* P_columns[3][3] = {
    {"P11", "P12", "P13"}, {"P21", "P22", "P23"}, {"P31", "P32", "P33"}};
constexpr const char* L_columns[3] = {"Lf1", "Lf2", "Lf3"};

std::vector<TruthRow> truth_rows(const std::string& file) {
  std::ifstream in(std::string(POLHODE_TEST_DATA) + "/rotor/" + file);
  REQUIRE(in.good());
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
      if (!cell.empty() && cell.back() == '\r')
        cell.pop_back();  // the table is from another source
      cells.push_back(cell);
    }
    return cells;
  };
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = split(line);
  std::vector<TruthRow> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line);
    TruthRow row{cells[0], {}};
    for (std::size_t k = 1; k < cells.size(); ++k)
      row.value[names[k]] = std::strtod(cells[k].c_str(), nullptr);
    rows.push_back(row);
  }
  return rows;
}

// A row's tolerances are 16 · 2⁻⁵³ (1 + k), where k is the change of the truth, in units of 2⁻⁵³,
// when every input changes by as much: no program with double input can have an error below 1 + k,
// and 16 allows about ten roundings that act like changes of inputs. That the test detects errors
// at all is shown by the last test case below.
double worst_error_over_tolerance(RotorMethod method, const std::string& file) {
  double worst = 0;
  for (const TruthRow& row : truth_rows(file)) {
    const Vec3<double> J{row("I1"), row("I2"), row("I3")}, L{row("L1"), row("L2"), row("L3")};
    const FreeRotation found = free_rotation(J, L, row("t"), method);
    const Mat3<double> P = matrix_S(found.rotation);
    const double norm_L = std::hypot(L.x, L.y, L.z);
    double error_P = 0, error_L = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        error_P = std::fmax(error_P, std::abs(P[i][j] - row(P_columns[i][j])));
        CHECK(std::isfinite(P[i][j]));
      }
      const double change = std::abs(found.L[i] - row(L_columns[i]));
      error_L = std::fmax(error_L, norm_L == 0 ? change : change / norm_L);
      CHECK(std::isfinite(found.L[i]));
    }
    if (method != RotorMethod::no_squish) {
      CAPTURE(row.top);
      CAPTURE(row("t"));
      CHECK(error_P <= row("tolP"));
      CHECK(error_L <= row("tolL"));
    }
    worst = std::fmax(worst, std::fmax(error_P / row("tolP"), error_L / row("tolL")));
  }
  return worst;
}

}  // namespace

TEST_CASE("the closed form agrees with the free rotor reference tables") {
  worst_error_over_tolerance(RotorMethod::closed, "free_rotor_truth.csv");
  worst_error_over_tolerance(RotorMethod::closed, "random_rows.csv");
}

TEST_CASE("the series with its fallback agrees with the free rotor reference tables") {
  worst_error_over_tolerance(RotorMethod::series, "free_rotor_truth.csv");
  worst_error_over_tolerance(RotorMethod::series, "random_rows.csv");
}

TEST_CASE("the closed form by theta functions agrees with the free rotor reference tables") {
  worst_error_over_tolerance(RotorMethod::theta, "free_rotor_truth.csv");
  worst_error_over_tolerance(RotorMethod::theta, "random_rows.csv");
}

// The other rows have constant L, or those for which ThetaIntegral::applies().
TEST_CASE(
    "theta functions are applicable to every row except symmetric tops and L within 1e-140 of an "
    "axis") {
  int served = 0;
  for (const char* file : {"free_rotor_truth.csv", "random_rows.csv"})
    for (const TruthRow& row : truth_rows(file)) {
      const Vec3<double> J{row("I1"), row("I2"), row("I3")}, L{row("L1"), row("L2"), row("L3")};
      const ScaledTop top(J, L, row("t"));
      if (J.x == 0 || J.y == 0 || J.z == 0 || Orbit::is_stationary(top)) continue;
      const bool symmetric = J.x == J.y || J.y == J.z || J.z == J.x;
      const Vec3<double> l{std::abs(L.x), std::abs(L.y), std::abs(L.z)};
      const double across = std::fmax(std::fmin(l.x, l.y), std::fmin(std::fmax(l.x, l.y), l.z));
      const bool along_axis = across < 1e-140 * std::fmax(l.x, std::fmax(l.y, l.z));
      const bool used = ThetaIntegral::applies(Orbit(top).modulus);
      CAPTURE(row.top);
      CHECK((used || symmetric || along_axis));
      served += used;
    }
  CHECK(served > 200);
}

TEST_CASE("the recursive method agrees with the free rotor reference tables") {
  worst_error_over_tolerance(RotorMethod::recursive, "free_rotor_truth.csv");
  worst_error_over_tolerance(RotorMethod::recursive, "random_rows.csv");
}

// 2E J_y = L² to the last bit: the period is infinite, and L approaches the middle axis. Tolerances
// are those of changes that stay on the separatrix (make_separatrix_rows.py).
TEST_CASE("tops exactly on the separatrix rotate correctly for any time") {
  const std::string file = "separatrix_rows.csv";
  std::size_t exact = 0, far = 0;
  for (const TruthRow& row : truth_rows(file)) {
    const ScaledTop top({row("I1"), row("I2"), row("I3")}, {row("L1"), row("L2"), row("L3")},
                        row("t"));
    const Orbit orbit(top);
    exact += orbit.modulus.complement == 0;
    far += std::abs(orbit.p * top.t) > 800;  // cosh overflows
  }
  CHECK(exact == truth_rows(file).size());
  CHECK(exact >= 300);
  CHECK(far >= 50);
  for (const RotorMethod method :
       {RotorMethod::closed, RotorMethod::series, RotorMethod::theta, RotorMethod::recursive})
    worst_error_over_tolerance(method, file);
}

TEST_CASE("the reference tables distinguish a second-order splitting from the exact rotation") {
  CHECK(worst_error_over_tolerance(RotorMethod::no_squish, "free_rotor_truth.csv") > 1e6);
}
