// SPDX-License-Identifier: MIT
#include "plot_script.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "polhode/io/gnuplot_text.hpp"

namespace polhode {
namespace {

// The palette of Okabe and Ito, distinguishable for all kinds of colour vision.
constexpr std::array colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                "#E69F00", "#56B4E9", "#000000"};
constexpr std::array<std::pair<int, int>, 4> symbols = {{{7, 6}, {5, 4}, {9, 8}, {13, 12}}};

std::string head(const std::string& image, const std::string& format, int width, int height) {
  // Bitmaps have twice the resolution, for print and high-density screens.
  const std::string terminal = format == "png"
                                   ? fmt::format(
                                         "pngcairo size {},{} fontscale 2 linewidth 2 pointscale 2 "
                                         "enhanced font \"Helvetica,11\" background \"white\"",
                                         2 * width, 2 * height)
                                   : fmt::format(
                                         "svg size {},{} dynamic enhanced font \"Helvetica,15\" "
                                         "background \"white\"",
                                         width, height);
  return fmt::format(R"gp(# Restyle this and run it again: gnuplot draws {0}.
set encoding utf8
set minussign
set terminal {1}
set output {2}
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"
)gp",
                     gnuplot_comment(image), terminal, gnuplot_file(image));
}

// The largest R at costs of at least `from`, including the lines between points.
double highest_beyond(const std::vector<EfficiencyCurve>& curves, double from) {
  double highest = 0;
  for (const EfficiencyCurve& curve : curves) {
    const EfficiencyMark* before = nullptr;
    for (const EfficiencyMark& mark : curve.marks) {
      if (!mark.stable) continue;
      if (mark.cost >= from) highest = std::max(highest, mark.ratio + mark.error);
      if (before != nullptr && before->cost < from && mark.cost > from)
        highest =
            std::max(highest, before->ratio + (mark.ratio - before->ratio) * (from - before->cost) /
                                                  (mark.cost - before->cost));
      before = &mark;
    }
  }
  return highest;
}

// The largest cost at which some curve exceeds a ratio; beyond it, all are close to the axis.
double last_cost_above(const std::vector<EfficiencyCurve>& curves, double ratio) {
  double last = 1;
  for (const EfficiencyCurve& curve : curves)
    for (const EfficiencyMark& mark : curve.marks)
      if (mark.stable && mark.ratio >= ratio) last = std::max(last, mark.cost);
  return last;
}

struct Ranges {
  double cost_low = std::numeric_limits<double>::infinity(), cost_high = 0;
  double ratio_low = std::numeric_limits<double>::infinity(), ratio_high = 0;
};

Ranges ranges_of(const std::vector<EfficiencyCurve>& curves) {
  Ranges r;
  for (const EfficiencyCurve& curve : curves)
    for (const EfficiencyMark& mark : curve.marks) {
      if (!mark.stable) continue;
      r.cost_low = std::min(r.cost_low, mark.cost), r.cost_high = std::max(r.cost_high, mark.cost);
      if (mark.ratio > 0) r.ratio_low = std::min(r.ratio_low, mark.ratio);
      r.ratio_high = std::max(r.ratio_high, mark.ratio);
    }
  if (r.cost_high == 0) r.cost_low = 1, r.cost_high = 1000;
  if (!(r.ratio_low < r.ratio_high)) r.ratio_low = r.ratio_high / 10;
  if (r.ratio_high == 0) r.ratio_low = 1e-3, r.ratio_high = 1;
  return r;
}

// Whether the points include a step that is too large for the scheme.
bool end_known(const EfficiencyCurve& curve) {
  return std::any_of(curve.marks.begin(), curve.marks.end(), [](auto& m) { return !m.stable; });
}

bool any_at_rounding(const EfficiencyCurve& curve) {
  return std::any_of(curve.marks.begin(), curve.marks.end(),
                     [](auto& m) { return m.stable && m.at_rounding; });
}

// One data block per curve: cost, R [%], its error, 1 at the stability limit, and 1 where R is
// dominated by rounding.
std::string data_blocks(const std::vector<EfficiencyCurve>& curves) {
  std::string text;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    text += fmt::format(
        "\n# {}: force evaluations per ps, R [%], its standard error, last stable, rounded\n"
        "$curve{} << EOD\n",
        gnuplot_comment(curves[k].scheme), k);
    bool first = true;  // marks ascend in cost, so the first stable one has the longest step
    for (const EfficiencyMark& mark : curves[k].marks) {
      if (!mark.stable) continue;
      text +=
          fmt::format("{:.8g} {:.8g} {:.3g} {} {}\n", mark.cost, 100 * mark.ratio, 100 * mark.error,
                      first && end_known(curves[k]) ? 1 : 0, mark.at_rounding ? 1 : 0);
      first = false;
    }
    text += "EOD\n";
  }
  return text;
}

