# Restyle this and run it again: gnuplot draws accuracy.png.
set encoding utf8
set minussign
set terminal pngcairo size 960,340 background "white"
set output "accuracy.png"
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"
set title offset 0,-0.4 textcolor "#404040"
set key textcolor "#404040" samplen 1 spacing 1.1 noenhanced Left reverse top left
set logscale x
set format x "%g"
set xlabel "R  (%)"
set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1

$velocity_verlet << EOD
0.22833548 3.0265889 0.087309988 1.9692713 0.077324204 -0.18218171 2.1004352
0.93454922 2.9848743 0.096693029 1.9771405 0.084027874 -2.2577166 2.1349843
2.0817509 3.0001083 0.082513688 1.9421758 0.064350535 -4.9709644 2.2465499
3.7511535 3.0466837 0.093850167 1.8968085 0.068875973 -9.3005962 2.3413743
5.9550933 3.0538006 0.10422414 1.9030073 0.068972273 -13.496706 2.1236195
EOD
$hoa2 << EOD
0.3402615 2.9741893 0.10752917 2.0277927 0.083819009 0.05922133 2.0936031
1.0920687 2.9895619 0.082381124 1.9820239 0.07688206 -1.7087799 2.1766953
EOD
$gier4 << EOD
0.0079312995 2.9698274 0.08938378 2.0014525 0.077460341 -0.2855028 2.285421
EOD

set multiplot layout 1,3
set title "diffusion in the box  (10^{-9} m²/s)"
plot $velocity_verlet using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
unset key
set title "τ_2 of the dipole  (ps)"
plot $velocity_verlet using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
set title "T of rotation less T of translation  (K)"
plot $velocity_verlet using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
unset multiplot
