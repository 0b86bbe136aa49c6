// SPDX-License-Identifier: MIT
// Prepares an equilibrated initial configuration from a composition, a temperature, and a pressure
// or density.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Properties measured in the second half of the last stage of a preparation.
struct PreparedProperties {
  RunSummary summary;
  SeriesEstimate density;          ///< mean density [u/nm³]
  std::optional<double> pressure;  ///< pressure that the barostat controls [kJ/mol/nm³]
  /// Compressibility from the volume fluctuations, if there is a barostat [nm³ mol/kJ]. This
  /// compressibility is known if the volume does not drift and the stage is at least 8 volume
  /// relaxation times long.
  SeriesEstimate compressibility{};
  double moves_compressibility = 0;  ///< compressibility that sets the size of barostat moves
                                     ///< [nm³ mol/kJ]
  std::vector<Warning> warnings{};   ///< warnings about probable mistakes
};

struct PreparationReport {
  std::size_t molecules = 0;
  double lattice_density = 0;  ///< density of the start lattice [u/nm³]; 0 if there is an initial
                               ///< configuration
  bool estimated = false;      ///< whether estimated_density() gave the density of the lattice
  Minimisation minimisation;
  /// Compressibility in the new run file [nm³ mol/kJ]; 0 if it was not estimated.
  double compressibility = 0;
  std::optional<PreparedProperties> properties;  ///< empty if the preparation was interrupted
  std::vector<std::string> files;                ///< paths of the files that were written
  std::string run_file, checkpoint;              ///< paths of the new run file and checkpoint;
                                                 ///< empty if not written
};

/// A rough estimate of the liquid density of these molecules [u/nm³]. The estimate assumes that
/// spheres of diameter σ about the sites fill 45 % of the volume. Spheres of the same molecule
/// overlap, and the overlap counts once. For liquids near their triple point this fraction is 43 %
/// (argon) to 55 % (water).
/// @throws Error  if no site has a diameter
double estimated_density(const Topology& topology);

/// Prepares the system of a run file:
/// 1. Molecules are placed on a lattice with their kinds shuffled, at the density or in the box of
///   [system]. If [system] has neither a density nor a box, estimated_density() gives the density.
///   In this case, a barostat is required. An initial configuration replaces the lattice.
/// 2. minimise() reduces forces to 100 kJ/mol/nm and torques to 10 kJ/mol.
/// 3. The NVT stage is Langevin dynamics by BAOAB [leimkuhler2013] at a 1 fs time step, with a
///   friction of 5/ps.
/// 4. If there is a barostat, the NPT stage is Langevin dynamics with barostat moves, at a time
///   step of at most 2 fs. If the run file gives no compressibility, the compressibility of the
///   barostat is adapted after 1/8, 1/4 and 1/2 of the stage. Once the volume fluctuations are
///   known, they determine the compressibility. While the volume drifts, the compressibility is
///   multiplied by 4, up to 16 times the default. For a run at constant energy, momenta are then
///   scaled so that the total energy equals its mean over the second half of the stage. The run
///   therefore has the requested temperature.
///
/// The function writes PREFIX-prepared.gro with velocities, and PREFIX-prepared.bin, a checkpoint
/// with the same state to the last bit. The function also writes PREFIX-prepared.toml, a run file
/// that starts from both files. During the dynamics, the checkpoint stores the state of the
/// preparation, which can be resumed bit for bit. An interrupted minimisation leaves no file.
/// @throws Error     if a setting is invalid, or outputs exist
/// @throws RunError  if molecules still overlap, or a stage blows up
PreparationReport prepare(const Config& config, const OutputOptions& options = {},
                          const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The results of a preparation as a list, from which text and JSON are made.
Quantities quantities(const PreparationReport& report);

}  // namespace polhode
