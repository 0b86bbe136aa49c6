// SPDX-License-Identifier: MIT
// Figures, drawn by gnuplot. The gnuplot script is kept next to the data, so that users can edit it
// and run it again.
#pragma once

#include <array>
#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/io/figures/curves_figure.hpp"

namespace polhode {

/// The possible values of the figure format, as in run files.
inline constexpr std::array<std::string_view, 3> plot_formats = {"svg", "png", "none"};

/// Runs gnuplot on a script in the script's folder, without a shell, user settings or input.
/// Returns false and prints a warning with reason and remedy if gnuplot is not installed or fails.
/// gnuplot is terminated if it takes longer than the limit (in whole seconds).
bool run_gnuplot(const std::string& script, std::ostream& warnings,
                 std::chrono::seconds limit = std::chrono::seconds(60));

/// The rows of one scheme in a CSV file; the first row is row 0.
struct SchemeRows {
  std::string scheme;
  std::size_t first, last;
};

/// A figure of energies against time: the deviation of the total or conserved energy from its mean
/// and the potential energy, in two panels with title and R above.
struct EnergyFigure {
  std::string csv;  ///< file with the columns "time [ps]", "potential [kJ/mol]" and `energy`
  std::string title;
  std::string energy = "conserved";  ///< energy in the upper panel: "conserved" or "total"
  std::string ratio{};               ///< R (relative energy fluctuation) as in the summary, such
                                     ///< as "0.056 ± 0.003 %"; may be empty
};

/// A figure of R against the cost of schemes [vanzon2008, Fig. 1] on linear axes, and of all points
/// on logarithmic axes. The columns are "cost [1/ps]", "R [1]" and "R_error [1]". Two more columns
/// contain flags: "usable [1]" is 1 for steps below the end of a curve, and "rounded [1]" is 1
/// where round-off dominates R. The longest usable step has an open symbol if the curve ends at
/// this step. Points at the round-off limit are crossed out.
struct EfficiencyFigure {
  std::string csv;
  std::vector<SchemeRows> schemes;  ///< schemes, each with at least one usable step
  std::string caption{};            ///< text below the axes: the conditions of the comparison
  double max_ratio = 0.035;         ///< upper end of the linear R axis
};

/// A figure of R against computing time on logarithmic axes, with the models fitted by the adviser,
/// the bound on R, and the chosen step. The columns are "step [fs]", "R [1]", "R_error [1]" and
/// "usable [1]".
struct AdviceFigure {
  struct Curve {
    SchemeRows rows;
    double step, seconds;  ///< time step [fs], and computing time [s] per ps at this step
    /// Results of the fitted model: R at the time step `step` [1] (0 without a model), and d log
    /// R/d log h at `step` and for short steps.
    double ratio = 0, exponent = 0, short_exponent = 0;
  };
  struct Answer {
    std::size_t curve, row;  ///< indices (from 0) of the curve and of the row
  };
  std::string csv;
  std::vector<Curve> curves;          ///< curves, each with at least one usable step
  std::optional<double> bound{};      ///< requested bound on R
  std::optional<Answer> confirmed{};  ///< confirmed step
};

/// A figure of the bias of canonical averages against "cost [1/ps]", with one panel for each
/// quantity. Only rows with "stable [1]" equal to 1 are plotted.
struct CanonicalFigure {
  struct Panel {
    std::string title, column, error;  ///< title, and columns with units, as in the file
    double strict = 0, loose = 0;      ///< bounds, shaded; 0 for a logarithmic axis without bounds
  };
  std::string csv;
  std::vector<SchemeRows> schemes;
  std::vector<Panel> panels;
  std::string caption{};  ///< text below the axes: the conditions of the comparison
};

/// A figure of columns of a CSV file, whose name is its member `csv`.
using Figure =
    std::variant<EnergyFigure, CurvesFigure, EfficiencyFigure, AdviceFigure, CanonicalFigure>;

/// Draws a figure. Script and image are written next to the CSV file, under its name with other
/// extensions. Returns false and prints a warning if the figure was not drawn.
/// @param format  "svg" or "png"
bool draw_figure(const Figure& figure, const std::string& format, std::ostream& warnings);

/// The data of a figure of a free top. The file has four blocks of angular velocities ω in three
/// columns, separated by two blank lines: inertia ellipsoid, polhodes of the same energy, polhode
/// of the top, current ω.
struct PolhodeFigure {
  std::string data;
  Vec3<double> J, L;  ///< principal moments and body-frame L, in any consistent units
};

/// Plots the polhode on the inertia ellipsoid and, next to this figure, the path of L on the energy
/// ellipsoid. Script and images, SVG and PNG, are written next to the data.
bool polhode_plot(const PolhodeFigure& figure, std::ostream& warnings);

}  // namespace polhode
