# R against cost for each scheme, on linear axes, with an inset of all points on logarithmic ones. Above: for each curve its
# name, colour, filled and open marker; caption; the ranges of the axes; some_end, some_rounded; and $points, a block per curve:
# force evaluations per ps, R [%], its standard error, 1 at the last step before the curve ends, 1 where R is dominated by rounding.
longest = 0
do for [k=1:curves] { if (strlen(name[k]) > longest) { longest = strlen(name[k]) } }
entries = curves + some_end + some_rounded
across = longest < 20 ? 3 : longest < 40 ? 2 : 1
rows = ceil(real(entries)/across)
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set bmargin at screen 0.185
set tmargin at screen 0.965 - 0.04*rows
set key at screen 0.54, screen 0.985 center top horizontal maxcols across
set label 1 caption at screen 0.02, screen 0.05 left noenhanced textcolor rgb ink font small
set xlabel "cost:  force evaluations per ps" offset 0,0.2
set ylabel "error:  R = rms of E / rms of V  (%)" offset 0.8
set xrange [cost_low:cost_high]
set yrange [0:ratio_high]
plot for [k=1:curves] $points index k-1 using 1:2 with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:2:3 with yerrorbars pointtype -1 linewidth 1 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 0 ? $2 : NaN) with points pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype filled[k] pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype open[k] pointsize 1.26 linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points index k-1 using 1:($5 == 1 ? $2 : NaN) with points pointtype 2 pointsize 1.6 linewidth 1.4 linecolor rgb ink notitle, \
  for [k=1:curves] keyentry with linespoints linewidth 1.6 pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k], \
  for [k=1:some_end] keyentry with points pointtype 6 pointsize 1.26 linewidth 1.6 linecolor rgb ink title "longer steps drift", \
  for [k=1:some_rounded] keyentry with points pointtype 2 pointsize 1.26 linewidth 1.4 linecolor rgb ink title "rounding", \
  NaN notitle

# Everything, on logarithmic axes.
set lmargin at screen 0.52
set rmargin at screen 0.955
set bmargin at screen 0.52
set tmargin at screen 0.945 - 0.04*rows
unset key
unset label 1
set border 15
set logscale xy
set xlabel ""
set ylabel ""
set tics font small
set xtics (100, 200, 500, 1000, 2000, 5000, 10000)
set format y "%g"
set xrange [all_cost_low:all_cost_high]
set yrange [all_ratio_low:all_ratio_high]
plot for [k=1:curves] $points index k-1 using 1:2 with lines linewidth 1 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($4 == 0 ? $2 : NaN) with points pointtype filled[k] pointsize 0.45 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype filled[k] pointsize 0.63 linewidth 0 linecolor "white", \
  for [k=1:curves] $points index k-1 using 1:($4 == 1 ? $2 : NaN) with points pointtype open[k] pointsize 0.63 linewidth 1.6 linecolor rgb colour[k], \
  for [k=1:curves] $points index k-1 using 1:($5 == 1 ? $2 : NaN) with points pointtype 2 pointsize 0.8 linewidth 1.4 linecolor rgb ink, \
  NaN notitle
unset multiplot
