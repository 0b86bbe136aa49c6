// SPDX-License-Identifier: MIT
// The numbers of an analysis: what is read off its curves.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/run/analysis.hpp"

namespace polhode {

/// What frames do not tell.
struct SummarySettings {
  std::optional<FitWindow> fit;       ///< of diffusion; without it from a fifth of the lags on
  std::optional<double> temperature;  ///< [K]; without it that of the velocities
  std::optional<double> viscosity;    ///< [u/(nm ps)]; without it the published one, if any
  std::optional<double> surrounding;  ///< permittivity around the system: `tin_foil`, or a field's
  std::string no_surrounding;         ///< why there is none
};

struct AxisRelaxation {
  std::string axis;
  std::array<std::optional<RelaxationTimes>, 2> rank;  ///< P1, P2; none if not decayed
};

/// How the bodies of one part of the topology move.
struct PartSummary {
  std::string molecule;
  std::size_t count = 0;
  std::optional<Estimate> diffusion;   ///< from displacements, in this box [nm²/ps]
  std::optional<Estimate> green_kubo;  ///< from velocities, integrated over all lags [nm²/ps]
  std::vector<AxisRelaxation> axes;
};

struct AnalysisSummary {
  std::optional<double> temperature;  ///< [K]
  FitWindow fit;                      ///< of diffusion [ps]
  std::optional<double> viscosity;    ///< [u/(nm ps)]
  std::string viscosity_source;       ///< "--viscosity", or whose; else why there is none
  std::optional<double> drag;         ///< of images, to be added to diffusion [nm²/ps]
  std::vector<PartSummary> parts;
  std::vector<RadialDistribution::Peak> peaks;  ///< of each pair
  std::optional<TotalDipole::Result> dielectric;
  std::vector<std::string> notes;  ///< those of the analysis, and what could not be computed
};

AnalysisSummary summary(Analysis& analysis, const SummarySettings& settings,
                        Workers& workers = Workers::serial());

}  // namespace polhode
