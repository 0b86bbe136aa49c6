# Restyle this and run it again: gnuplot draws figure1.png.
set encoding utf8
set minussign
set terminal pngcairo size 1440,1080 fontscale 2 linewidth 2 pointscale 2 enhanced font "Helvetica,11" background "white"
set output './figure1.png'
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"

# velocity-verlet: force evaluations per ps, R [%], its standard error, last stable, rounded
$curve0 << EOD
166.66667 8.8957886 0.0806 1 0
200 5.8898905 0.0761 0 0
250 3.8103222 0.0448 0 0
285.71429 2.8657323 0.0268 0 0
333.33333 2.1014306 0.02 0 0
400 1.4639758 0.012 0 0
500 0.93413104 0.0124 0 0
666.66667 0.53020233 0.00624 0 0
1000 0.23144917 0.00284 0 0
EOD

# hoa2: force evaluations per ps, R [%], its standard error, last stable, rounded
$curve1 << EOD
285.71429 1.7961859 0.127 1 0
333.33333 0.82927351 0.0234 0 0
400 0.5357535 0.015 0 0
500 0.34538951 0.0115 0 0
666.66667 0.18539679 0.00304 0 0
1000 0.083632331 0.00202 0 0
EOD

# gier4-fd: force evaluations per ps, R [%], its standard error, last stable, rounded
$curve2 << EOD
375 3.0273455 0.34 1 0
428.57143 0.81967663 0.0926 0 0
500 0.21308828 0.0148 0 0
600 0.047917755 0.00173 0 0
750 0.015719669 0.000246 0 0
1000 0.0046932067 4.79e-05 0 0
EOD

set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set bmargin at screen 0.15
set tmargin at screen 0.88
set key tmargin center horizontal Left reverse noenhanced samplen 1.6 width 0 textcolor "#404040"
set xlabel "force evaluations per ps" offset 0,0.2
set ylabel "R  (%)" offset 0.8
set xrange [100:1100]
set yrange [0:3.5]
plot \
  $curve0 using 1:2 with lines linewidth 1.6 linecolor "#0072B2" notitle, \
  '' using 1:2:3 with yerrorbars pointtype -1 linewidth 1 linecolor "#0072B2" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 7 pointsize 0.9 linecolor "#0072B2" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 7 pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 6 pointsize 1.26 linewidth 1.6 linecolor "#0072B2" notitle, \
  NaN with linespoints linewidth 1.6 pointtype 7 pointsize 0.9 linecolor "#0072B2" title 'velocity-verlet', \
  $curve1 using 1:2 with lines linewidth 1.6 linecolor "#D55E00" notitle, \
  '' using 1:2:3 with yerrorbars pointtype -1 linewidth 1 linecolor "#D55E00" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 5 pointsize 0.9 linecolor "#D55E00" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 5 pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 4 pointsize 1.26 linewidth 1.6 linecolor "#D55E00" notitle, \
  NaN with linespoints linewidth 1.6 pointtype 5 pointsize 0.9 linecolor "#D55E00" title 'hoa2', \
  $curve2 using 1:2 with lines linewidth 1.6 linecolor "#009E73" notitle, \
  '' using 1:2:3 with yerrorbars pointtype -1 linewidth 1 linecolor "#009E73" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 9 pointsize 0.9 linecolor "#009E73" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 9 pointsize 1.26 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 8 pointsize 1.26 linewidth 1.6 linecolor "#009E73" notitle, \
  NaN with linespoints linewidth 1.6 pointtype 9 pointsize 0.9 linecolor "#009E73" title 'gier4-fd', \
  NaN with points pointtype 6 pointsize 1.3 linewidth 1.6 linecolor "#404040" title "stability limit"

#Everything, on logarithmic axes.
set lmargin at screen 0.52
set rmargin at screen 0.955
set bmargin at screen 0.50
set tmargin at screen 0.865
unset key
set border 15
set logscale xy
set xlabel "" 
set ylabel ""
set tics font ",9"
set xtics (100, 200, 500, 1000, 2000, 5000, 10000)
set format y "10^{%T}"
set xrange [133.333:1250]
set yrange [0.00328524:14.2333]
plot \
  $curve0 using 1:2 with lines linewidth 1 linecolor "#0072B2" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 7 pointsize 0.45 linecolor "#0072B2" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 7 pointsize 0.63 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 6 pointsize 0.63 linewidth 1.6 linecolor "#0072B2" notitle, \
  $curve1 using 1:2 with lines linewidth 1 linecolor "#D55E00" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 5 pointsize 0.45 linecolor "#D55E00" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 5 pointsize 0.63 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 4 pointsize 0.63 linewidth 1.6 linecolor "#D55E00" notitle, \
  $curve2 using 1:2 with lines linewidth 1 linecolor "#009E73" notitle, \
  '' using 1:($4 == 0 ? $2 : NaN) with points pointtype 9 pointsize 0.45 linecolor "#009E73" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 9 pointsize 0.63 linewidth 0 linecolor "white" notitle, \
  '' using 1:($4 == 1 ? $2 : NaN) with points pointtype 8 pointsize 0.63 linewidth 1.6 linecolor "#009E73" notitle, NaN notitle
unset multiplot
