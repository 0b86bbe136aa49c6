# Restyle this and run it again: gnuplot draws canonical.png.
image = './canonical.png'
format = 'png'
width = 1200
height = 760
curves = 10
array name[10]
name[1] = 'obabo'
name[2] = 'baoab'
name[3] = 'aboba'
name[4] = 'hoa2-ends'
name[5] = 'hoa2-middle'
name[6] = 'bcss3-ends'
name[7] = 'bcss3-middle'
name[8] = 'gier4-fd-ends'
name[9] = 'gier4-fd-middle'
name[10] = 'hmc-hoa2'
array colour[10]
colour[1] = '#0072B2'
colour[2] = '#0072B2'
colour[3] = '#56B4E9'
colour[4] = '#D55E00'
colour[5] = '#D55E00'
colour[6] = '#CC79A7'
colour[7] = '#CC79A7'
colour[8] = '#009E73'
colour[9] = '#009E73'
colour[10] = '#000000'
array filled[10]
filled[1] = 7
filled[2] = 9
filled[3] = 5
filled[4] = 7
filled[5] = 9
filled[6] = 7
filled[7] = 9
filled[8] = 7
filled[9] = 11
filled[10] = 13
array open[10]
open[1] = 6
open[2] = 8
open[3] = 4
open[4] = 6
open[5] = 8
open[6] = 6
open[7] = 8
open[8] = 6
open[9] = 10
open[10] = 12
caption = 'Shaded: the bounds. Hybrid Monte Carlo (hmc) is exact, and the reference. 12 runs of 8 ps per point, standard errors.'
panels = 6
bound1 = 0.05000000000
low1 = -0.2004983826
high1 = 0.4400000000
bound2 = 1.000000000
low2 = -4.470501278
high2 = 8.800000000
bound3 = 1.000000000
low3 = -8.279240828
high3 = 8.800000000
bound4 = 0.03000000000
low4 = -0.1266686471
high4 = 0.04739053798
bound5 = 1.000000000
low5 = -8.800000000
high5 = 8.800000000
bound6 = 0.000000000
low6 = 52.54786293
high6 = 1078.424035
array panel[6]
panel[1] = 'bias of <U> per molecule  (kJ/mol)'
panel[2] = 'bias of T_conf, translation  (K)'
panel[3] = 'bias of T_conf, rotation  (K)'
panel[4] = 'bias of first peak of g(r)'
panel[5] = 'bias of T_kin, rotation  (K)'
panel[6] = 'force evaluations per independent U'
$points << EOD
# obabo
166.66667 0.91783251 0.048114495 17.396065 0.86626968 42.684837 0.63621392 -0.10402333 0.011129987 -2.5697941 0.40372801 85.792925 10.724549
250 0.40067807 0.053303284 7.8036586 0.64357169 17.397649 0.54909932 -0.057994231 0.014179245 -1.4534236 0.32722347 136.94711 20.628914
500 0.076218402 0.043707698 1.8506508 0.73021751 3.7406699 0.42356396 -0.019485183 0.012154896 -0.36726803 0.34341771 293.81021 46.164056


# baoab
166.66667 -0.12657823 0.050955582 0.9847254 0.59358227 6.025452 0.62909503 0.015941022 0.016512477 -31.307044 0.42424872 113.12087 19.255279
250 -0.032811052 0.045831938 0.747845 0.71360212 1.925025 0.53547864 0.0073692898 0.013795327 -13.542746 0.41376094 109.37505 13.639628
500 0.048170858 0.048930155 0.36621282 0.73334484 1.2410735 0.3484482 -0.016315761 0.014658305 -2.9492903 0.44389017 219.81268 43.006523


# aboba
166.66667 0.40752931 0.049447523 -0.87292377 0.71425244 -6.9123702 0.61421235 -0.085514679 0.014387379 32.072389 0.51073047 95.245546 8.0406855
250 0.22102272 0.053806609 -0.24564869 0.7006172 -3.2025983 0.51710557 -0.041105272 0.015779831 13.050242 0.3861841 112.37476 11.177029
500 0.029946532 0.061407174 -0.93134475 0.62073721 -1.4384478 0.52246033 -0.022724138 0.014307415 2.4130364 0.50471479 405.31796 58.350156


