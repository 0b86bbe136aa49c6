# R against cost for each scheme, on linear axes and, all points, on logarithmic ones. Above: for each curve its
# name, colour, filled and open marker; caption; the ranges of the axes; some_end, some_rounded; and $points, a block per curve:
# force evaluations per ps, R [%], its standard error, 1 at the last step before the curve ends, 1 where R is dominated by rounding.
longest = 0
do for [k=1:curves] { if (strlen(name[k]) > longest) { longest = strlen(name[k]) } }
entries = curves + some_end + some_rounded
across = longest < 20 ? 4 : longest < 45 ? 2 : 1
rows = ceil(real(entries)/across)
set multiplot
# The key, across both panels.
set lmargin at screen 0.08
set rmargin at screen 0.98
set tmargin at screen 0.99
set bmargin at screen 0.99 - 0.05*rows
set key inside center center horizontal maxcols across
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
plot NaN notitle, \
  for [k=1:curves] keyentry with linespoints linewidth 1.6 pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k], \
  for [k=1:some_end] keyentry with points pointtype 6 pointsize 1.26 linewidth 1.6 linecolor rgb ink title "longer steps drift", \
  for [k=1:some_rounded] keyentry with points pointtype 2 pointsize 1.26 linewidth 1.4 linecolor rgb ink title "rounding"
unset key
set border 3
set grid
set tics scale 0.6
set format "%g"

set bmargin at screen 0.225
set tmargin at screen 0.95 - 0.05*rows
set lmargin at screen 0.08
set rmargin at screen 0.485
set label 1 caption at screen 0.015, screen 0.06 left noenhanced textcolor rgb ink font small
set xlabel "cost:  force evaluations per ps" offset 0,0.2
set ylabel "error:  R = rms of E / rms of V  (%)"
set xrange [cost_low:cost_high]
set yrange [0:ratio_high]
plot for [k=1:curves] $points index k-1 using 1:2 with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:2:3 with yerrorbars pointtype -1 linewidth 1 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 0 ? $2 : NaN) with points pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype filled[k] pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype open[k] pointsize 1.26 linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($5 == 1 ? $2 : NaN) with points pointtype 2 pointsize 1.6 linewidth 1.4 linecolor rgb ink notitle, \
  NaN notitle

# Everything, on logarithmic axes.
set lmargin at screen 0.575
set rmargin at screen 0.98
unset label 1
set logscale xy
set ylabel ""
set xtics (50, 100, 200, 500, 1000, 2000, 5000, 10000)
set format y "%g"
set xrange [all_cost_low:all_cost_high]
set yrange [all_ratio_low:all_ratio_high]
plot for [k=1:curves] $points index k-1 using 1:2 with lines linewidth 1.6 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($4 == 0 ? $2 : NaN) with points pointtype filled[k] pointsize 0.7 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype filled[k] pointsize 1 linewidth 0 linecolor "white", \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype open[k] pointsize 1 linewidth 1.6 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($5 == 1 ? $2 : NaN) with points pointtype 2 pointsize 1.4 linewidth 1.4 linecolor rgb ink, \
  NaN notitle
unset multiplot
