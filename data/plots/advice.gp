# R against computing time, with the models that the adviser fitted. Above: data (its CSV file); for each scheme its name, colour, filled
# marker, first and last row from 0, step_of [fs] and the seconds_of a simulated ps with that step; of its model R_of, R at that step [%] (0:
# no model), and the exponents of the step there and for short steps; bound [%] (0: none); answers (0 or 1), and of the confirmed answer
# its row and the number of its scheme, best.
set datafile separator ","
set datafile columnheaders
set key outside top center horizontal
set xlabel "computing time for a simulated ps  (s)"
set ylabel "error:  R = rms of E / rms of V  (%)"
spent(k) = seconds_of[k]*step_of[k]/column("step [fs]")
R(dummy) = column("usable [1]") == 1 ? 100*column("R [1]") : NaN
error(dummy) = 100*column("R_error [1]")
# R = a hᵖ exp(c h²), for steps near the one of the model.
model(k, x) = x < 0.8*seconds_of[k] || x > 1.43*seconds_of[k] ? NaN : fitted(k, seconds_of[k]/x)
fitted(k, h) = R_of[k]*h**short_exponent_of[k]*exp(0.5*(exponent_of[k] - short_exponent_of[k])*(h**2 - 1))
k = 1
left = 1e300; right = 0; low = bound > 0 ? bound : 1e300; high = bound
do for [k=1:curves] {
  stats data every ::first[k]::last[k] using (R(0)) name "P" nooutput
  low = P_min < low ? P_min : low
  high = P_max > high ? P_max : high
  stats data every ::first[k]::last[k] using (R(0) == R(0) ? spent(k) : NaN) name "P" nooutput
  left = P_min < left ? P_min : left
  right = P_max > right ? P_max : right
}
if (right == 0) { left = 1; right = 1 }
if (high == 0) { low = 1; high = 1 }
set logscale xy
set format xy "%g"
set xtics (1)
set for [d=-7:5] for [m in "1 2 5"] xtics add (sprintf("%g", m*10.0**d) m*10.0**d)
set xrange [0.8*left:1.25*right]
set yrange [0.6*low:1.7*high]
set samples 2000
plot for [k=1:curves] data every ::first[k]::last[k] using (spent(k)):(R(0)):(error(0)) with yerrorbars pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k], \
  for [k=1:curves] R_of[k] > 0 ? model(k, x) : NaN with lines linewidth 1.6 linecolor rgb colour[k] notitle, \
  for [k=1:bound > 0] bound with lines linewidth 1.4 dashtype 2 linecolor rgb ink title "required", \
  for [k=1:answers] data every ::answer::answer using (spent(best)):(R(0)):(error(0)) with yerrorbars pointtype 6 pointsize 2 linewidth 2 linecolor "#000000" title "confirmed", \
  NaN notitle
