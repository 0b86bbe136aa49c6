// SPDX-License-Identifier: MIT
// Figures, drawn by gnuplot from a script that is kept beside the data, to be restyled and run
// again.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

/// Runs gnuplot on a script in the script's folder. False, with a warning that says why and what to
/// do, if gnuplot is not installed or does not like the script.
bool run_gnuplot(const std::string& script, std::ostream& warnings);

/// The energies of a run against time: deviation of the total energy from its mean, and potential
/// energy, in two panels. `csv` must have the columns "time [ps]", "potential [kJ/mol]" and "total
/// [kJ/mol]"; the image stands beside it, with the script, under its name with another ending.
/// @param format  "svg" or "png"
bool energy_plot(const std::string& csv, const std::string& title, const std::string& format,
                 std::ostream& warnings);

/// Columns of a CSV file against its first one, as lines.
struct CurvesFigure {
  std::string csv;
  std::string title, x_label, y_label;
  std::vector<std::string> columns;  ///< as the head of the file has them, with units
};

/// Draws the figure; script and image stand beside the CSV file, under its name with other endings.
/// @param format  "svg" or "png"
bool curves_plot(const CurvesFigure& figure, const std::string& format, std::ostream& warnings);

/// What a scheme achieves at one step.
struct EfficiencyMark {
  double cost;           ///< force evaluations per ps
  double ratio;          ///< R = rms of E over rms of V [1]
  double error;          ///< of R [1]
  bool stable = true;    ///< false: the step is too long for the scheme; not drawn
  bool rounded = false;  ///< R is that of rounding, not of the scheme
};

struct EfficiencyCurve {
  std::string scheme;
  std::vector<EfficiencyMark> marks;  ///< in any order
};

/// R against cost for each scheme (vanzon2008, Fig. 1), on linear axes up to `highest` R, with a
/// logarithmic inset of everything. The longest stable step is an open symbol, where a longer one
/// is known to be unstable; marks at the floor of rounding are crossed out. Writes PREFIX.gp and
/// PREFIX.svg or PREFIX.png.
bool efficiency_plot(const std::string& prefix, const std::vector<EfficiencyCurve>& curves,
                     const std::string& format, std::ostream& warnings, double highest = 0.035);

/// R of a scheme against what it costs.
struct AdviceMark {
  double seconds;  ///< of wall-clock time for a simulated ps
  double ratio;    ///< R [1]
  double error;    ///< of R [1]
};

struct AdviceCurve {
  std::string scheme;
  std::vector<AdviceMark> marks;                 ///< measured
  std::vector<std::pair<double, double>> model;  ///< seconds and R along the law through them
};

struct AdviceFigure {
  std::vector<AdviceCurve> curves;
  std::optional<double> bound;          ///< of R that was asked for
  std::optional<AdviceMark> confirmed;  ///< the answer
};

/// R against computing time, on logarithmic axes, with the laws that the adviser drew through its
/// runs, the bound, and the answer. Writes PREFIX.gp and PREFIX.svg or PREFIX.png.
bool advice_plot(const std::string& prefix, const AdviceFigure& figure, const std::string& format,
                 std::ostream& warnings);

}  // namespace polhode
