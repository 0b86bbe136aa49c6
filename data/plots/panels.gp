# Columns of a CSV file against its first column, in panels with a common horizontal axis; bands are standard errors. Above: data,
# caption, x_label, y_label; left and right, the ends of the horizontal axis; panels, across (in a row); head, the pixels above each,
# with legend_rows; for each panel title_of, legend_columns, low_of and high_of (its vertical axis), and the first and the last of its
# curves, bands and lines; for each curve its name, colour, column_of and error_of; banded, the curves with bands; for each line
# line_name, and two elements of line_x and line_y.
set datafile separator ","
set datafile columnheaders
down = ceil(real(panels)/across)
set xtics font small
set ytics font small
set label 1 caption at screen 0.5, screen 1 - 20.0/height center noenhanced textcolor rgb ink
set label 2 x_label at screen 0.5, screen 14.0/height center noenhanced textcolor rgb ink
set label 3 y_label at screen 14.0/width, screen 0.5 center rotate noenhanced textcolor rgb ink
wide = (width - 34.0)/across  # [pixels] of a panel
high = (height - 84.0)/down
set xrange [left:right]
set xtics tic(right - left)
# Ends of a band; no width where the error is not known.
error(k) = valid(error_of[k]) ? column(error_of[k]) : 0
below(k) = column(column_of[k]) - error(k)
above(k) = column(column_of[k]) + error(k)
set multiplot
do for [p=1:panels] {
  i = (p - 1)%across
  j = (p - 1)/across
  set lmargin at screen (34 + i*wide + 52)/width
  set rmargin at screen (34 + (i + 1)*wide - 12)/width
  set tmargin at screen 1 - (40 + j*high + head)/height
  set bmargin at screen 1 - (40 + (j + 1)*high - 18)/height
  set yrange [low_of[p]:high_of[p]]
  # The title above the legend, both above the panel.
  tall = high - head - 18
  set label 4 title_of[p] at graph 0, graph 1 + (14 + 18*legend_rows)/tall left noenhanced textcolor rgb ink
  set key at graph 0, graph 1 + 4/tall left bottom horizontal maxcols legend_columns[p] font small
  # Numbers of the horizontal axis below the last panel of each column.
  format_x = p + across > panels ? "%g" : ""
  set format x format_x
  plot for [m=first_band[p]:last_band[p]] data using 1:(below(banded[m])):(above(banded[m])) \
      with filledcurves fillcolor rgb colour[banded[m]] fillstyle transparent solid 0.25 noborder notitle, \
    for [k=first_curve[p]:last_curve[p]] data using 1:(column(column_of[k])) with lines linewidth 1.4 linecolor rgb colour[k] title name[k], \
    for [k=first_line[p]:last_line[p]] '+' every ::0::0 using (line_x[2*k-1]):(line_y[2*k-1]):(line_x[2*k] - line_x[2*k-1]):(line_y[2*k] - line_y[2*k-1]) \
      with vectors nohead linewidth 1.6 dashtype 2 linecolor "#000000" title line_name[k]
  unset label 1
  unset label 2
  unset label 3
}
unset multiplot
