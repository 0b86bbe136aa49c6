// SPDX-License-Identifier: MIT
// Eigenvectors of small symmetric matrices: principal axes, the best-fit rotation between two sets
// of points, and modes of series.
#pragma once

#include <span>
#include <vector>

#include "polhode/base/quaternion.hpp"

namespace polhode {

struct Eigen3 {
  Vec3<double> values;   ///< ascending
  Mat3<double> vectors;  ///< rows, orthonormal, right-handed
};

/// Eigenvalues and eigenvectors of a symmetric 3 × 3 matrix.
Eigen3 symmetric_eigen(const Mat3<double>& m);

/// Ascending eigenvalues of a symmetric matrix, each with its eigenvector of length 1.
struct SymmetricEigen {
  std::vector<double> values;
  std::vector<std::vector<double>> vectors;
};

/// @param matrix  n² elements
SymmetricEigen symmetric_eigen(std::span<const double> matrix);

/// The rotation A (body → lab) that minimizes Σ w |A body − lab|² [horn1987, quaternion form]. Both
/// sets are relative to their weighted centres. For collinear sets it is one of the equivalent
/// rotations.
Quaternion<double> best_rotation(std::span<const Vec3<double>> body,
                                 std::span<const Vec3<double>> lab, std::span<const double> weight);

}  // namespace polhode
