${style}
set title offset 0,-0.4
set label 1 "${caveat}" at screen 0.015, screen 0.045 left noenhanced textcolor rgb ink font small

${data}

set multiplot
${key}
set bmargin at screen 0.25
set tmargin at screen 0.78
set logscale x
set format x "%g"
set xlabel "R  (%)"
set xzeroaxis linewidth 1 linecolor rgb ink
set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1
set xrange [*:*]
set yrange [*:*]
set title "diffusion, difference  (%)"
set lmargin at screen 0.06
set rmargin at screen 0.325
plot ${diffusion}
unset label 1
set title "relaxation of the dipole, difference  (%)"
set lmargin at screen 0.39
set rmargin at screen 0.655
plot ${relaxation}
set title "T of rotation less T of translation  (K)"
set lmargin at screen 0.72
set rmargin at screen 0.985
plot ${temperatures}
unset multiplot
