# To change the figure, edit this script and run gnuplot on it: it draws processed.png.
image = './processed.png'
format = 'png'
width = 1000
height = 500
data = './processed.csv'
curves = 3
array name[3]
name[1] = 'velocity-verlet'
name[2] = 'takahashi-imada-fd'
name[3] = 'gier4-fd'
array colour[3]
colour[1] = '#0072B2'
colour[2] = '#B15928'
colour[3] = '#009E73'
array filled[3]
filled[1] = 7
filled[2] = 9
filled[3] = 9
array open[3]
open[1] = 6
open[2] = 8
open[3] = 8
array first[3]
first[1] = 0
first[2] = 5
first[3] = 10
array last[3]
last[1] = 4
last[2] = 9
last[3] = 14
caption = 'Points further left and lower are better; R = 0 is exact dynamics. 512 tip4p; 10 runs of 15 ps per point, read through postprocessors.'
highest = 3.500000000

# The style of all figures. Above: image, format ("svg" or "png"), width and height [pixels].
set encoding utf8
set minussign
ink = "#404040"
small = format eq "png" ? ",9" : ",12"  # font, in points of a bitmap or pixels
if (format eq "png") {
  # Twice the pixels, for print and high-density screens.
  set terminal pngcairo size 2*width,2*height fontscale 2 linewidth 2 pointscale 2 enhanced font "Helvetica,11" background "white"
} else {
  set terminal svg size width,height dynamic enhanced font "Helvetica,15" background "white"
}
set output image
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink
# The distance between tics that puts about five of them into a range.
tic(range) = range <= 0 ? 1 : nice(range, 10**floor(log10(range)))
nice(range, p) = range < 1.5*p ? 0.2*p : range < 3*p ? 0.5*p : range < 6*p ? p : 2*p

# R against cost for each scheme, on linear axes and, all points, on logarithmic ones. Above: data (the CSV file of a study), caption;
# for each scheme its name, colour, filled and open marker, first and last row from 0; highest, the largest R of the linear axis [%].
set datafile separator ","
set datafile columnheaders
# The points before the ends of curves: number of the scheme, cost, R [%], its standard error, 1 where rounding dominates R.
$points << EOD
NaN NaN NaN NaN NaN
EOD
if (curves > 0) {
  set table $points
  plot for [k=1:curves] data every ::first[k]::last[k] using (k):(column("cost [1/ps]")):(100*column("R [1]")):(100*column("R_error [1]")):(column("rounded [1]")) \
    with table if (column("usable [1]") == 1)
  unset table
}
# The cost of the last step before a curve ends; 0: no longer step is known to drift.
array end[curves + 1]
end[1] = 0
some_end = 0
do for [k=1:curves] {
  stats data every ::first[k]::last[k] using (column("usable [1]")) name "U" nooutput
  end[k] = U_min
}
set datafile nocolumnheaders
set datafile separator whitespace
k = 1
own(k, y) = column(1) == k ? y : NaN
do for [k=1:curves] {
  stats $points using (own(k, $2)) name "C" nooutput
  end[k] = end[k] == 0 ? C_min : 0
  some_end = some_end || end[k] > 0
}

# The ends of the axes: linear as far as any curve differs from the axis; logarithmic for all points.
cost_low = 1; cost_high = 1000; ratio_low = 0.1; ratio_high = 100; last_cost = 1; some_rounded = 0
if (curves > 0) {
  stats $points using 2 name "P" nooutput
  cost_low = P_min; cost_high = P_max
  stats $points using 3 name "P" nooutput
  if (P_max > 0) {
    ratio_high = P_max
    stats $points using ($3 > 0 ? $3 : NaN) name "P" nooutput
    ratio_low = P_min < ratio_high ? P_min : ratio_high/10
  }
  stats $points using 5 name "P" nooutput
  some_rounded = P_max > 0
}
top = 1.08*ratio_high < highest ? 1.08*ratio_high : highest
if (curves > 0) {
  stats $points using ($3 >= 0.02*top ? $2 : NaN) name "P" nooutput
  last_cost = P_max
}

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
set xrange [0.6*cost_low:1.1*last_cost]
set yrange [0:top]
plot for [k=1:curves] $points using 2:(own(k, $3)) with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points using 2:(own(k, $3)):4 with yerrorbars pointtype -1 linewidth 1 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? NaN : $3)) with points pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? $3 : NaN)) with points pointtype filled[k] pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? $3 : NaN)) with points pointtype open[k] pointsize 1.26 linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:curves] $points using 2:(own(k, $5 == 1 ? $3 : NaN)) with points pointtype 2 pointsize 1.6 linewidth 1.4 linecolor rgb ink notitle, \
  NaN notitle

# Everything, on logarithmic axes.
set lmargin at screen 0.575
set rmargin at screen 0.98
unset label 1
set logscale xy
set ylabel ""
set xtics (50, 100, 200, 500, 1000, 2000, 5000, 10000)
set format y "%g"
set xrange [0.8*cost_low:1.25*cost_high]
set yrange [0.7*ratio_low:1.6*ratio_high]
plot for [k=1:curves] $points using 2:(own(k, $3)) with lines linewidth 1.6 linecolor rgb colour[k], \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? NaN : $3)) with points pointtype filled[k] pointsize 0.7 linecolor rgb colour[k], \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? $3 : NaN)) with points pointtype filled[k] pointsize 1 linewidth 0 linecolor "white", \
  for [k=1:curves] $points using 2:(own(k, $2 == end[k] ? $3 : NaN)) with points pointtype open[k] pointsize 1 linewidth 1.6 linecolor rgb colour[k], \
  for [k=1:curves] $points using 2:(own(k, $5 == 1 ? $3 : NaN)) with points pointtype 2 pointsize 1.4 linewidth 1.4 linecolor rgb ink, \
  NaN notitle
unset multiplot
