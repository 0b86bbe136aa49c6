${style}
set label 1000 "${caveat}" at screen 0.01, screen 0.02 left noenhanced textcolor rgb ink font small

${data}

set multiplot
${key}
unset label 1000
set title offset 0,-0.4
set logscale xy
set xlabel "required R  (%)" offset 0,0.3
set ylabel "seconds per nanosecond" textcolor rgb ink
set xtics (${targets})
set format y "10^{%T}"
set xrange [${loosest}:${strictest}]
set yrange [${low}:${high}]
${plots}
unset multiplot
