# Total and potential energy of a run against time, in two panels. Above: data (a CSV file), caption.
set datafile separator ","
set datafile columnheaders
stats data using (column("time [ps]")) name "T" nooutput
stats data using (column("total [kJ/mol]")) name "E" nooutput
stats data using (column("potential [kJ/mol]")) name "V" nooutput

# Time in the unit that gives numbers between 1 and 1000.
unit = T_max < 1 ? 1000.0 : T_max < 2000 ? 1.0 : 0.001
unit_name = T_max < 1 ? "fs" : T_max < 2000 ? "ps" : "ns"
# The distance between tics that puts about five of them into a range.
tic(range) = range <= 0 ? 1 : nice(range, 10**floor(log10(range)))
nice(range, p) = range < 1.5*p ? 0.2*p : range < 3*p ? 0.5*p : range < 6*p ? p : 2*p

set multiplot
set lmargin at screen 0.18
set rmargin at screen 0.96
unset key

set tmargin at screen 0.86
set bmargin at screen 0.56
set label 1 caption at screen 0.18, screen 0.955 left noenhanced textcolor rgb ink
if (V_stddev > 0) {
  set label 2 sprintf("R = rms of E / rms of V = %.3g %%", 100*E_stddev/V_stddev) at screen 0.18, screen 0.905 left textcolor rgb ink
}
set format x ""
set label 3 "E − ⟨E⟩  (kJ/mol)" at screen 0.03, screen 0.71 center rotate textcolor "#D55E00"
set autoscale xfix
set ytics tic(E_max - E_min)
set xzeroaxis linewidth 1 linecolor rgb ink
plot data using (unit*column("time [ps]")):(column("total [kJ/mol]") - E_mean) with lines linewidth 1.4 linecolor "#D55E00"

set tmargin at screen 0.51
set bmargin at screen 0.19
unset label 1
unset label 2
set format x "%g"
set xlabel sprintf("time  (%s)", unit_name) offset 0,0.3
set label 3 "V  (kJ/mol)" at screen 0.03, screen 0.35 center rotate textcolor "#0072B2"
set ytics tic(V_max - V_min)
unset xzeroaxis
plot data using (unit*column("time [ps]")):(column("potential [kJ/mol]")) with lines linewidth 1.4 linecolor "#0072B2"
unset multiplot