# hoa2-ends
250 0.02120058 0.056532378 -0.6090935 0.72923474 -2.0550265 0.55269718 -0.013313175 0.013295343 -0.57356732 0.54771645 151.50235 26.214332
333.33333 0.075538173 0.051596762 0.41709128 0.59950368 -0.15771333 0.55763411 -0.021456413 0.014194163 0.14011798 0.47146035 210.79637 37.370201
500 0.047122604 0.041983979 0.63393883 0.84031412 0.65542672 0.59941823 -0.01525269 0.01315393 0.38967567 0.52245705 304.86591 25.468611


# hoa2-middle
250 0.49005069 0.050044323 6.4687572 0.94621626 13.647064 0.68992141 -0.0759021 0.013657554 12.682483 0.534609 146.86517 18.783869
333.33333 0.21820783 0.049457777 1.7357398 0.63540259 7.1113919 0.3519378 -0.021168356 0.013640135 5.2220887 0.3806767 187.10869 23.030682
500 0.15538819 0.04041833 0.57239051 0.94887832 4.1555818 0.48304845 0.0031435093 0.011079559 3.575234 0.48619184 398.75136 51.477666


# bcss3-ends
375 0.070573749 0.055180459 1.3529665 0.93708922 1.1460983 0.43610455 -0.010030274 0.017484784 -0.30029109 0.40187183 178.53446 22.778176
500 0.060515768 0.045420576 0.3143341 0.35917011 1.3695011 0.63590269 -0.02190073 0.013780338 0.5077944 0.57455821 370.99088 55.349983
750 0.016557414 0.047694636 1.1575455 0.62485094 0.64587885 0.7292834 -0.02382178 0.013110464 0.4149749 0.34960803 520.42344 50.48545


# bcss3-middle
375 -0.1362441 0.04602716 -3.3412549 0.72283721 -4.3269139 0.69128657 0.025208326 0.017873981 -4.6418356 0.36184152 269.53627 20.021417
500 -0.10210601 0.050325797 -0.80092322 0.53913718 -2.7946232 0.6698276 0.0075849246 0.014054737 -3.3514054 0.52237847 233.46223 28.799146
750 -0.037765966 0.040946925 -1.0667796 0.76173167 -1.1924421 0.47562248 0.0023857698 0.012246618 -1.1727296 0.45430049 487.88936 70.687419


# gier4-fd-ends
375 0.012639456 0.040987861 0.72190731 0.6762422 -1.0956794 0.45911308 -0.00088555649 0.012507351 -0.35988018 0.37705186 193.03051 26.087286
500 -0.061202519 0.061183591 0.071921144 0.85708862 0.22651191 0.64713908 0.001606291 0.014761802 0.54070893 0.49930882 280.17403 38.102541
750 -0.007987328 0.041438037 0.17249862 0.77516654 -0.60039279 0.57361107 0.0068653387 0.011238453 -0.024002835 0.52772737 474.17112 64.580431


# gier4-fd-middle
500 0.55346382 0.051366104 8.6171572 0.7801987 19.006786 0.63658484 -0.057268933 0.013511846 17.378131 0.5817473 370.72121 56.494194
666.66667 0.36173088 0.049960184 5.1950374 1.1927852 11.406692 0.67030114 -0.057347668 0.011970932 10.019084 0.54507693 308.64643 41.846966
1000 0.10521929 0.064588864 3.1139569 0.76436349 5.2472648 0.69159967 -0.0086143177 0.013632716 4.2554262 0.67012978 652.50993 117.79295


