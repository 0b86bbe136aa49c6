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
  std::string name;        ///< "axis 1", "dipole"
  Vec3<double> direction;  ///< unit vector, body frame
};

/// The principal axes and the dipole. A linear body has only its own axis, an atom none.
std::vector<BodyAxis> body_axes(const Molecule& molecule);

class Reorientation {
 public:
  Reorientation(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  const std::vector<BodyAxis>& axes(std::size_t part) const { return parts_[part].axes; }

  /// ⟨P_l(u(t) · u(t + lag))⟩ for an axis u, with Legendre's P₁(x) = x and P₂(x) = (3x² − 1)/2
  /// [allen2017, section 2.7].
  /// @param rank  1 or 2
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
  /// ∫ C dt: trapezoidal rule up to the end of the fit, the exponential beyond
  SeriesEstimate integral;
  SeriesEstimate exponential;  ///< of C ~ exp(−t/τ) between `from` and `to`
  double from = 0, to = 0;
  Convergence convergence;  ///< of both; the run has `windows_of_lags` times the lag `to`
};

/// The exponential is fitted where C is between 1/e and 1/e³: librations have decayed by then, and
/// the noise is still small. ln C is fitted by a line with weights C², since the errors of C are
/// all similar there. Empty if C does not decay to 1/e³ within its lags.
std::optional<RelaxationTimes> relaxation_times(const BlockMeans& correlation, double interval);

}  // namespace polhode
