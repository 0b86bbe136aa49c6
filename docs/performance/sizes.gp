# Restyle this and run it again: gnuplot draws sizes.svg.
image = "sizes.svg"
format = "svg"
width = 720
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

set key outside top center horizontal maxcols 2
set label 1 "TIP4P at 1 g/cm³; polhode 0.1.0 with avx512 on AMD EPYC" at screen 0.02, screen 0.03 left noenhanced textcolor rgb ink font small
set bmargin at screen 0.2
set logscale x
set format x "10^{%T}"
set xrange [358.4:154829]
set xlabel "number of waters"
set ylabel "µs per molecule, one thread"
set yrange [0:2.81084]

$curve0 << EOD
512 0.4485
4096 0.482045
32768 0.513888
110592 0.536046
EOD
$curve1 << EOD
512 1.12605
4096 1.15199
32768 1.29044
110592 1.32493
EOD
$curve2 << EOD
512 0.847707
4096 0.938752
32768 0.985568
110592 1.10665
EOD
$curve3 << EOD
512 1.89291
4096 1.97656
32768 2.18803
110592 2.44421
EOD

plot $curve0 using 1:2 with linespoints linewidth 1.6 linecolor "#0072B2" pointtype 7 pointsize 0.9 title "a force evaluation, mixed", \
  $curve1 using 1:2 with linespoints linewidth 1.6 linecolor "#0072B2" pointtype 6 pointsize 0.9 title "a step of HOA2, mixed", \
  $curve2 using 1:2 with linespoints linewidth 1.6 linecolor "#D55E00" pointtype 5 pointsize 0.9 title "a force evaluation, double", \
  $curve3 using 1:2 with linespoints linewidth 1.6 linecolor "#D55E00" pointtype 4 pointsize 0.9 title "a step of HOA2, double"
