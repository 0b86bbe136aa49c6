# Restyle this and run it again: gnuplot draws accuracy.svg.
set encoding utf8
set minussign
set terminal svg size 960,340 dynamic font 'sans-serif,13' background "white"
set output "accuracy.svg"
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
0.22833548 1.8754278 0.66928243 -1.634169 1.7780575 -0.18218171 0.34157772
0.93454922 0.50410402 0.97609607 -1.2296554 1.5512675 -2.2577166 0.3334106
2.0817509 1.009326 1.8090727 -3.0520811 1.03636 -4.9709644 0.27042713
3.7511535 2.5226214 0.6576869 -5.5168477 1.5217344 -9.3005962 0.41436966
5.9550933 2.7497936 1.0587089 -5.1731379 0.9442089 -13.496706 0.22738759
EOD
$hoa2 << EOD
0.3402615 0.14665579 1.5091279 1.2989579 0.66429121 0.05922133 0.34058911
1.0920687 0.660111 0.96197808 -0.98024286 0.77353759 -1.7087799 0.22563094
EOD
$gier4 << EOD
0.0079312995 0 0 0 0 -0.2855028 0.37323577
EOD

set multiplot layout 1,3
set title "diffusion, difference  (%)"
plot $velocity_verlet using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:2:3 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
unset key
set title "τ_2 of the dipole, difference  (%)"
plot $velocity_verlet using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:4:5 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
set title "T of rotation less T of translation  (K)"
plot $velocity_verlet using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 7 linecolor "#0072B2" title "velocity-verlet", $hoa2 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 5 linecolor "#D55E00" title "hoa2", $gier4 using 1:6:7 with yerrorbars linewidth 1.4 pointsize 0.9 pointtype 9 linecolor "#009E73" title "gier4"
unset multiplot
