# Restyle this and run it again: gnuplot draws equal-accuracy.svg.
image = "equal-accuracy.svg"
format = "svg"
width = 760
height = 480
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

set logscale xy
set xlabel "seconds per nanosecond of 4,096 TIP4P waters, one process"
set ylabel "R [%]"
set xrange [500:200000]
set yrange [0.006:10]
set key at graph 0.98, graph 0.03 right bottom Left reverse samplen 2 font small
$curve0 << EOD
91554.5 0.224847
61036.3 0.459823
45777.3 0.869941
30518.2 1.94474
22888.6 3.68614
18310.9 6.0631
EOD
$curve1 << EOD
5636.35 0.220135
3757.57 0.508678
2818.18 0.833311
1878.78 1.93335
1409.09 3.75437
1127.27 5.81186
EOD
$curve2 << EOD
3002.52 0.245344
2001.68 0.508723
1501.26 0.940592
1000.84 2.26828
750.63 4.0631
600.504 5.84732
EOD
$curve3 << EOD
3757.57 0.178454
2818.18 0.330171
2254.54 0.545232
1878.78 0.71388
1409.09 2.41194
1127.27 24.341
EOD
$curve4 << EOD
2001.68 0.18254
1501.26 0.341692
1201.01 0.483272
1000.84 0.744695
750.63 2.73628
600.504 24.1433
EOD
$curve5 << EOD
4227.26 0.132875
3381.81 0.215086
2818.18 0.339793
2254.54 0.541576
1878.78 0.730381
1409.09 1.22877
1252.52 1.8411
EOD
$curve6 << EOD
2251.89 0.180022
1801.51 0.263754
1501.26 0.380184
1201.01 0.595308
1000.84 0.876343
750.63 1.60733
667.227 2.4605
EOD
$curve7 << EOD
4227.26 0.0586202
3381.81 0.179005
2818.18 0.334042
2254.54 0.660936
1878.78 4.43253
1409.09 65.6238
EOD
$curve8 << EOD
2251.89 0.0171056
1801.51 0.0437297
1501.26 0.129464
1201.01 0.88037
1000.84 2.24047
750.63 46.6404
EOD
plot $curve0 using 1:2 with linespoints linewidth 1.6 linecolor "#000000" pointtype 5 title "rigid/nve/small", \
  $curve1 using 1:2 with linespoints linewidth 1.6 linecolor "#0072B2" pointtype 6 title "velocity-verlet, same law", \
  $curve2 using 1:2 with linespoints linewidth 1.6 linecolor "#0072B2" pointtype 7 title "velocity-verlet, by molecules", \
  $curve3 using 1:2 with linespoints linewidth 1.6 linecolor "#D55E00" pointtype 4 title "hoa2, same law", \
  $curve4 using 1:2 with linespoints linewidth 1.6 linecolor "#D55E00" pointtype 5 title "hoa2, by molecules", \
  $curve5 using 1:2 with linespoints linewidth 1.6 linecolor "#CC79A7" pointtype 12 title "bcss3, same law", \
  $curve6 using 1:2 with linespoints linewidth 1.6 linecolor "#CC79A7" pointtype 13 title "bcss3, by molecules", \
  $curve7 using 1:2 with linespoints linewidth 1.6 linecolor "#009E73" pointtype 8 title "gier4-fd, same law", \
  $curve8 using 1:2 with linespoints linewidth 1.6 linecolor "#009E73" pointtype 9 title "gier4-fd, by molecules"
