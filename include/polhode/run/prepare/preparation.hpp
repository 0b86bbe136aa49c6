// SPDX-License-Identifier: MIT
// From a composition, a temperature and a pressure or density to an equilibrated start.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Properties measured in the second half of the last stage of a preparation.
struct PreparedProperties {
  RunSummary summary;
  SeriesEstimate density;          ///< [u/nm³]
  std::optional<double> pressure;  ///< pressure of the barostat [kJ/mol/nm³]
  /// Compressibility from the fluctuations of the volume, with a barostat. It is known if the
  /// volume has fluctuated long enough and does not drift [nm³ mol/kJ].
  SeriesEstimate compressibility{};
  double moves_compressibility = 0;  ///< compressibility for the moves of the barostat [nm³ mol/kJ]
  std::vector<Warning> warnings{};   ///< what is probably wrong
};

struct PreparationReport {
  std::size_t molecules = 0;
  double lattice_density = 0;  ///< [u/nm³]; 0 if there is an initial configuration
  bool estimated = false;      ///< the density of the lattice, by estimated_density()
  Minimisation minimisation;
  /// Compressibility in the new run file, if estimated, otherwise 0 [nm³ mol/kJ].
  double compressibility = 0;
  std::optional<PreparedProperties> properties;  ///< nothing if it was interrupted
  std::vector<std::string> files;                ///< files that were written
  std::string run_file, checkpoint;              ///< their paths, if written
};

/// The density of a liquid of these molecules, roughly [u/nm³]: spheres of diameter σ about their
/// sites, without their overlap within a molecule, fill 45 % of its volume. Liquids near their
/// triple point have 43 % (argon) to 55 % (water).
/// @throws Error  if no site has a size
double estimated_density(const Topology& topology);

/// Prepares the system of a run file:
/// 1. a lattice with its kinds of molecules shuffled, at the density or in the box of [system]; if
///    it has neither, at estimated_density(), which requires a barostat. An initial configuration
///    replaces the lattice.
/// 2. minimise(), to forces of 100 kJ/mol/nm and torques of 10 kJ/mol.
/// 3. NVT: Langevin dynamics by BAOAB [leimkuhler2013] in steps of 1 fs, friction 5/ps.
/// 4. NPT if there is a barostat: Langevin dynamics with moves of the box, in steps of at most 2
///    fs. If the run file gives no compressibility, it adapts after 1/8, 1/4 and 1/2 of the
///    stage. It becomes the value from the fluctuations of the volume once these are known.
///    While the volume drifts it is multiplied by 4, up to 16 times the default. For a run at
/// constant energy, momenta are then scaled to the mean total energy of the last half stage, so
/// that the run has the temperature. Writes PREFIX-prepared.gro, with velocities, and
/// PREFIX-prepared.bin, a checkpoint with the same state to the last bit. Writes
/// PREFIX-prepared.toml, a run file that starts from both. During the dynamics the checkpoint is
/// of the preparation, which resumes from it bit for bit; an interrupted minimisation leaves no
/// file.
/// @throws Error     if a setting does not fit, or outputs exist
/// @throws RunError  if molecules still overlap, or a stage blows up
PreparationReport prepare(const Config& config, const OutputOptions& options = {},
                          const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// "310 ± 40 1e-6/bar, from the fluctuations of the volume", or that it is not known yet.
/// @param in_use  the compressibility that sets the size of the moves [nm³ mol/kJ]
std::string compressibility_text(const SeriesEstimate& measured, double in_use);

/// The results as a list, from which text and JSON follow.
Quantities quantities(const PreparationReport& report);

}  // namespace polhode