# hmc-hoa2
250 -0.052274184 0.061689876 -1.2043102 1.1126488 -0.65562783 0.71737583 0.013499344 0.021719439 -0.3788626 0.32284069 178.15952 18.794014
333.33333 0.0023986556 0.049190154 1.1414256 0.78755953 1.4139454 0.57543852 0.0058663399 0.017175302 -0.3209786 0.48887871 202.6902 44.893976
500 0.049875528 0.05282414 0.36431857 0.85227683 0.3579373 0.64121588 -0.019365684 0.018258336 0.071053734 0.22672397 365.09726 62.428225


EOD
cost_low = 133.3333333
cost_high = 1250.000000

# The style of all figures. Above: image, format ("svg" or "png"), width and height [pixels].
set encoding utf8
set minussign
ink = "#404040"
small = format eq "png" ? ",9" : ",12"  # font, in points of a bitmap or pixels
if (format eq "png") {
  # Twice the pixels, for print and high-density screens.
  set terminal pngcairo size 2*width,2*height fontscale 2 linewidth 2 pointscale 2 enhanced font "Helvetica,11" background "white"
} else {
  set terminal svg size width,height dynamic enhanced font "Helvetica,15" background "white"
}
set output image
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

# Bias of canonical averages against cost, a panel for each quantity, and the cost of an independent sample. Above: for each
# scheme its name, colour, filled marker; caption; panels, panel (titles), bound1.., low1.., high1.. (of the vertical axes;
# bound 0: none, a logarithmic axis); cost_low, cost_high; $points, a block per scheme: force evaluations per ps, then value and
# standard error for each panel.
set multiplot
across = 3
down = ceil(real(panels)/across)
left = 0.0; right = 0.99; bottom = 0.11; top = 0.93
# The key, across all panels.
set lmargin at screen 0.03
set rmargin at screen 0.99
set tmargin at screen 0.995
set bmargin at screen 0.925
set key inside center center horizontal maxcols 5
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
plot NaN notitle, \
  for [k=1:curves] keyentry with linespoints linewidth 1.6 pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title name[k]
unset key
set border 3
set grid
set tics scale 0.6
set xtics font small
set ytics font small
set label 1 caption at screen 0.015, screen 0.025 left noenhanced textcolor rgb ink font small
set label 2 "cost:  force evaluations per ps" at screen 0.5, screen 0.07 center textcolor rgb ink
set logscale x
set xtics (1)
do for [d=-3:5] {
  do for [m in "1 2 5"] {
    x = m*10.0**d
    set xtics add (sprintf("%g", x) x)
  }
}
set xrange [cost_low:cost_high]
do for [j=1:panels] {
  place = (j - 1)%across
  row = (j - 1)/across
  set lmargin at screen left + (right - left)*(place + 0.17)/across
  set rmargin at screen left + (right - left)*(place + 0.99)/across
  set tmargin at screen top - (top - bottom)*(row + 0.12)/down
  set bmargin at screen top - (top - bottom)*(row + 0.93)/down
  set label 3 panel[j] at graph 0, graph 1.06 left noenhanced textcolor rgb ink
  bound = value(sprintf("bound%d", j))
  if (bound > 0) {
    unset logscale y
    set ytics auto
    set format y "%g"
    set object 1 rectangle from graph 0, first -bound to graph 1, first bound fillstyle solid noborder fillcolor rgb "#eeeeee" behind
    set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead linewidth 1 linecolor rgb ink back
  } else {
    set logscale y
    set ytics (1)
    do for [d=-1:7] { do for [m in "1 2 5"] { y = m*10.0**d; set ytics add (sprintf("%g", y) y) } }
    unset object 1
    unset arrow 1
  }
  set yrange [value(sprintf("low%d", j)):value(sprintf("high%d", j))]
  plot for [k=1:curves] $points index k-1 using 1:(column(2*j)) with lines linewidth 1.6 linecolor rgb colour[k], \
    for [k=1:curves] $points index k-1 using 1:(column(2*j)):(column(2*j+1)) with yerrorbars pointtype filled[k] pointsize 0.8 linewidth 1.2 linecolor rgb colour[k], \
    NaN notitle
  unset label 1
  unset label 2
}
unset multiplot
