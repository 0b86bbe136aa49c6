# Conserved (or total) and potential energy of a run against time, in two panels. Above: data (a CSV file), caption; energy, the name of
# the first; ratio, R as a text, or empty.
set datafile separator ","
set datafile columnheaders
stats data using (column("time [ps]")) name "T" nooutput
energy_column = energy . " [kJ/mol]"
stats data using (column(energy_column)) name "E" nooutput
stats data using (column("potential [kJ/mol]")) name "V" nooutput

# Time in the unit that gives numbers between 1 and 1000.
unit = T_max < 1 ? 1000.0 : T_max < 2000 ? 1.0 : 0.001
unit_name = T_max < 1 ? "fs" : T_max < 2000 ? "ps" : "ns"
# Ends of an axis: of all values, and some room about a single one.
low(a, b) = a < b ? a - 0.04*(b - a) : a - 1
high(a, b) = a < b ? b + 0.04*(b - a) : b + 1

set multiplot
set lmargin at screen 0.18
set rmargin at screen 0.96
unset key

set tmargin at screen 0.86
set bmargin at screen 0.56
set label 1 caption at screen 0.18, screen 0.955 left noenhanced textcolor rgb ink
ratio_text = strlen(ratio) > 0 ? "R = rms of E / rms of V = " . ratio . ",  " : ""
set label 2 ratio_text . "E: " . energy . " energy" at screen 0.18, screen 0.905 left textcolor rgb ink
set format x ""
set label 3 "E − ⟨E⟩  (kJ/mol)" at screen 0.03, screen 0.71 center rotate textcolor "#D55E00"
set xrange [unit*T_min:unit*(T_min < T_max ? T_max : T_min + 1)]
set yrange [low(E_min, E_max) - E_mean:high(E_min, E_max) - E_mean]
set ytics tic(E_max - E_min)
set xzeroaxis linewidth 1 linecolor rgb ink
plot data using (unit*column("time [ps]")):(column(energy_column) - E_mean) with lines linewidth 1.4 linecolor "#D55E00"

set tmargin at screen 0.51
set bmargin at screen 0.19
unset label 1
unset label 2
set format x "%g"
set xlabel sprintf("time  (%s)", unit_name) offset 0,0.3
set label 3 "V  (kJ/mol)" at screen 0.03, screen 0.35 center rotate textcolor "#0072B2"
set yrange [low(V_min, V_max):high(V_min, V_max)]
set ytics tic(V_max - V_min)
unset xzeroaxis
plot data using (unit*column("time [ps]")):(column("potential [kJ/mol]")) with lines linewidth 1.4 linecolor "#0072B2"
unset multiplot