std::string curves_command(const std::vector<EfficiencyCurve>& curves, bool inset) {
  std::string plot = "plot ";
  const auto style = [](std::size_t k) { return symbols[k % symbols.size()]; };
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const char* colour = colours[k % colours.size()];
    const auto [filled, open] = style(k);
    const double size = inset ? 0.45 : 0.9;
    plot +=
        fmt::format("\\\n  $curve{} using 1:2 with lines linewidth {} linecolor \"{}\" notitle, ",
                    k, inset ? 1 : 1.6, colour);
    if (!inset)
      plot += fmt::format(
          "\\\n  '' using 1:2:3 with yerrorbars pointtype -1 linewidth 1 "
          "linecolor \"{}\" notitle, ",
          colour);
    plot += fmt::format(
        "\\\n  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype {} "
        "pointsize {} linecolor \"{}\" notitle, ",
        filled, size, colour);
    plot += fmt::format(
        "\\\n  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype {} "
        "pointsize {} linewidth 0 linecolor \"white\" notitle, ",
        filled, 1.4 * size);
    plot += fmt::format(
        "\\\n  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype {} "
        "pointsize {} linewidth 1.6 linecolor \"{}\" notitle, ",
        open, 1.4 * size, colour);
    if (any_at_rounding(curves[k]))
      plot += fmt::format(
          "\\\n  '' using 1:($5 == 1 ? $2 : NaN) with points pointtype 2 pointsize {} "
          "linewidth 1.4 linecolor \"#404040\" notitle, ",
          1.8 * size);
    if (!inset)
      plot += fmt::format(
          "\\\n  NaN with linespoints linewidth 1.6 pointtype {} pointsize {} "
          "linecolor \"{}\" title {}, ",
          filled, size, colour, gnuplot_text(curves[k].scheme));
  }
  if (!inset && std::any_of(curves.begin(), curves.end(), any_at_rounding))
    plot +=
        "\\\n  NaN with points pointtype 2 pointsize 1.3 linewidth 1.4 linecolor \"#404040\" "
        "title \"rounding\", ";
  if (!inset && std::any_of(curves.begin(), curves.end(), end_known))
    plot +=
        "\\\n  NaN with points pointtype 6 pointsize 1.3 linewidth 1.6 linecolor \"#404040\" title "
        "\"stability limit\"";
  else
    plot += "NaN notitle";
  return plot + "\n";
}

}  // namespace

std::string energy_script(const std::string& csv, const std::string& image,
                          const std::string& title, const std::string& format) {
  return head(image, format, 720, 480) + fmt::format(R"gp(
data = {0}
set datafile separator ","
set datafile columnheaders
stats data using (column("total [kJ/mol]")) name "E" nooutput
stats data using (column("potential [kJ/mol]")) name "V" nooutput

# The distance between tics that puts about five of them into a range.
tic(range) = range <= 0 ? 1 : nice(range, 10**floor(log10(range)))
nice(range, p) = range < 1.5*p ? 0.2*p : range < 3*p ? 0.5*p : range < 6*p ? p : 2*p

set multiplot
set lmargin at screen 0.18
set rmargin at screen 0.96
unset key

set tmargin at screen 0.90
set bmargin at screen 0.57
set title {1} noenhanced textcolor "#404040"
set format x ""
set label 1 "E − ⟨E⟩  (kJ/mol)" at screen 0.03, screen 0.735 center rotate
set autoscale xfix
set ytics tic(E_max - E_min)
set xzeroaxis linewidth 1 linecolor "#404040"
plot data using (column("time [ps]")):(column("total [kJ/mol]") - E_mean) \
  with lines linewidth 1.4 linecolor "{2}"

set tmargin at screen 0.52
set bmargin at screen 0.19
unset title
set format x "%g"
set xlabel "time  (ps)" offset 0,0.3
set label 1 "V  (kJ/mol)" at screen 0.03, screen 0.355 center rotate
set ytics tic(V_max - V_min)
unset xzeroaxis
plot data using (column("time [ps]")):(column("potential [kJ/mol]")) \
  with lines linewidth 1.4 linecolor "{3}"
unset multiplot
)gp",
                                                     gnuplot_file(csv), gnuplot_text(title),
                                                     colours[1], colours[0]);
}

std::string curves_script(const CurvesFigure& figure, const std::string& csv,
                          const std::string& image, const std::string& format) {
  std::string plots;
  for (std::size_t k = 0; k < figure.columns.size(); ++k)
    plots += fmt::format(
        "{}\\\n  data using 1:{} with lines linewidth 1.4 linecolor \"{}\" dashtype {} "
        "title {}",
        k == 0 ? "" : ", ", figure.columns[k].number, colours[k % colours.size()],
        1 + k / colours.size(), gnuplot_text(figure.columns[k].title));
  return head(image, format, 720, 480) + fmt::format(R"gp(
data = {}
set datafile separator ","
set datafile columnheaders
set title {} noenhanced textcolor "#404040"
set key top right noenhanced Left reverse samplen 1.6 textcolor "#404040"
set xlabel {} noenhanced
set ylabel {} noenhanced
set autoscale xfix
plot {}
)gp",
                                                     gnuplot_file(csv), gnuplot_text(figure.title),
                                                     gnuplot_text(figure.x_label),
                                                     gnuplot_text(figure.y_label), plots);
}

