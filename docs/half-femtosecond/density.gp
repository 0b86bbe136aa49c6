# Restyle this and run it again: gnuplot draws density.svg.
image = "density.svg"
format = "svg"
width = 720
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
257 998.878 0.0766753
267 1003.33 0.0871721
277 1002.57 0.320587
287 1001.87 0.194728
298 999.384 0.0496675
308 995.43 0.0544024
318 991.934 0.0668753
EOD
$curve3 << EOD
257 997.559 0.269606
267 1001.87 0.142974
277 1001 0.148767
287 1000.33 0.143094
298 997.591 0.152739
308 993.812 0.176172
318 990.426 0.0920714
EOD
$curve4 << EOD
257 999.092 0.732193
267 1001.76 0.441393
277 999.727 0.184528
287 998.685 0.32362
298 996.161 0.603146
308 991.275 0.418816
318 988.008 0.0643887
EOD
set grid
set xlabel "temperature [K]"
set ylabel "density [kg/m³]"
set key bottom left
set arrow from 277.9264, 1002.1788 to 277.9264, 1001.1788 linecolor "#0072B2" linewidth 1.6
set arrow from 281.1157, 1000.9903 to 281.1157, 999.9903 linecolor "#D55E00" linewidth 1.6
set arrow from 277.2907, 1003.6066 to 277.2907, 1002.6066 linecolor "#009E73" linewidth 1.6
set arrow from 276.6138, 1002.0303 to 276.6138, 1001.0303 linecolor "#CC79A7" linewidth 1.6
set arrow from 268.7215, 1001.5159 to 268.7215, 1000.5159 linecolor "#E69F00" linewidth 1.6
plot $curve0 using 1:2:3 with yerrorbars linecolor "#0072B2" pointtype 7 title "limit of short steps: maximum at 277.9 K", \
  -0.0067185459*(x-287.429)**2 + -0.12768198*(x-287.429) + 1000.572125 with lines linewidth 1.6 linecolor "#0072B2" notitle, \
  $curve1 using 1:2:3 with yerrorbars linecolor "#D55E00" pointtype 7 title "gier4-fd, 4 fs: maximum at 281.1 K", \
  -0.0077959894*(x-287.429)**2 + -0.098430577*(x-287.429) + 999.6795798 with lines linewidth 1.6 linecolor "#D55E00" notitle, \
  $curve2 using 1:2:3 with yerrorbars linecolor "#009E73" pointtype 7 title "hoa2, 4 fs: maximum at 277.3 K", \
  -0.0068250719*(x-287.429)**2 + -0.13838306*(x-287.429) + 1001.905131 with lines linewidth 1.6 linecolor "#009E73" notitle, \
  $curve3 using 1:2:3 with yerrorbars linecolor "#CC79A7" pointtype 7 title "velocity-verlet, 2 fs: maximum at 276.6 K", \
  -0.0065819563*(x-287.429)**2 + -0.14236416*(x-287.429) + 1000.260508 with lines linewidth 1.6 linecolor "#CC79A7" notitle, \
  $curve4 using 1:2:3 with yerrorbars linecolor "#E69F00" pointtype 7 title "velocity-verlet, 4 fs: maximum at 268.7 K", \
  -0.0053809274*(x-287.429)**2 + -0.2013228*(x-287.429) + 998.6328274 with lines linewidth 1.6 linecolor "#E69F00" notitle
