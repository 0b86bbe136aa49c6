# Restyle this and run it again: gnuplot draws ${image}.
set encoding utf8
set minussign
set terminal ${terminal} background "white"
set output "${image}"
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"
set title offset 0,-0.4 textcolor "#404040"
set key textcolor "#404040" samplen 2 spacing 1.1 noenhanced Left reverse

${data}

set multiplot
set bmargin at screen 0.145
set tmargin at screen 0.905

set lmargin at screen 0.085
set rmargin at screen 0.475
set logscale xy
set title "runs of ${short} ps: mixed filled, double open"
set xlabel "time step  (fs)" offset 0,0.3
set ylabel "R  (%)" offset 0.8
set xtics (0.5, 1, 2, 3, 4, 5)
set format y "10^{%T}"
set xrange [0.42:6]
set yrange [${low}:${high}]
set key bottom right
plot ${steps}

set lmargin at screen 0.585
set rmargin at screen 0.985
set title "one run of ${long} ps, in windows"
set xlabel "length of a window  (ps)" offset 0,0.3
set ylabel "rms of E about its mean  (kJ/mol)" offset 1.2
set xtics (0.25, 0.5, 1, 2, 4, 8, 16, 32)
set xrange [0.2:${widest}]
set yrange [${growth_low}:${growth_high}]
set key top center maxrows 3 samplen 1.6 width -1
plot ${growth}
unset multiplot
