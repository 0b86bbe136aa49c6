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
257 995.266 1.10428
267 1000.8 0.385012
277 1001.85 0.913667
287 1000.41 0.455186
298 998.193 0.71293
308 994.173 0.610688
318 991.028 0.221718
EOD
$curve1 << EOD
257 994.843 1.3849
267 999.571 0.173155
277 1001.29 1.31055
287 999.73 0.517117
298 996.816 0.251199
308 994.302 0.85402
318 989.349 0.904563
EOD
$curve2 << EOD
257 996.839 0.0644796
267 1002.44 0.142349
277 1003.23 0.554159
287 1001.87 0.273995
298 999.307 0.0817319
308 995.314 0.0866717
318 991.904 0.105752
EOD
$curve3 << EOD
257 995.703 0.172142
267 1001.05 0.177781
277 1001.79 0.188848
287 1000.21 0.247494
298 997.397 0.131666
308 993.539 0.194018
318 990.401 0.155082
EOD
$curve4 << EOD
257 997.586 0.726296
267 1001.26 0.254875
277 1000.26 0.183802
287 998.261 0.131203
298 996.148 1.04129
308 990.891 0.586695
318 988.02 0.108427
EOD
set grid
set xlabel "temperature [K]"
set ylabel "density [kg/m³]"
set key bottom left
set arrow from 281.0975, 1002.0986 to 281.0975, 1001.0986 linecolor "#0072B2" linewidth 1.6
set arrow from 280.8802, 1001.3934 to 280.8802, 1000.3934 linecolor "#D55E00" linewidth 1.6
set arrow from 280.4803, 1003.5354 to 280.4803, 1002.5354 linecolor "#009E73" linewidth 1.6
set arrow from 279.5868, 1001.9035 to 279.5868, 1000.9035 linecolor "#CC79A7" linewidth 1.6
set arrow from 272.4687, 1001.0554 to 272.4687, 1000.0554 linecolor "#E69F00" linewidth 1.6
plot $curve0 using 1:2:3 with yerrorbars linecolor "#0072B2" pointtype 7 title "limit of short steps: maximum at 281.1 K", \
  -0.0081090019*(x-287.429)**2 + -0.10267731*(x-287.429) + 1000.773602 with lines linewidth 1.6 linecolor "#0072B2" notitle, \
  $curve1 using 1:2:3 with yerrorbars linecolor "#D55E00" pointtype 7 title "gier4-fd, 4 fs: maximum at 280.9 K", \
  -0.0083347393*(x-287.429)**2 + -0.10915825*(x-287.429) + 1000.035975 with lines linewidth 1.6 linecolor "#D55E00" notitle, \
  $curve2 using 1:2:3 with yerrorbars linecolor "#009E73" pointtype 7 title "hoa2, 4 fs: maximum at 280.5 K", \
  -0.0082331137*(x-287.429)**2 + -0.1144114*(x-287.429) + 1002.137936 with lines linewidth 1.6 linecolor "#009E73" notitle, \
  $curve3 using 1:2:3 with yerrorbars linecolor "#CC79A7" pointtype 7 title "velocity-verlet, 2 fs: maximum at 279.6 K", \
  -0.0078246503*(x-287.429)**2 + -0.12271851*(x-287.429) + 1000.422286 with lines linewidth 1.6 linecolor "#CC79A7" notitle, \
  $curve4 using 1:2:3 with yerrorbars linecolor "#E69F00" pointtype 7 title "velocity-verlet, 4 fs: maximum at 272.5 K", \
  -0.0062303591*(x-287.429)**2 + -0.18641074*(x-287.429) + 998.6610716 with lines linewidth 1.6 linecolor "#E69F00" notitle
