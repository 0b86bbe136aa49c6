# Restyle this and run it again: gnuplot draws nested.svg.
set encoding utf8
set minussign
set terminal svg size 630,860 dynamic enhanced font "Helvetica,13" background "white"
set output "nested.svg"
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"
set key top right textcolor "#404040" samplen 1.5 spacing 1 noenhanced font ",9"
set logscale y
set ylabel "R  (%)" offset 1
set yrange [0.01:30]
$c0r0k0u1 << EOD
1000 0.22402
666.667 0.5222
500 0.92876
400 1.4861
333.333 2.0759
EOD
$c0r0k1u1 << EOD
1000 0.08273
666.667 0.16551
500 0.31496
400 0.48996
333.333 0.67086
EOD
$c0r0k2u1 << EOD
375 0.63172
333.333 0.84842
300 1.0163
250 1.6836
EOD
$c0r0k3u1 << EOD
750 0.015342
600 0.040911
500 0.16861
EOD
$c0r0k4u1 << EOD
732.993 0.012564
549.745 0.067334
439.796 0.45536
EOD
$c0r0k5u1 << EOD
400.774 0.2968
356.243 0.50474
320.619 0.64712
267.182 1.9664
EOD
$c0r0k6u1 << EOD
437.423 0.38351
328.067 0.52286
262.454 0.94064
EOD
$c0r0k7u1 << EOD
360.34 0.47745
288.272 0.80374
EOD
$c0r0k8u1 << EOD
355.478 0.56092
304.695 0.92579
EOD
$c0r0k9u1 << EOD
593.07 0.39263
444.802 0.72933
EOD
$c0r1k0u1 << EOD
1 0.22402
1.5 0.5222
2 0.92876
2.5 1.4861
3 2.0759
EOD
$c0r1k1u1 << EOD
2 0.08273
3 0.16551
4 0.31496
5 0.48996
6 0.67086
EOD
$c0r1k2u1 << EOD
8 0.63172
9 0.84842
10 1.0163
12 1.6836
EOD
$c0r1k3u1 << EOD
4 0.015342
5 0.040911
6 0.16861
EOD
$c0r1k4u1 << EOD
6 0.012564
8 0.067334
10 0.45536
EOD
$c0r1k5u1 << EOD
8 0.2968
9 0.50474
10 0.64712
12 1.9664
EOD
$c0r1k6u1 << EOD
6 0.38351
8 0.52286
10 0.94064
EOD
$c0r1k7u1 << EOD
8 0.47745
10 0.80374
EOD
$c0r1k8u1 << EOD
12 0.56092
14 0.92579
EOD
$c0r1k9u1 << EOD
3 0.39263
4 0.72933
EOD
set multiplot
set lmargin at screen 0.11
set rmargin at screen 0.98
set tmargin at screen 0.93
set bmargin at screen 0.58
set xlabel "cost  (force evaluations per ps)" offset 0,0.4
set title "pme"
set logscale x
set xtics (100, 150, 200, 300, 400, 600, 1000)
set xrange [225:1100]
plot $c0r0k0u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#0072B2" title "velocity-verlet", $c0r0k1u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#D55E00" title "hoa2", $c0r0k2u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#CC79A7" title "bcss3", $c0r0k3u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#56B4E9" title "gier4-fd", $c0r0k4u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#E69F00" title "gier4-fd / gier4-fd x 1 within 0.49 to 0.7 nm", $c0r0k5u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#000000" title "hoa2 / gier4-fd x 1 within 0.49 to 0.7 nm", $c0r0k6u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#8C564B" title "hoa2 / hoa2 x 1 within 0.42 to 0.6 nm", $c0r0k7u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#7F7F7F" title "hoa2 / bcss3 x 1 within 0.42 to 0.6 nm", $c0r0k8u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#9467BD" title "bcss3 / hoa2 x 1 within 0.49 to 0.7 nm", $c0r0k9u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#BCBD22" title "velocity-verlet / hoa2 x 2 within 0.49 to 0.7 nm"
set lmargin at screen 0.11
set rmargin at screen 0.98
set tmargin at screen 0.43000000000000005
set bmargin at screen 0.07999999999999996
set xlabel "outer step  (fs)" offset 0,0.4
unset title
unset logscale x
set xtics autofreq
set xrange [0:*]
plot $c0r1k0u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#0072B2" title "", $c0r1k1u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#D55E00" title "", $c0r1k2u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#CC79A7" title "", $c0r1k3u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#56B4E9" title "", $c0r1k4u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#E69F00" title "", $c0r1k5u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#000000" title "", $c0r1k6u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#8C564B" title "", $c0r1k7u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#7F7F7F" title "", $c0r1k8u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#9467BD" title "", $c0r1k9u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#BCBD22" title ""
unset multiplot
