# Restyle this and run it again: gnuplot draws accuracy.svg.
image = "accuracy.svg"
format = "svg"
width = 1000
height = 400
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

set title offset 0,-0.4
set label 1 "512 TIP4P waters, runs of 100 ps. Differences from the most accurate run, from the same configurations; bars are one standard error." at screen 0.015, screen 0.045 left noenhanced textcolor rgb ink font small

$velocity_verlet << EOD
0.22833548 1.8754278 0.66928243 -1.634169 1.7780575 -0.18218171 0.34157772
0.93454922 0.50410402 0.97609607 -1.2296554 1.5512675 -2.2577166 0.3334106
2.0817509 1.009326 1.8090727 -3.0520811 1.03636 -4.9709644 0.27042713
3.7511535 2.5226214 0.6576869 -5.5168477 1.5217344 -9.3005962 0.41436966
5.9550933 2.7497936 1.0587089 -5.1731379 0.9442089 -13.496706 0.22738759
EOD
$hoa2 << EOD
0.3402615 0.14665579 1.5091279 1.2989579 0.66429121 0.05922133 0.34058911
1.0920687 0.660111 0.96197808 -0.98024286 0.77353759 -1.7087799 0.22563094
EOD
$gier4 << EOD
0.0079312995 0 0 0 0 -0.2855028 0.37323577
EOD

set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.9
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 3 font small
plot NaN notitle, \
  keyentry with points pointtype 7 linecolor "#0072B2" title "velocity-verlet", \
  keyentry with points pointtype 5 linecolor "#D55E00" title "hoa2", \
  keyentry with points pointtype 11 linecolor "#117733" title "gier4"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set bmargin at screen 0.25
set tmargin at screen 0.78
set logscale x
set format x "%g"
set xlabel "R  (%)"
set xzeroaxis linewidth 1 linecolor rgb ink
set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1
set xrange [*:*]
set yrange [*:*]
set title "diffusion, difference  (%)"
set lmargin at screen 0.06
set rmargin at screen 0.325
plot $velocity_verlet using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" notitle, $hoa2 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" notitle, $gier4 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 11 linecolor "#117733" notitle
unset label 1
set title "relaxation of the dipole, difference  (%)"
set lmargin at screen 0.39
set rmargin at screen 0.655
plot $velocity_verlet using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" notitle, $hoa2 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" notitle, $gier4 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 11 linecolor "#117733" notitle
set title "T of rotation less T of translation  (K)"
set lmargin at screen 0.72
set rmargin at screen 0.985
plot $velocity_verlet using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" notitle, $hoa2 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" notitle, $gier4 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 11 linecolor "#117733" notitle
unset multiplot
