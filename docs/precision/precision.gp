# Restyle this and run it again: gnuplot draws precision.svg.
image = "precision.svg"
format = "svg"
width = 1000
height = 500
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

$velocity_verlet_mixed << EOD
0.5 0.0598298
1 0.228245
2 0.907061
3 2.11416
4 4.15247
EOD
$velocity_verlet_double << EOD
0.5 0.0627978
1 0.24092
2 1.05578
3 1.90375
4 4.17436
EOD
$hoa2_mixed << EOD
0.5 0.00616705
1 0.0206558
2 0.0794756
3 0.171969
4 0.375956
EOD
$hoa2_double << EOD
0.5 0.00499018
1 0.0194731
2 0.0764626
3 0.185229
4 0.337492
EOD
$gier4_fd_mixed << EOD
0.5 0.00341784
1 0.00333467
2 0.00331533
3 0.00572405
4 0.0144315
5 0.0432099
EOD
$gier4_fd_double << EOD
0.5 3.73454e-06
1 5.73318e-05
2 0.000921835
3 0.00472868
4 0.0157882
5 0.0396921
EOD
$growth_gier4_fd_mixed << EOD
0.25 0.00261093
0.5 0.00261839
1 0.00262232
2 0.00262929
4 0.00263274
8 0.002643
16 0.0026443
EOD
$growth_gier4_fd_double << EOD
0.25 4.49073e-05
0.5 4.49391e-05
1 4.49853e-05
2 4.50408e-05
4 4.50651e-05
8 4.51827e-05
16 4.58404e-05
EOD
$growth_hoa2_mixed << EOD
0.25 0.100556
0.5 0.118671
1 0.127624
2 0.146289
4 0.159644
8 0.151843
16 0.15593
EOD
$growth_hoa2_double << EOD
0.25 0.0915746
0.5 0.110767
1 0.124371
2 0.14706
4 0.158985
8 0.145905
16 0.153367
EOD

set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.88
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 4 font small
plot NaN notitle, \
  keyentry with linespoints linewidth 1.6 pointtype 7 linecolor "#0072B2" title "velocity-verlet", \
  keyentry with linespoints linewidth 1.6 pointtype 5 linecolor "#D55E00" title "hoa2", \
  keyentry with linespoints linewidth 1.6 pointtype 9 linecolor "#009E73" title "gier4-fd", \
  keyentry with linespoints linewidth 1.6 pointtype 7 linecolor rgb ink title "mixed precision", \
  keyentry with linespoints linewidth 1.6 dashtype 2 pointtype 6 linecolor rgb ink title "double precision", \
  keyentry with lines linewidth 1.2 dashtype 3 linecolor rgb ink title "rounding of gier4-fd, mixed", \
  keyentry with lines linewidth 1.2 dashtype 4 linecolor rgb ink title "its random walk"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set title offset 0,-0.4 textcolor "#404040"
set bmargin at screen 0.13
set tmargin at screen 0.80
set logscale xy
set format y "10^{%T}"

set lmargin at screen 0.095
set rmargin at screen 0.475
set title "runs of 2 ps"
set xlabel "time step  (fs)" offset 0,0.3
set ylabel "R  (%)"
set xtics (0.5, 1, 2, 3, 4, 5)
set xrange [0.42:6]
set yrange [1e-06:10]
plot $velocity_verlet_mixed using 1:2 with linespoints linewidth 1.6 dashtype 1 pointsize 0.8 pointtype 7 linecolor "#0072B2" notitle, \
  $velocity_verlet_double using 1:2 with linespoints linewidth 1.6 dashtype 2 pointsize 1.2 pointtype 6 linecolor "#0072B2" notitle, \
  $hoa2_mixed using 1:2 with linespoints linewidth 1.6 dashtype 1 pointsize 0.8 pointtype 5 linecolor "#D55E00" notitle, \
  $hoa2_double using 1:2 with linespoints linewidth 1.6 dashtype 2 pointsize 1.2 pointtype 4 linecolor "#D55E00" notitle, \
  $gier4_fd_mixed using 1:2 with linespoints linewidth 1.6 dashtype 1 pointsize 0.8 pointtype 9 linecolor "#009E73" notitle, \
  $gier4_fd_double using 1:2 with linespoints linewidth 1.6 dashtype 2 pointsize 1.2 pointtype 8 linecolor "#009E73" notitle, \
  0.00336928 with lines linewidth 1.2 dashtype 3 linecolor rgb ink notitle

set lmargin at screen 0.595
set rmargin at screen 0.985
set title "one run of 16 ps: gier4-fd at 1 fs, hoa2 at 3 fs"
set xlabel "length of a window  (ps)" offset 0,0.3
set ylabel "rms of E about its mean  (kJ/mol)"
set xtics (0.25, 0.5, 1, 2, 4, 8, 16, 32)
set xrange [0.2:20]
set yrange [1e-05:1]
plot $growth_gier4_fd_mixed using 1:2 with linespoints linewidth 1.6 dashtype 1 pointsize 0.8 pointtype 9 linecolor "#009E73" notitle, \
  $growth_gier4_fd_double using 1:2 with linespoints linewidth 1.6 dashtype 2 pointsize 1.2 pointtype 8 linecolor "#009E73" notitle, \
  $growth_hoa2_mixed using 1:2 with linespoints linewidth 1.6 dashtype 1 pointsize 0.8 pointtype 5 linecolor "#D55E00" notitle, \
  $growth_hoa2_double using 1:2 with linespoints linewidth 1.6 dashtype 2 pointsize 1.2 pointtype 4 linecolor "#D55E00" notitle, \
  sqrt(6.79645e-06 + 2.08333e-08*x) with lines linewidth 1.2 dashtype 3 linecolor rgb ink notitle, \
  sqrt(2.08333e-08*x) with lines linewidth 1.2 dashtype 4 linecolor rgb ink notitle
unset multiplot