std::string efficiency_script(const std::vector<EfficiencyCurve>& unsorted,
                              const std::string& image, const std::string& format, double highest) {
  std::vector<EfficiencyCurve> curves = unsorted;
  std::erase_if(curves, [](const EfficiencyCurve& curve) {
    return std::none_of(curve.marks.begin(), curve.marks.end(), [](auto& m) { return m.stable; });
  });
  for (EfficiencyCurve& curve : curves)
    std::sort(curve.marks.begin(), curve.marks.end(),
              [](const auto& a, const auto& b) { return a.cost < b.cost; });
  const Ranges r = ranges_of(curves);
  // The inset with its labels covers the upper right of the frame, beyond these fractions; the
  // linear axis is extended until no curve passes there.
  constexpr double inset_left = 0.34, inset_bottom = 0.36;
  const double wanted = std::min(highest, 1.08 * r.ratio_high);
  const double left = 0.6 * r.cost_low, right = 1.1 * last_cost_above(curves, 0.02 * wanted);
  const double top =
      std::max(wanted, highest_beyond(curves, left + inset_left * (right - left)) / inset_bottom);

  return head(image, format, 720, 540) + data_blocks(curves) +
         fmt::format(R"gp(
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set bmargin at screen 0.15
set tmargin at screen 0.88
set key tmargin center horizontal Left reverse noenhanced samplen 1.6 width {8} textcolor "#404040"
set xlabel "force evaluations per ps" offset 0,0.2
set ylabel "R  (%)" offset 0.8
set xrange [{10:.6g}:{0:.6g}]
set yrange [0:{1:.6g}]
{2}
#Everything, on logarithmic axes.
set lmargin at screen 0.52
set rmargin at screen 0.955
set bmargin at screen 0.50
set tmargin at screen 0.865
unset key
set border 15
set logscale xy
set xlabel "" 
set ylabel ""
set tics font ",{6}"
set xtics (100, 200, 500, 1000, 2000, 5000, 10000)
set format y "10^{{%T}}"
set xrange [{3:.6g}:{4:.6g}]
set yrange [{5:.6g}:{9:.6g}]
{7}unset multiplot
)gp",
                     right, 100 * top, curves_command(curves, false), 0.8 * r.cost_low,
                     1.25 * r.cost_high, 100 * 0.7 * r.ratio_low, format == "png" ? 9 : 12,
                     curves_command(curves, true), format == "png" ? 0 : 1,
                     100 * 1.6 * r.ratio_high, left);
}

std::string advice_script(const AdviceFigure& figure, const std::string& image,
                          const std::string& format) {
  std::string data, plot;
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    const AdviceCurve& curve = figure.curves[k];
    data += fmt::format("\n# {}: seconds per ps, R [%], its standard error\n$marks{} << EOD\n",
                        gnuplot_comment(curve.scheme), k);
    for (const AdviceMark& mark : curve.marks)
      data +=
          fmt::format("{:.6g} {:.6g} {:.3g}\n", mark.seconds, 100 * mark.ratio, 100 * mark.error);
    data += fmt::format("EOD\n$law{} << EOD\n", k);
    for (const auto& [seconds, ratio] : curve.model)
      data += fmt::format("{:.6g} {:.6g}\n", seconds, 100 * ratio);
    data += "EOD\n";
    const char* colour = colours[k % colours.size()];
    const int symbol = symbols[k % symbols.size()].first;
    plot += fmt::format(
        "\\\n  $marks{0} using 1:2:3 with yerrorbars pointtype {1} pointsize 0.9 linecolor \"{2}\" "
        "title {3}, ",
        k, symbol, colour, gnuplot_text(curve.scheme));
    if (!curve.model.empty())
      plot += fmt::format("\\\n  $law{} with lines linewidth 1.6 linecolor \"{}\" notitle, ", k,
                          colour);
  }
  if (figure.bound)
    plot += fmt::format(
        "\\\n  {:.6g} with lines linewidth 1.4 dashtype 2 linecolor \"#404040\" title "
        "\"required\", ",
        100 * *figure.bound);
  if (figure.confirmed) {
    data += fmt::format("\n$answer << EOD\n{:.6g} {:.6g} {:.3g}\nEOD\n", figure.confirmed->seconds,
                        100 * figure.confirmed->ratio, 100 * figure.confirmed->error);
    plot +=
        "\\\n  $answer using 1:2:3 with yerrorbars pointtype 6 pointsize 2 linewidth 2 linecolor "
        "\"#000000\" title \"confirmed\", ";
  }
  return head(image, format, 720, 480) + data +
         fmt::format(R"gp(
set key outside top center horizontal noenhanced samplen 1.6 textcolor "#404040"
set xlabel "computing time for a simulated ps  (s)"
set ylabel "R  (%)"
set logscale xy
set format y "%g"
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
plot {}NaN notitle
)gp",
                     plot);
}

}  // namespace polhode
