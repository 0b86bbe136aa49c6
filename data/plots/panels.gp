# Columns of a CSV file against its first column, a panel for each with a common x axis. Above: as for curves.gp.
set datafile separator ","
set datafile columnheaders
across = curves <= 4 ? 2 : curves <= 12 ? 3 : 4
down = ceil(real(curves)/across)
set autoscale xfix
set xtics font small
set ytics font small
unset key
set label 1 caption at screen 0.5, screen 0.97 center noenhanced textcolor rgb ink
set label 2 x_label at screen 0.5, screen 0.025 center noenhanced textcolor rgb ink
set label 3 y_label at screen 0.02, screen 0.5 center rotate noenhanced textcolor rgb ink
left = 0.045; right = 0.985; bottom = 0.085; top = 0.94
set multiplot
do for [k=1:curves] {
  i = (k - 1)%across
  j = (k - 1)/across
  set lmargin at screen left + (right - left)*(i + 0.18)/across
  set rmargin at screen left + (right - left)*(i + 1)/across
  set tmargin at screen top - (top - bottom)*(j + 0.04)/down
  set bmargin at screen top - (top - bottom)*(j + 0.92)/down
  set yrange [*:*]
  stats data using (column(column_of[k])) name "C" nooutput
  set yrange [0:C_max > 0 ? 1.2*C_max : 1]
  set label 4 name[k] at graph 0.97, graph 0.92 right noenhanced textcolor rgb ink font small
  # Numbers of the x axis below the last panel of each column.
  format_x = k + across > curves ? "%g" : ""
  set format x format_x
  plot data using 1:column_of[k] with lines linewidth 1.4 linecolor rgb colour[1]
  unset label 1
  unset label 2
  unset label 3
}
unset multiplot
