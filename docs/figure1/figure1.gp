# To change the figure, edit this script and run gnuplot on it: it draws figure1.png.
image = './figure1.png'
format = 'png'
width = 1000
height = 500
curves = 3
array name[3]
name[1] = 'velocity-verlet'
name[2] = 'hoa2'
name[3] = 'gier4-fd'
array colour[3]
colour[1] = '#0072B2'
colour[2] = '#D55E00'
colour[3] = '#009E73'
array filled[3]
filled[1] = 7
filled[2] = 5
filled[3] = 9
array open[3]
open[1] = 6
open[2] = 4
open[3] = 8
caption = 'Points further left and lower are better; R = 0 is exact dynamics. 512 tip4p; 10 runs of 15 ps per point.'
some_end = 1
some_rounded = 0
cost_low = 100.0000000
cost_high = 1100.000000
ratio_high = 3.500000000
all_cost_low = 133.3333333
all_cost_high = 1250.000000
all_ratio_low = 0.003285244724
all_ratio_high = 14.23326172
$points << EOD
# velocity-verlet
166.66667 8.8957886 0.080642891 1 0
200 5.8898905 0.076076484 0 0
250 3.8103222 0.044750856 0 0
285.71429 2.8657323 0.026810255 0 0
333.33333 2.1014306 0.019960123 0 0
400 1.4639758 0.012035201 0 0
500 0.93413104 0.012398277 0 0
666.66667 0.53020233 0.0062390122 0 0
1000 0.23144917 0.0028412263 0 0


# hoa2
285.71429 1.7961859 0.12684322 1 0
333.33333 0.82927351 0.023418938 0 0
400 0.5357535 0.015000121 0 0
500 0.34538951 0.011537789 0 0
666.66667 0.18539679 0.0030433541 0 0
1000 0.083632331 0.0020232413 0 0


# gier4-fd
375 3.0273455 0.33979595 1 0
428.57143 0.81967663 0.092567326 0 0
500 0.21308828 0.014750146 0 0
600 0.047917755 0.0017254835 0 0
750 0.015719669 0.00024578849 0 0
1000 0.0046932067 4.7902237e-05 0 0


EOD

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
