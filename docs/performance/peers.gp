# Restyle this and run it again: gnuplot draws peers.svg.
image = "peers.svg"
format = "svg"
width = 940
height = 410
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

set title offset 0,-0.6
set label 1000 "Builds as distributed; others are faster or slower: gromacs 2022.5-Debian_2022.5_2, mixed, SSE4.1; lammps 29 Sep 2021 - Update 2; openmm 8.6.1" at screen 0.01, screen 0.02 left noenhanced textcolor rgb ink font small
set style histogram clustered gap 1.5
set style fill solid 1 noborder
set boxwidth 0.9 relative
set datafile missing "?"
set xrange [-0.6:2.6]

$panel0 << EOD
"R = 1.5 %" 103.805 79.5389 116.852 870.218 3376 2638.58
"R = 0.4 %" 200.188 113.804 116.852 1767.35 6186.42 5200.45
"R = 0.1 %" 388.583 231.847 142.22 3983.39 13317.3 10197.7
EOD

set multiplot
# The key, in a strip of its own.
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.8537
set tmargin at screen 0.99
set key inside center center horizontal Left reverse noenhanced samplen 0.8 textcolor rgb ink
unset border
unset tics
unset grid
set yrange [0:1]
plot NaN with boxes linecolor "#0072B2" title "polhode velocity-verlet", \
  NaN with boxes linecolor "#D55E00" title "polhode hoa2", \
  NaN with boxes linecolor "#009E73" title "polhode gier4-fd", \
  NaN with boxes linecolor "#404040" title "gromacs", \
  NaN with boxes linecolor "#707070" title "lammps", \
  NaN with boxes linecolor "#9a9a9a" title "openmm"

unset key
set border 3
set xtics nomirror scale 0 textcolor rgb ink
set ytics nomirror out scale 0.6 textcolor rgb ink
set grid ytics linewidth 0.5 linecolor "#e4e4e4"
set logscale y
set format y "10^{%T}"
set yrange [10:26634.7]
set ylabel "seconds per nanosecond" textcolor rgb ink
set lmargin at screen 0.0851
set rmargin at screen 0.9894
set tmargin at screen 0.7561
set bmargin at screen 0.1463
unset label
set title "512 molecules, 1 thread"
plot $panel0 using 2:xtic(1) with histogram linecolor "#0072B2", \
  $panel0 using 3 with histogram linecolor "#D55E00", \
  $panel0 using 4 with histogram linecolor "#009E73", \
  $panel0 using 5 with histogram linecolor "#404040", \
  $panel0 using 6 with histogram linecolor "#707070", \
  $panel0 using 7 with histogram linecolor "#9a9a9a"
unset multiplot
