// SPDX-License-Identifier: MIT
// Eigenvectors of small symmetric matrices: principal axes, the best-fit rotation between two sets
// of points, and modes of series.
#pragma once

#include <span>
#include <vector>

#include "polhode/base/quaternion.hpp"

namespace polhode {

struct Eigen3 {
  Vec3<double> values;   ///< eigenvalues in ascending order
  Mat3<double> vectors;  ///< eigenvectors as rows, orthonormal and right-handed
};

/// Eigenvalues and eigenvectors of a symmetric 3 × 3 matrix.
Eigen3 symmetric_eigen(const Mat3<double>& m);

/// Eigenvalues of a symmetric matrix in ascending order, each with its normalized eigenvector.
struct SymmetricEigen {
  std::vector<double> values;
  std::vector<std::vector<double>> vectors;
};

/// Computes the eigenvalues and eigenvectors of a symmetric matrix.
/// @param matrix  the n² elements of the matrix
SymmetricEigen symmetric_eigen(std::span<const double> matrix);

/// The rotation A (body → lab) that minimizes Σ w |A body − lab|² [horn1987, quaternion form]. Both
/// sets of points are relative to their weighted centres. For collinear points the result is one of
/// infinitely many equivalent rotations.
Quaternion<double> best_rotation(std::span<const Vec3<double>> body,
                                 std::span<const Vec3<double>> lab, std::span<const double> weight);

}  // namespace polhode
