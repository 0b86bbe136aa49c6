# R against computing time, with the models that the adviser fitted. Above: for each curve its name, colour and filled marker;
# some_bound, bound; some_answer; $points and $models, a block per curve: seconds per ps, R [%], its standard error (of points);
# $answer: the same of the confirmed answer.
set key outside top center horizontal
set xlabel "computing time for a simulated ps  (s)"
set ylabel "error:  R = rms of E / rms of V  (%)"
stats $points using 1:2 name "P" nooutput
low = some_bound && bound < P_min_y ? bound : P_min_y
high = some_bound && bound > P_max_y ? bound : P_max_y
set logscale xy
set format xy "%g"
set xtics (1)
set for [d=-7:5] for [m in "1 2 5"] xtics add (sprintf("%g", m*10.0**d) m*10.0**d)
set xrange [0.8*P_min_x:1.25*P_max_x]
set yrange [0.6*low:1.7*high]
plot for [k=1:curves] $points index k-1 using 1:2:3 with yerrorbars pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k], \
  for [k=1:curves] $models index k-1 using 1:2 with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:some_bound] bound with lines linewidth 1.4 dashtype 2 linecolor rgb ink title "required", \
  for [k=1:some_answer] $answer using 1:2:3 with yerrorbars pointtype 6 pointsize 2 linewidth 2 linecolor "#000000" title "confirmed", \
  NaN notitle
