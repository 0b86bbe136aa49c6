// SPDX-License-Identifier: MIT
#include "math/eigen.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace polhode {

Eigen3 symmetric_eigen(const Mat3<double>& m) {
  Eigen::Matrix3d a;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      a(i, k) = m[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  const auto& v = solver.eigenvectors();
  const auto column = [&](int k) { return Vec3<double>{v(0, k), v(1, k), v(2, k)}; };
  const auto& w = solver.eigenvalues();
  const Vec3<double> first = column(0), second = column(1);
  return {{w(0), w(1), w(2)}, {first, second, cross(first, second)}};
}

SymmetricEigen symmetric_eigen(std::span<const double> matrix) {
  const auto n = std::lround(std::sqrt(static_cast<double>(matrix.size())));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::Map<const Eigen::MatrixXd>(matrix.data(), n, n));
  SymmetricEigen eigen;
  for (Eigen::Index k = 0; k < n; ++k) {
    eigen.values.push_back(solver.eigenvalues()(k));
    const auto vector = solver.eigenvectors().col(k);
    eigen.vectors.emplace_back(vector.begin(), vector.end());
  }
  return eigen;
}

Quaternion<double> best_rotation(std::span<const Vec3<double>> body,
                                 std::span<const Vec3<double>> lab,
                                 std::span<const double> weight) {
  Eigen::Matrix3d s = Eigen::Matrix3d::Zero();  // S_ab = Σ w body_a lab_b
  for (std::size_t i = 0; i < body.size(); ++i)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        s(a, b) +=
            weight[i] * body[i][static_cast<std::size_t>(a)] * lab[i][static_cast<std::size_t>(b)];
  Eigen::Matrix4d n;
  n << s.trace(), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),  //
      s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),
      s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),
      s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);  // eigenvector of the largest eigenvalue
  return normalized(Quaternion<double>{q(0), q(1), q(2), q(3)});
}

}  // namespace polhode
