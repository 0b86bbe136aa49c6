# Restyle this and run it again: gnuplot draws peers.svg.
image = "peers.svg"
format = "svg"
width = 860
height = 470
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

set label 1000 "Builds as distributed; others are faster or slower: gromacs 2022.5-Debian_2022.5_2, mixed, SSE4.1; lammps 29 Sep 2021 - Update 2; openmm 8.6.1" at screen 0.01, screen 0.02 left noenhanced textcolor rgb ink font small

$panel0_0 << EOD
1.5 103.805
0.4 200.188
0.1 388.583
EOD
$panel0_1 << EOD
1.5 79.5389
0.4 113.804
0.1 231.847
EOD
$panel0_2 << EOD
1.5 116.852
0.4 116.852
0.1 142.22
EOD
$panel0_3 << EOD
1.5 870.218
0.4 1767.35
0.1 3983.39
EOD
$panel0_4 << EOD
1.5 3376
0.4 6186.42
0.1 13317.3
EOD
$panel0_5 << EOD
1.5 2638.58
0.4 5200.45
0.1 10197.7
EOD

set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.8723
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 3 font small
plot NaN notitle, \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 7 linecolor "#0072B2" title "polhode velocity-verlet", \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 5 linecolor "#D55E00" title "polhode hoa2", \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 9 linecolor "#009E73" title "polhode gier4-fd", \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 4 linecolor "#404040" title "gromacs", \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 6 linecolor "#707070" title "lammps", \
  keyentry with linespoints linewidth 1.4 pointsize 1.1 pointtype 8 linecolor "#9a9a9a" title "openmm"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

unset label 1000
set title offset 0,-0.4
set logscale xy
set xlabel "required R  (%)" offset 0,0.3
set ylabel "seconds per nanosecond" textcolor rgb ink
set xtics (0.1, 0.4, 1.5)
set format y "10^{%T}"
set xrange [2.4:0.0625]
set yrange [47.7234:21307.8]
set lmargin at screen 0.0930
set rmargin at screen 0.9884
set tmargin at screen 0.7872
set bmargin at screen 0.1702
set title "512 molecules, 1 thread"
set label 1001 "" at graph 0.02, graph 0.04 left noenhanced textcolor rgb ink font small
plot $panel0_0 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 7 linecolor "#0072B2" notitle, \
  $panel0_1 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 5 linecolor "#D55E00" notitle, \
  $panel0_2 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 9 linecolor "#009E73" notitle, \
  $panel0_3 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 4 linecolor "#404040" notitle, \
  $panel0_4 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 6 linecolor "#707070" notitle, \
  $panel0_5 using 1:2 with linespoints linewidth 1.4 pointsize 1.1 pointtype 8 linecolor "#9a9a9a" notitle
unset multiplot
