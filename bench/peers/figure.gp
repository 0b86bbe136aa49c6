# Restyle this and run it again: gnuplot draws ${image}.
set encoding utf8
set minussign
set terminal ${terminal} background "white"
set output "${image}"
set border 3 linewidth 1 linecolor "#404040"
set title offset 0,-0.6 textcolor "#404040"
set style histogram clustered gap ${gap}
set style fill solid 1 noborder
set boxwidth 0.9 relative
set datafile missing "?"
set xrange [-0.6:2.6]

${data}

set multiplot
# The key, in a strip of its own.
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen ${strip}
set tmargin at screen 0.99
set key inside center center horizontal Left reverse noenhanced samplen 0.8 textcolor "#404040"
unset border
unset tics
unset grid
set yrange [0:1]
plot ${key}

unset key
set border 3
set xtics nomirror scale 0 textcolor "#404040"
set ytics nomirror out scale 0.6 textcolor "#404040"
set grid ytics linewidth 0.5 linecolor "#e4e4e4"
set logscale y
set format y "10^{%T}"
set yrange [${low}:${high}]
set ylabel "seconds a nanosecond" offset 1 textcolor "#404040"
${plots}
unset multiplot
