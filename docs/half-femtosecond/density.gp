# Restyle this and run it again: gnuplot draws density.svg.
image = "density.svg"
format = "svg"
width = 760
height = 760
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

$curve0 << EOD
257 997.372 1.27346
267 1001.72 0.563636
277 1001.17 0.693171
287 1000.52 0.407076
298 998.254 0.4769
308 994.311 0.430856
318 991.031 0.195107
EOD
$curve1 << EOD
257 994.984 0.812018
267 998.784 0.792585
277 1000.72 0.948051
287 999.375 0.464021
298 997.129 0.345749
308 994.28 0.493529
318 989.707 0.633076
EOD
$curve2 << EOD
257 1.50618 0.0766753
267 1.61035 0.0871721
277 1.40098 0.320587
287 1.34988 0.194728
298 1.12974 0.0496675
308 1.11944 0.0544024
318 0.903229 0.0668753
EOD
$curve3 << EOD
257 0.187226 0.269606
267 0.152363 0.142974
277 -0.162259 0.148767
287 -0.192284 0.143094
298 -0.663238 0.152739
308 -0.498711 0.176172
318 -0.605337 0.0920714
EOD
$curve4 << EOD
257 1.7199 0.732193
267 0.0389788 0.441393
277 -1.43979 0.184528
287 -1.83426 0.32362
298 -2.09308 0.603146
308 -3.03588 0.418816
318 -3.0228 0.0643887
EOD
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.865
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 1 font small
plot NaN notitle, \
  keyentry with linespoints linewidth 1.6 dashtype 1 pointtype 7 linecolor "#404040" title "limit of short steps: maximum at 275.7 ± 1.2 K", \
  keyentry with linespoints linewidth 1.6 dashtype 1 pointtype 9 linecolor "#009E73" title "gier4-fd, 4 fs: maximum at 278.8 ± 1.3 K", \
  keyentry with linespoints linewidth 1.6 dashtype 1 pointtype 5 linecolor "#D55E00" title "hoa2, 4 fs: maximum at 275.3 ± 1.3 K", \
  keyentry with linespoints linewidth 1.6 dashtype 2 pointtype 6 linecolor "#0072B2" title "velocity-verlet, 2 fs: maximum at 274.8 ± 1.4 K", \
  keyentry with linespoints linewidth 1.6 dashtype 1 pointtype 7 linecolor "#0072B2" title "velocity-verlet, 4 fs: maximum at 270.3 ± 2.5 K"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set grid
set lmargin at screen 0.13
set xrange [254:321]
set tmargin at screen 0.855
set bmargin at screen 0.42
set format x ""
set ylabel "density  (kg/m³)"
set yrange [*:*]
plot 1000.550692*(x - 287.5)**0 + -0.2011521926*(x - 287.5)**1 + -0.006701534935*(x - 287.5)**2 + 0.0001004862455*(x - 287.5)**3 with lines linewidth 1.6 dashtype 1 linecolor "#404040" notitle, \
  999.6637625*(x - 287.5)**0 + -0.1512012731*(x - 287.5)**1 + -0.007783870664*(x - 287.5)**2 + 7.158717925e-05*(x - 287.5)**3 with lines linewidth 1.6 dashtype 1 linecolor "#009E73" notitle, \
  1001.882934*(x - 287.5)**0 + -0.2118684852*(x - 287.5)**1 + -0.00680806094*(x - 287.5)**2 + 0.0001004862455*(x - 287.5)**3 with lines linewidth 1.6 dashtype 1 linecolor "#D55E00" notitle, \
  1000.238028*(x - 287.5)**0 + -0.2158148546*(x - 287.5)**1 + -0.00656494533*(x - 287.5)**2 + 0.0001004862455*(x - 287.5)**3 with lines linewidth 1.6 dashtype 2 linecolor "#0072B2" notitle, \
  998.606142*(x - 287.5)**0 + -0.2746019176*(x - 287.5)**1 + -0.005363916425*(x - 287.5)**2 + 0.0001004862455*(x - 287.5)**3 with lines linewidth 1.6 dashtype 1 linecolor "#0072B2" notitle, \
  $curve0 using 1:2:3 with yerrorbars linewidth 1.2 pointtype 7 pointsize 0.9 linecolor "#404040" notitle, \
  $curve1 using 1:2:3 with yerrorbars linewidth 1.2 pointtype 9 pointsize 0.9 linecolor "#009E73" notitle
set tmargin at screen 0.39
set bmargin at screen 0.1
set format x "%g"
set xlabel "temperature  (K)"
set ylabel "predicted bias by the step  (kg/m³)"
set xzeroaxis linewidth 1 linecolor rgb ink
plot 1.332241879*(x - 287.5)**0 + -0.01071629259*(x - 287.5)**1 + -0.0001065260048*(x - 287.5)**2 with lines linewidth 1.6 dashtype 1 linecolor "#D55E00" notitle, \
  -0.3126644311*(x - 287.5)**0 + -0.01466266194*(x - 287.5)**1 + 0.0001365896044*(x - 287.5)**2 with lines linewidth 1.6 dashtype 2 linecolor "#0072B2" notitle, \
  -1.944550457*(x - 287.5)**0 + -0.07344972493*(x - 287.5)**1 + 0.00133761851*(x - 287.5)**2 with lines linewidth 1.6 dashtype 1 linecolor "#0072B2" notitle, \
  $curve2 using 1:2:3 with yerrorbars linewidth 1.2 pointtype 5 pointsize 0.9 linecolor "#D55E00" notitle, \
  $curve3 using 1:2:3 with yerrorbars linewidth 1.2 pointtype 6 pointsize 0.9 linecolor "#0072B2" notitle, \
  $curve4 using 1:2:3 with yerrorbars linewidth 1.2 pointtype 7 pointsize 0.9 linecolor "#0072B2" notitle
unset multiplot
