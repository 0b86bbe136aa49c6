# Restyle this and run it again: gnuplot draws ${image}.
set encoding utf8
set minussign
set terminal ${terminal}
set output "${image}"
set border 3 linewidth 1 linecolor "#404040"
set tics nomirror out scale 0.6 textcolor "#404040"
set xtics scale 0
set ytics
set grid ytics linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced samplen 0.8 textcolor "#404040"
set title textcolor "#404040"
set style histogram clustered gap ${gap}
set style fill solid 1 noborder
set boxwidth 0.9 relative
set datafile missing "?"
set logscale y
set format y "10^{%T}"
set yrange [${low}:${high}]
set ylabel "seconds a nanosecond" offset 1 textcolor "#404040"
set xrange [-0.6:2.6]

${data}

set multiplot layout ${down},${across} margins ${left}, 0.98, ${base}, ${top} spacing ${between}, ${above}
${plots}
unset multiplot
