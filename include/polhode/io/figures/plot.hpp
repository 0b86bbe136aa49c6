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
#include <utility>
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

/// Accuracy and cost of a scheme at one step.
struct EfficiencyMark {
  double cost;               ///< force evaluations per ps
  double ratio;              ///< R = rms of E divided by rms of V [1]
  double error;              ///< standard error of R [1]
  bool stable = true;        ///< false: the step is too large for the scheme; not drawn
  bool at_rounding = false;  ///< R is dominated by rounding
};

struct EfficiencyCurve {
  std::string scheme;
  std::vector<EfficiencyMark> marks;  ///< marks in any order
};

struct EfficiencyFigure {
  std::vector<EfficiencyCurve> curves;
  std::string caption{};     ///< below the axes: the conditions of the comparison
  double max_ratio = 0.035;  ///< R of the linear axis
};

/// R against cost for each scheme [vanzon2008, Fig. 1], on linear axes, and all points on
/// logarithmic ones. The largest stable step has an open symbol if a larger one is known to be
/// unstable; points at the rounding floor are crossed out. Writes PREFIX.gp and PREFIX.svg or
/// PREFIX.png.
bool efficiency_plot(const std::string& prefix, const EfficiencyFigure& figure,
                     const std::string& format, std::ostream& warnings);

/// R of a scheme against its cost.
struct AdviceMark {
  double seconds;  ///< wall-clock time per simulated ps
  double ratio;    ///< R [1]
  double error;    ///< standard error of R [1]
};

struct AdviceCurve {
  std::string scheme;
  std::vector<AdviceMark> marks;                 ///< measured
  std::vector<std::pair<double, double>> model;  ///< seconds and R along the fitted model
};

struct AdviceFigure {
  std::vector<AdviceCurve> curves;
  std::optional<double> bound;          ///< the requested bound on R
  std::optional<AdviceMark> confirmed;  ///< the confirmed answer
};

/// R against computing time, on logarithmic axes, with the models that the adviser fitted to its
/// runs, the bound, and the answer. Writes PREFIX.gp and PREFIX.svg or PREFIX.png.
bool advice_plot(const std::string& prefix, const AdviceFigure& figure, const std::string& format,
                 std::ostream& warnings);

/// A quantity of a canonical study in a panel of its own.
struct CanonicalPanel {
  std::string title;
  double strict = 0, loose = 0;  ///< bounds on its magnitude, shaded; 0: none, a logarithmic axis
};

/// A scheme's values of all panels at one step; not numbers where they are unknown.
struct CanonicalMark {
  double cost = 0;                                ///< force evaluations per ps
  std::vector<std::pair<double, double>> values;  ///< values with errors, one for each panel
};

struct CanonicalFigure {
  struct Curve {
    std::string scheme;
    std::vector<CanonicalMark> marks;  ///< marks in any order
  };
  std::vector<CanonicalPanel> panels;
  std::vector<Curve> curves;
  std::string caption{};  ///< below the axes: the conditions of the comparison
};

/// Bias of canonical averages against cost, small multiples. Writes PREFIX.gp and PREFIX.svg or
/// PREFIX.png.
bool canonical_plot(const std::string& prefix, const CanonicalFigure& figure,
                    const std::string& format, std::ostream& warnings);

/// A free top, and a file with blocks of ω in three columns, separated by two blank lines: inertia
/// ellipsoid, polhodes of the same energy, the top's polhode, ω.
struct PolhodeFigure {
  std::string data;
  Vec3<double> J, L;  ///< principal moments and body-frame angular momentum, any consistent units
};

/// The polhode on the inertia ellipsoid and, next to it, L on the ellipsoid of the same energy.
/// Writes PREFIX.gp, PREFIX.svg and PREFIX.png.
bool polhode_plot(const std::string& prefix, const PolhodeFigure& figure, std::ostream& warnings);

}  // namespace polhode
