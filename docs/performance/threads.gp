# Restyle this and run it again: gnuplot draws threads.svg.
image = "threads.svg"
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
set label 1 "TIP4P, mixed precision, velocity Verlet; Intel(R) Xeon(R) Processor, 2026-11-23" at screen 0.02, screen 0.03 left noenhanced textcolor rgb ink font small
set bmargin at screen 0.2
set logscale x
set format x "10^{%T}"
set xrange [358.4:154829]
set xlabel "number of waters"
set ylabel "speed-up of a step by 2 threads"
set yrange [0:2.28248]

$curve0 << EOD
512 1.42999
4096 1.69083
32768 1.63716
110592 1.98477
EOD
$curve1 << EOD
512 1.34244
4096 1.48304
32768 1.67211
110592 1.56345
EOD

plot 2 with lines linewidth 1 dashtype 3 linecolor rgb ink title "ideal", \
  $curve0 using 1:2 with linespoints linewidth 1.6 linecolor "#0072B2" pointtype 7 pointsize 0.9 title "reaction field", \
  $curve1 using 1:2 with linespoints linewidth 1.6 linecolor "#009E73" pointtype 9 pointsize 0.9 title "Ewald sum"
