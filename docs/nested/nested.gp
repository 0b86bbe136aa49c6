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
set yrange [0.02:20]
$c0r0k0u1 << EOD
500 0.30191
400 0.49154
EOD
$c0r0k1u1 << EOD
375 0.63199
300 1.1193
EOD
$c0r0k2u1 << EOD
600 0.039654
500 0.13251
EOD
$c0r0k3u1 << EOD
550.536 0.061901
440.429 0.36669
EOD
$c0r0k4u1 << EOD
538.646 0.10388
430.917 0.46527
EOD
$c0r0k5u1 << EOD
433.161 0.3263
324.87 0.48287
259.896 1.02
EOD
$c0r0k6u1 << EOD
337.155 0.5146
269.724 1.0178
224.77 1.9648
EOD
$c0r0k7u1 << EOD
366.683 1.9335
275.012 3.4366
220.01 5.7892
183.342 16.039
157.15 99.721
137.506 140.94
EOD
$c0r0k7u0 << EOD
137.506 140.94
EOD
$c0r1k0u1 << EOD
4 0.30191
5 0.49154
EOD
$c0r1k1u1 << EOD
8 0.63199
10 1.1193
EOD
$c0r1k2u1 << EOD
5 0.039654
6 0.13251
EOD
$c0r1k3u1 << EOD
8 0.061901
10 0.36669
EOD
$c0r1k4u1 << EOD
8 0.10388
10 0.46527
EOD
$c0r1k5u1 << EOD
6 0.3263
8 0.48287
10 1.02
EOD
$c0r1k6u1 << EOD
8 0.5146
10 1.0178
12 1.9648
EOD
$c0r1k7u1 << EOD
6 1.9335
8 3.4366
10 5.7892
12 16.039
14 99.721
16 140.94
EOD
$c0r1k7u0 << EOD
16 140.94
EOD
set multiplot
set lmargin at screen 0.08
set rmargin at screen 0.98
set tmargin at screen 0.93
set bmargin at screen 0.58
set xlabel "cost  (force evaluations per ps)" offset 0,0.4
set title "pme"
set logscale x
set xtics (100, 150, 200, 300, 400, 600, 1000)
plot $c0r0k0u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#D55E00" title "hoa2", $c0r0k1u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#CC79A7" title "bcss3", $c0r0k2u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#56B4E9" title "gier4-fd", $c0r0k3u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#E69F00" title "gier4-fd / gier4-fd x 1 within 0.49 to 0.7 nm", $c0r0k4u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#000000" title "gier4-fd / hoa2 x 2 within 0.42 to 0.6 nm", $c0r0k5u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#8C564B" title "hoa2 / hoa2 x 1 within 0.42 to 0.6 nm", $c0r0k6u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#7F7F7F" title "hoa2 / bcss3 x 1 within 0.35 to 0.5 nm", $c0r0k7u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#9467BD" title "velocity-verlet / hoa2 x 4 within 0.42 to 0.6 nm", $c0r0k7u0 using 1:2 with points pointtype 2 pointsize 1.4 linewidth 1.6 linecolor "#9467BD" notitle
set lmargin at screen 0.08
set rmargin at screen 0.98
set tmargin at screen 0.43000000000000005
set bmargin at screen 0.07999999999999996
set xlabel "outer step  (fs)" offset 0,0.4
unset title
unset logscale x
set xtics autofreq
plot $c0r1k0u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#D55E00" title "", $c0r1k1u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#CC79A7" title "", $c0r1k2u1 using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.6 linecolor "#56B4E9" title "", $c0r1k3u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#E69F00" title "", $c0r1k4u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#000000" title "", $c0r1k5u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#8C564B" title "", $c0r1k6u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#7F7F7F" title "", $c0r1k7u1 using 1:2 with linespoints pointtype 5 pointsize 0.6 linewidth 1.6 linecolor "#9467BD" title "", $c0r1k7u0 using 1:2 with points pointtype 2 pointsize 1.4 linewidth 1.6 linecolor "#9467BD" notitle
unset multiplot
