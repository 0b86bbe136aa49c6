# Columns of a CSV file as lines against its first column. Above: data, caption, x_label, y_label, and for each curve its
# column, name and colour.
set datafile separator ","
set datafile columnheaders
set title caption
set xlabel x_label noenhanced
set ylabel y_label noenhanced
set key outside right top
set autoscale xfix
if (curves == 1) {
  unset key
}
plot for [k=1:curves] data using 1:column_of[k] with lines linewidth 1.4 linecolor rgb colour[k] dashtype 1 + (k - 1)/7 title name[k]
