# Restyle this and run it again: gnuplot draws bias.svg.
image = "bias.svg"
format = "svg"
width = 960
height = 520
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
set key inside center center horizontal maxcols 5 font small
plot NaN notitle, \
  keyentry with linespoints linecolor "#56B4E9" pointtype 9 title "4mn5fv", \
  keyentry with linespoints linecolor "#CC79A7" pointtype 13 title "bcss3", \
  keyentry with linespoints linecolor "#009E73" pointtype 9 title "gier4-fd", \
  keyentry with linespoints linecolor "#D55E00" pointtype 5 title "hoa2", \
  keyentry with linespoints linecolor "#0072B2" pointtype 7 title "velocity-verlet"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set logscale xy
set grid
set xlabel "force evaluations per ps"
set xrange [150:3000]
set yrange [*:*]
set xtics (200, 500, 1000, 2000)
set format y "10^{%T}"
set tmargin at screen 0.85
set bmargin at screen 0.14
$curve0 << EOD
1000 0.000431935 4.31935e-05 0.00164756
714.286 0.0267857 0.00267857 0.0523086
555.556 0.156833 0.0739943 0.239673
EOD
$curve1 << EOD
1000 0.216557 0.203801 0.229312
666.667 0.486193 0.473484 0.498902
500 0.899151 0.879513 0.918789
400 1.35396 1.2695 1.43842
333.333 2.05705 1.96158 2.15253
EOD
$curve2 << EOD
1000 0.00541545 0.00492145 0.00590945
750 0.0207427 0.0142083 0.0272771
600 0.0575295 0.0492034 0.0658555
500 0.178974 0.156061 0.201887
EOD
$curve3 << EOD
1000 0.159744 0.153433 0.166055
666.667 0.382934 0.370558 0.395311
500 0.649943 0.620009 0.679876
400 0.824237 0.794908 0.853566
333.333 1.4404 1.3519 1.5289
285.714 1.51017 1.2952 1.72514
EOD
$curve4 << EOD
2000 0.12999 0.128624 0.131356
1000 0.522871 0.508061 0.537681
500 2.08897 2.04839 2.12954
333.333 4.6569 4.63275 4.68105
250 8.15112 7.97557 8.32667
EOD
set lmargin at screen 0.09
set rmargin at screen 0.48
set ylabel "|T_{rot} − T_{trans}| by the step [K]"
set label 1 "0.1 K" at graph 0.03, first 0.125 font small textcolor rgb ink
plot 0.1 with lines linewidth 1 dashtype 3 linecolor rgb ink notitle, \
  $curve0 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#56B4E9" pointtype 9 pointsize 0.9 notitle, \
  $curve1 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#CC79A7" pointtype 13 pointsize 0.9 notitle, \
  $curve2 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#009E73" pointtype 9 pointsize 0.9 notitle, \
  $curve3 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#D55E00" pointtype 5 pointsize 0.9 notitle, \
  $curve4 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#0072B2" pointtype 7 pointsize 0.9 notitle
$curve0 << EOD
1000 1.11135e-06 1.11135e-07 9.918e-06
714.286 3.86287e-05 3.86287e-06 0.000189115
555.556 0.00419865 0.00302269 0.00537461
EOD
$curve1 << EOD
1000 0.00264019 0.00259002 0.00269036
666.667 0.00627396 0.00614195 0.00640598
500 0.0106235 0.0105545 0.0106925
400 0.0175214 0.0169462 0.0180965
333.333 0.0251772 0.023735 0.0266194
EOD
$curve2 << EOD
1000 8.95977e-05 8.49574e-05 9.4238e-05
750 0.000272824 0.000265021 0.000280627
600 0.000749333 0.000652061 0.000846605
500 0.00138444 0.000138444 0.00269357
EOD
$curve3 << EOD
1000 0.00188962 0.00186429 0.00191495
666.667 0.00416809 0.0039411 0.00439509
500 0.00796338 0.00774625 0.00818051
400 0.011731 0.0112138 0.0122483
333.333 0.0150237 0.0136305 0.0164169
285.714 0.019301 0.0181088 0.0204933
EOD
$curve4 << EOD
2000 0.00196563 0.00192472 0.00200653
1000 0.00783973 0.007799 0.00788047
500 0.0314174 0.031067 0.0317678
333.333 0.0698771 0.0676758 0.0720783
250 0.134344 0.131389 0.137298
EOD
set lmargin at screen 0.59
set rmargin at screen 0.98
set ylabel "|potential energy| by the step [kJ/mol]"
set label 1 "0.01 kJ/mol" at graph 0.03, first 0.0125 font small textcolor rgb ink
plot 0.01 with lines linewidth 1 dashtype 3 linecolor rgb ink notitle, \
  $curve0 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#56B4E9" pointtype 9 pointsize 0.9 notitle, \
  $curve1 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#CC79A7" pointtype 13 pointsize 0.9 notitle, \
  $curve2 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#009E73" pointtype 9 pointsize 0.9 notitle, \
  $curve3 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#D55E00" pointtype 5 pointsize 0.9 notitle, \
  $curve4 using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "#0072B2" pointtype 7 pointsize 0.9 notitle
unset multiplot
