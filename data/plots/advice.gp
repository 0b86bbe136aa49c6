# R against computing time, with the models that the adviser fitted. Above: for each curve its name, colour and filled marker;
# some_bound, bound; some_answer; $points and $models, a block per curve: seconds per ps, R [%], its standard error (of points);
# $answer: the same of the confirmed answer.
set key outside top center horizontal
set xlabel "computing time for a simulated ps  (s)"
set ylabel "error:  R = rms of E / rms of V  (%)"
set logscale xy
set format y "%g"
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
plot for [k=1:curves] $points index k-1 using 1:2:3 with yerrorbars pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k], \
  for [k=1:curves] $models index k-1 using 1:2 with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:some_bound] bound with lines linewidth 1.4 dashtype 2 linecolor rgb ink title "required", \
  for [k=1:some_answer] $answer using 1:2:3 with yerrorbars pointtype 6 pointsize 2 linewidth 2 linecolor "#000000" title "confirmed", \
  NaN notitle
