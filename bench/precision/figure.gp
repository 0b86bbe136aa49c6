${style}
${data}

set multiplot
${key}
set title offset 0,-0.4 textcolor "#404040"
set bmargin at screen 0.13
set tmargin at screen 0.80
set logscale xy
set format y "10^{%T}"

set lmargin at screen 0.095
set rmargin at screen 0.475
set title "runs of ${short} ps"
set xlabel "time step  (fs)" offset 0,0.3
set ylabel "R  (%)"
set xtics (0.5, 1, 2, 3, 4, 5)
set xrange [0.42:6]
set yrange [${low}:${high}]
plot ${steps}

set lmargin at screen 0.595
set rmargin at screen 0.985
set title "one run of ${long} ps: ${cases}"
set xlabel "length of a window  (ps)" offset 0,0.3
set ylabel "rms of E about its mean  (kJ/mol)"
set xtics (0.25, 0.5, 1, 2, 4, 8, 16, 32)
set xrange [0.2:${widest}]
set yrange [${growth_low}:${growth_high}]
plot ${growth}
unset multiplot
