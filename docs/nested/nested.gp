# Restyle this and run it again: gnuplot draws nested.svg.
image = "nested.svg"
format = "svg"
width = 1000
height = 680
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

$c0r0k0u << EOD
1000 0.22402
666.667 0.5222
500 0.92876
400 1.4861
333.333 2.0759
EOD
$c0r0k1u << EOD
1000 0.08273
666.667 0.16551
500 0.31496
400 0.48996
333.333 0.67086
EOD
$c0r0k2u << EOD
375 0.63172
333.333 0.84842
300 1.0163
250 1.6836
EOD
$c0r0k3u << EOD
750 0.015342
600 0.040911
500 0.16861
EOD
$c0r0k4u << EOD
732.993 0.012564
549.745 0.067334
439.796 0.45536
EOD
$c0r0k5u << EOD
400.774 0.2968
356.243 0.50474
320.619 0.64712
267.182 1.9664
EOD
$c0r0k6u << EOD
437.423 0.38351
328.067 0.52286
262.454 0.94064
EOD
$c0r0k7u << EOD
360.34 0.47745
288.272 0.80374
EOD
$c0r0k8u << EOD
355.478 0.56092
304.695 0.92579
EOD
$c0r0k9u << EOD
593.07 0.39263
444.802 0.72933
EOD
$c0r1k0u << EOD
1 0.22402
1.5 0.5222
2 0.92876
2.5 1.4861
3 2.0759
EOD
$c0r1k1u << EOD
2 0.08273
3 0.16551
4 0.31496
5 0.48996
6 0.67086
EOD
$c0r1k2u << EOD
8 0.63172
9 0.84842
10 1.0163
12 1.6836
EOD
$c0r1k3u << EOD
4 0.015342
5 0.040911
6 0.16861
EOD
$c0r1k4u << EOD
6 0.012564
8 0.067334
10 0.45536
EOD
$c0r1k5u << EOD
8 0.2968
9 0.50474
10 0.64712
12 1.9664
EOD
$c0r1k6u << EOD
6 0.38351
8 0.52286
10 0.94064
EOD
$c0r1k7u << EOD
8 0.47745
10 0.80374
EOD
$c0r1k8u << EOD
12 0.56092
14 0.92579
EOD
$c0r1k9u << EOD
3 0.39263
4 0.72933
EOD
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.82
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 2 font small
plot NaN notitle, \
  keyentry with linespoints pointtype 7 linewidth 1.6 linecolor "#0072B2" title "velocity-verlet", \
  keyentry with linespoints pointtype 5 linewidth 1.6 linecolor "#D55E00" title "hoa2", \
  keyentry with linespoints pointtype 13 linewidth 1.6 linecolor "#CC79A7" title "bcss3", \
  keyentry with linespoints pointtype 9 linewidth 1.6 linecolor "#009E73" title "gier4-fd", \
  keyentry with linespoints pointtype 13 linewidth 1.6 linecolor "#332288" title "gier4-fd / gier4-fd x 1 within 0.49 to 0.7 nm", \
  keyentry with linespoints pointtype 15 linewidth 1.6 linecolor "#AA4499" title "hoa2 / gier4-fd x 1 within 0.49 to 0.7 nm", \
  keyentry with linespoints pointtype 7 linewidth 1.6 linecolor "#44AA99" title "hoa2 / hoa2 x 1 within 0.42 to 0.6 nm", \
  keyentry with linespoints pointtype 5 linewidth 1.6 linecolor "#661100" title "hoa2 / bcss3 x 1 within 0.42 to 0.6 nm", \
  keyentry with linespoints pointtype 9 linewidth 1.6 linecolor "#DDAA33" title "bcss3 / hoa2 x 1 within 0.49 to 0.7 nm", \
  keyentry with linespoints pointtype 11 linewidth 1.6 linecolor "#7F7F7F" title "velocity-verlet / hoa2 x 2 within 0.49 to 0.7 nm"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set label 1 "cost: evaluations of all forces, and of near forces times their share of the time.  outer / inner x n within r: n inner steps an outer drift, near forces up to r.  Crossed: R above 10 %" at screen 0.01, screen 0.03 left noenhanced textcolor rgb ink font small
