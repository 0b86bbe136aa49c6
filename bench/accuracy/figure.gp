# Restyle this and run it again: gnuplot draws ${image}.
set encoding utf8
set minussign
set terminal ${terminal} background "white"
set output "${image}"
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set grid linewidth 0.5 linecolor "#e4e4e4"
set title offset 0,-0.4 textcolor "#404040"
set key textcolor "#404040" samplen 1 spacing 1.1 noenhanced Left reverse top left
set logscale x
set format x "%g"
set xlabel "R  (%)"
set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1

${data}

set multiplot layout 1,3
set title "diffusion, difference  (%)"
plot ${diffusion}
unset key
set title "τ_2 of the dipole, difference  (%)"
plot ${relaxation}
set title "T of rotation less T of translation  (K)"
plot ${temperatures}
unset multiplot
