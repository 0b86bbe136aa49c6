# Bias of canonical averages against cost, a panel for each quantity, and the cost of an independent sample. Above: for each
# scheme its name, colour, filled marker; caption; panels, panel (titles), strict1.., loose1.. (bounds; 0: none, a logarithmic
# axis), low1.., high1.. (of the vertical axes); cost_low, cost_high; $points, a block per scheme: force evaluations per ps, then value and
# standard error for each panel.
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
set xrange [cost_low:cost_high]
do for [j=1:panels] {
  place = (j - 1)%across
  row = (j - 1)/across
  set lmargin at screen left + (right - left)*(place + 0.17)/across
  set rmargin at screen left + (right - left)*(place + 0.99)/across
  set tmargin at screen top - (top - bottom)*(row + 0.12)/down
  set bmargin at screen top - (top - bottom)*(row + 0.93)/down
  set label 3 panel[j] at graph 0, graph 1.06 left noenhanced textcolor rgb ink
  strict = value(sprintf("strict%d", j))
  loose = value(sprintf("loose%d", j))
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
  set yrange [value(sprintf("low%d", j)):value(sprintf("high%d", j))]
  plot for [k=1:curves] $points index k-1 using (beside($1, k)):(column(2*j)) with lines linewidth 1.6 linecolor rgb colour[k], \
    for [k=1:curves] $points index k-1 using (beside($1, k)):(column(2*j)):(column(2*j+1)) with yerrorbars pointtype filled[k] pointsize 0.8 linewidth 1.2 linecolor rgb colour[k], \
    NaN notitle
  unset label 1
  unset label 2
}
unset multiplot
