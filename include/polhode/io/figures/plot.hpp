// SPDX-License-Identifier: MIT
// Figures, drawn by gnuplot from a script that is left next to the data, so that it can be edited
// and run again.
#pragma once

#include <array>
#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// The choices of a figure, as in run files.
inline constexpr std::array<std::string_view, 3> plot_formats = {"svg", "png", "none"};

/// Runs gnuplot on a script in the script's folder, without a shell, the user's settings or input.
/// False, with a warning that gives reason and remedy, if gnuplot is not installed, refuses the
/// script, or takes longer than the limit (whole seconds) and is terminated.
bool run_gnuplot(const std::string& script, std::ostream& warnings,
                 std::chrono::seconds limit = std::chrono::seconds(60));

/// The energies of a run against time.
struct EnergyFigure {
  std::string csv;  ///< with the columns "time [ps]", "potential [kJ/mol]" and `energy`
  std::string title;
  std::string energy = "conserved";  ///< the energy of the upper panel: "conserved" or "total"
  std::string ratio{};               ///< R as the summary has it, "0.056 ± 0.003 %"; empty: none
};

/// The deviation of the total or conserved energy from its mean, and the potential energy, in two
/// panels, with the title and R above. Image and script are written next to the CSV file, with its
/// name and other extensions.
/// @param format  "svg" or "png"
bool energy_plot(const EnergyFigure& figure, const std::string& format, std::ostream& warnings);

/// Columns of a CSV file plotted as lines against its first column, in panels.
struct CurvesFigure {
  std::string csv;
  std::string title, x_label, y_label;
  double left = 0, right = 1;  ///< ends of the common horizontal axis
  std::size_t across = 0;      ///< panels in a row; 0: as many as are readable
  struct Curve {
    std::string name;       ///< name in the legend; empty: not in the legend
    std::size_t column;     ///< column of the file, from 1
    std::size_t error = 0;  ///< column of its standard errors, drawn as a band; 0: none
  };
  /// A straight line between two points, such as a fit.
  struct Line {
    std::string name;
    std::array<double, 2> x, y;
  };
  struct Panel {
    std::string title;
    std::vector<Curve> curves;
    std::vector<Line> lines{};
    double low = 0, high = 1;  ///< ends of the vertical axis
  };
  std::vector<Panel> panels{};
};

/// Draws the figure; script and image are written next to the CSV file, with its name and other
/// extensions.
/// @param format  "svg" or "png"
bool curves_plot(const CurvesFigure& figure, const std::string& format, std::ostream& warnings);

/// The rows of a scheme in a CSV file, counted from 0.
struct SchemeRows {
  std::string scheme;
  std::size_t first, last;
};

/// R of schemes against their cost, in the columns "cost [1/ps]", "R [1]" and "R_error [1]". In two
/// more columns, "usable [1]" is 1 before the end of a curve, and "rounded [1]" where rounding
/// dominates R.
struct EfficiencyFigure {
  std::string csv;
  std::vector<SchemeRows> schemes;  ///< each with a usable step at least
  std::string caption{};            ///< below the axes: the conditions of the comparison
  double max_ratio = 0.035;         ///< R of the linear axis
};

/// R against cost for each scheme [vanzon2008, Fig. 1], on linear axes, and all points on
/// logarithmic ones. The longest usable step has an open symbol if the curve ends there; points at
/// the rounding floor are crossed out. Script and image are written next to the CSV file, as by
/// energy_plot().
bool efficiency_plot(const EfficiencyFigure& figure, const std::string& format,
                     std::ostream& warnings);

/// R of schemes against computing time: the columns "step [fs]", "R [1]", "R_error [1]" and
/// "usable [1]".
struct AdviceFigure {
  struct Curve {
    SchemeRows rows;
    double step, seconds;  ///< a step [fs], and the computing time of a ps with it
    /// Of the fitted model: R at that step [1], 0 without a model, and d log R/d log h there and
    /// for short steps.
    double ratio = 0, exponent = 0, short_exponent = 0;
  };
  struct Answer {
    std::size_t curve, row;  ///< counted from 0
  };
  std::string csv;
  std::vector<Curve> curves;          ///< each with a usable step at least
  std::optional<double> bound{};      ///< the requested bound on R
  std::optional<Answer> confirmed{};  ///< the confirmed answer
};

/// R against computing time, on logarithmic axes, with the models that the adviser fitted to its
/// runs, the bound, and the answer. Script and image are written next to the CSV file.
bool advice_plot(const AdviceFigure& figure, const std::string& format, std::ostream& warnings);

/// Columns of a CSV file against "cost [1/ps]", in panels, where "stable [1]" is 1.
struct CanonicalFigure {
  struct Panel {
    std::string title, column, error;  ///< columns with their units, as in the file
    double strict = 0, loose = 0;  ///< bounds on the magnitude, shaded; 0: none, a logarithmic axis
  };
  std::string csv;
  std::vector<SchemeRows> schemes;
  std::vector<Panel> panels;
  std::string caption{};  ///< below the axes: the conditions of the comparison
};

/// Bias of canonical averages against cost, small multiples. Script and image are written next to
/// the CSV file.
bool canonical_plot(const CanonicalFigure& figure, const std::string& format,
                    std::ostream& warnings);

/// A free top, and a file with blocks of ω in three columns, separated by two blank lines: inertia
/// ellipsoid, polhodes of the same energy, the top's polhode, ω.
struct PolhodeFigure {
  std::string data;
  Vec3<double> J, L;  ///< principal moments and body-frame angular momentum, any consistent units
};

/// The polhode on the inertia ellipsoid and, next to it, L on the ellipsoid of the same energy.
/// Script and images, SVG and PNG, are written next to the data.
bool polhode_plot(const PolhodeFigure& figure, std::ostream& warnings);

}  // namespace polhode
