# Bias of canonical averages against cost, a panel for each quantity, and the cost of an independent sample. Above: data (the CSV
# file of a study), caption; for each scheme its name, colour, filled marker, first and last row from 0; panels, and for each its title
# and column, the column of its errors, and strict and loose, its bounds (0: none, a logarithmic axis).
set datafile separator ","
set datafile columnheaders
stable(y) = column("stable [1]") == 1 ? y : NaN
cost(dummy) = column("cost [1/ps]")
k = j = 1
stats data using (stable(cost(0))) name "C" nooutput
# The vertical axes: all values, or with bounds up to a few of them, so that a large bias of one scheme does not hide the others.
within(y, a, b) = y < a ? a : y > b ? b : y
end_of(j, sign) = stable(column(column_of[j]) + sign*column(error_of[j]))
is_known(y) = y == y
array low[panels]
array high[panels]
do for [j=1:panels] {
  low[j] = loose_of[j] > 0 ? 0 : 1
  high[j] = loose_of[j] > 0 ? 0 : 1e4
  stats data using (is_known(end_of(j, 0)) ? 1 : 0) name "N" nooutput
  if (N_sum > 0) {
    stats data using (end_of(j, -1)) name "L" nooutput
    stats data using (end_of(j, 1)) name "H" nooutput
    low[j] = loose_of[j] > 0 ? L_min : L_min > 0 ? 0.7*L_min : 1
    high[j] = loose_of[j] > 0 ? H_max : L_min > 0 ? 1.4*H_max : 1e4
  }
  if (loose_of[j] > 0) {
    low[j] = 1.1*within(low[j], -2.5*loose_of[j], -loose_of[j])
    high[j] = 1.1*within(high[j], loose_of[j], 2.5*loose_of[j])
  }
}
set multiplot
across = 3
down = ceil(real(panels)/across)
left = 0.0; right = 0.99; bottom = 0.11; top = 0.93
# The key, across all panels.
set lmargin at screen 0.03
set rmargin at screen 0.99
set tmargin at screen 0.995
set bmargin at screen 0.925
set key inside center center horizontal maxcols 5
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
plot NaN notitle, \
  for [k=1:curves] keyentry with linespoints linewidth 1.6 pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k]
unset key
set border 3
set grid
set tics scale 0.6
set xtics font small
set ytics font small
set label 1 caption at screen 0.015, screen 0.025 left noenhanced textcolor rgb ink font small
set label 2 "cost:  force evaluations per ps" at screen 0.5, screen 0.07 center textcolor rgb ink
set logscale x
# Schemes of equal cost next to each other.
beside(cost, k) = cost*1.011**(k - 0.5*(curves + 1))
set xtics (1)
do for [d=-3:5] {
  do for [m in "1 2 5"] {
    x = m*10.0**d
    set xtics add (sprintf("%g", x) x)
  }
}
set xrange [0.8*C_min:1.25*C_max]
do for [j=1:panels] {
  place = (j - 1)%across
  row = (j - 1)/across
  set lmargin at screen left + (right - left)*(place + 0.17)/across
  set rmargin at screen left + (right - left)*(place + 0.99)/across
  set tmargin at screen top - (top - bottom)*(row + 0.12)/down
  set bmargin at screen top - (top - bottom)*(row + 0.93)/down
  set label 3 title_of[j] at graph 0, graph 1.06 left noenhanced textcolor rgb ink
  strict = strict_of[j]; loose = loose_of[j]
  if (strict > 0) {
    unset logscale y
    set ytics auto
    set format y "%g"
    set object 1 rectangle from graph 0, first -loose to graph 1, first loose fillstyle solid noborder fillcolor rgb "#f4f4f4" behind
    set object 2 rectangle from graph 0, first -strict to graph 1, first strict fillstyle solid noborder fillcolor rgb "#e2e2e2" behind
    set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead linewidth 1 linecolor rgb ink back
  } else {
    set logscale y
    set ytics (1)
    do for [d=-1:7] { do for [m in "1 2 5"] { y = m*10.0**d; set ytics add (sprintf("%g", y) y) } }
    unset object 1
    unset object 2
    unset arrow 1
  }
  set yrange [low[j]:high[j]]
  plot for [k=1:curves] data every ::first[k]::last[k] using (beside(cost(0), k)):(stable(column(column_of[j]))) smooth unique with lines linewidth 1.6 linecolor rgb colour[k], \
    for [k=1:curves] data every ::first[k]::last[k] using (beside(cost(0), k)):(stable(column(column_of[j]))):(column(error_of[j])) with yerrorbars pointtype filled[k] pointsize 0.8 linewidth 1.2 linecolor rgb colour[k], \
    NaN notitle
  unset label 1
  unset label 2
}
unset multiplot