set tmargin at screen 0.76
set bmargin at screen 0.155
set ylabel "R  (%)" offset 2
set logscale y
set format y "%g"
set yrange [0.01:30]
set lmargin at screen 0.0750
set rmargin at screen 0.4850
set xlabel "cost:  force evaluations per ps" offset 0,0.4
set title "pme"
set logscale x
set xtics (100, 150, 200, 300, 400, 600, 1000)
set xrange [225:1100]
plot $c0r0k0u using 1:2 with linespoints pointtype 7 pointsize 0.8 linewidth 1.6 linecolor "#0072B2" notitle, $c0r0k1u using 1:2 with linespoints pointtype 5 pointsize 0.8 linewidth 1.6 linecolor "#D55E00" notitle, $c0r0k2u using 1:2 with linespoints pointtype 13 pointsize 0.8 linewidth 1.6 linecolor "#CC79A7" notitle, $c0r0k3u using 1:2 with linespoints pointtype 9 pointsize 0.8 linewidth 1.6 linecolor "#009E73" notitle, $c0r0k4u using 1:2 with linespoints pointtype 13 pointsize 0.8 linewidth 1.6 linecolor "#332288" notitle, $c0r0k5u using 1:2 with linespoints pointtype 15 pointsize 0.8 linewidth 1.6 linecolor "#AA4499" notitle, $c0r0k6u using 1:2 with linespoints pointtype 7 pointsize 0.8 linewidth 1.6 linecolor "#44AA99" notitle, $c0r0k7u using 1:2 with linespoints pointtype 5 pointsize 0.8 linewidth 1.6 linecolor "#661100" notitle, $c0r0k8u using 1:2 with linespoints pointtype 9 pointsize 0.8 linewidth 1.6 linecolor "#DDAA33" notitle, $c0r0k9u using 1:2 with linespoints pointtype 11 pointsize 0.8 linewidth 1.6 linecolor "#7F7F7F" notitle
set lmargin at screen 0.5750
set rmargin at screen 0.9850
set xlabel "outer step  (fs)" offset 0,0.4
set title "pme"
unset logscale x
set xtics autofreq
set xrange [0:*]
plot $c0r1k0u using 1:2 with linespoints pointtype 7 pointsize 0.8 linewidth 1.6 linecolor "#0072B2" notitle, $c0r1k1u using 1:2 with linespoints pointtype 5 pointsize 0.8 linewidth 1.6 linecolor "#D55E00" notitle, $c0r1k2u using 1:2 with linespoints pointtype 13 pointsize 0.8 linewidth 1.6 linecolor "#CC79A7" notitle, $c0r1k3u using 1:2 with linespoints pointtype 9 pointsize 0.8 linewidth 1.6 linecolor "#009E73" notitle, $c0r1k4u using 1:2 with linespoints pointtype 13 pointsize 0.8 linewidth 1.6 linecolor "#332288" notitle, $c0r1k5u using 1:2 with linespoints pointtype 15 pointsize 0.8 linewidth 1.6 linecolor "#AA4499" notitle, $c0r1k6u using 1:2 with linespoints pointtype 7 pointsize 0.8 linewidth 1.6 linecolor "#44AA99" notitle, $c0r1k7u using 1:2 with linespoints pointtype 5 pointsize 0.8 linewidth 1.6 linecolor "#661100" notitle, $c0r1k8u using 1:2 with linespoints pointtype 9 pointsize 0.8 linewidth 1.6 linecolor "#DDAA33" notitle, $c0r1k9u using 1:2 with linespoints pointtype 11 pointsize 0.8 linewidth 1.6 linecolor "#7F7F7F" notitle
unset multiplot
