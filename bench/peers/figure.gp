${style}
set title offset 0,-0.6
set label 1000 "${caveat}" at screen 0.01, screen 0.02 left noenhanced textcolor rgb ink font small
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
set key inside center center horizontal Left reverse noenhanced samplen 0.8 textcolor rgb ink
unset border
unset tics
unset grid
set yrange [0:1]
plot ${key}

unset key
set border 3
set xtics nomirror scale 0 textcolor rgb ink
set ytics nomirror out scale 0.6 textcolor rgb ink
set grid ytics linewidth 0.5 linecolor "#e4e4e4"
set logscale y
set format y "10^{%T}"
set yrange [${low}:${high}]
set ylabel "seconds per nanosecond" textcolor rgb ink
${plots}
unset multiplot
