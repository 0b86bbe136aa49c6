// SPDX-License-Identifier: MIT
// Reorientation: autocorrelation functions of directions fixed in the body.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "measure/convergence.hpp"
#include "measure/time_correlation.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// A direction fixed in the body.
struct BodyAxis {
  std::string name;        ///< name of the axis: "axis 1", "dipole"
  Vec3<double> direction;  ///< unit vector in the body frame
};

/// The axes of a molecule: the principal axes and the dipole. A linear body has only the axis along
/// the molecule, and an atom has no axis.
std::vector<BodyAxis> body_axes(const Molecule& molecule);

class Reorientation {
 public:
  Reorientation(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  const std::vector<BodyAxis>& axes(std::size_t part) const { return parts_[part].axes; }

  /// The correlation function ⟨P_l(u(t) · u(t + lag))⟩ of an axis u, with the Legendre polynomials
  /// P₁(x) = x and P₂(x) = (3x² − 1)/2 [allen2017, section 2.7].
  /// @param rank  degree l, 1 or 2
  BlockMeans legendre(std::size_t part, std::size_t axis, int rank,
                      Workers& workers = Workers::serial());

 private:
  struct Part {
    std::size_t first, count;
    std::vector<BodyAxis> axes;
    std::vector<TimeCorrelation> correlations;
  };
  std::vector<Part> parts_;
};

/// Relaxation times of a correlation function that decays from 1 [ps].
struct RelaxationTimes {
  /// integral ∫ C dt: by the trapezoidal rule up to the end of the fit, and from the fitted
  /// exponential beyond
  SeriesEstimate integral;
  SeriesEstimate exponential;  ///< time constant of C ~ exp(−t/τ) between `from` and `to`
  double from = 0, to = 0;
  Convergence convergence;  ///< convergence of both times: the run must be `windows_of_lags` times
                            ///< as long as `to`
};

/// Computes the relaxation times. The exponential is fitted to C between 1/e and 1/e³. Between 1/e
/// and 1/e³, librations have decayed and the noise is still small. ln C is fitted by a line with
/// weights C², because the errors of C are all similar in this range. The result is empty if C does
/// not decay to 1/e³ within the available lags.
std::optional<RelaxationTimes> relaxation_times(const BlockMeans& correlation, double interval);

}  // namespace polhode
