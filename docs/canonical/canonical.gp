# To change the figure, edit this script and run gnuplot on it: it draws canonical.png.
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
colour[2] = '#6A3D9A'
colour[3] = '#56B4E9'
colour[4] = '#D55E00'
colour[5] = '#E69F00'
colour[6] = '#CC79A7'
colour[7] = '#882255'
colour[8] = '#009E73'
colour[9] = '#999933'
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
caption = 'Shaded: the strict and the loose bounds. Points with equal cost are drawn side by side. Hybrid Monte Carlo (hmc) is exact and serves as the reference. 48 runs of 8 ps per point, standard errors.'
panels = 6
strict1 = 0.05000000000
loose1 = 0.2000000000
low1 = -0.2200000000
high1 = 0.5500000000
strict2 = 1.000000000
loose2 = 3.000000000
low2 = -3.300000000
high2 = 8.250000000
strict3 = 1.000000000
loose3 = 3.000000000
low3 = -8.250000000
high3 = 8.250000000
strict4 = 0.03000000000
loose4 = 0.06000000000
low4 = -0.1265758789
high4 = 0.06600000000
strict5 = 1.000000000
loose5 = 3.000000000
low5 = -8.250000000
high5 = 8.250000000
strict6 = 0.000000000
loose6 = 0.000000000
low6 = 56.76633854
high6 = 837.6126807
array panel[6]
panel[1] = 'bias of <U> per molecule  (kJ/mol)'
panel[2] = 'bias of T_conf, translation  (K)'
panel[3] = 'bias of T_conf, rotation  (K)'
panel[4] = 'bias of first peak of g(r)'
panel[5] = 'bias of T_kin, rotation  (K)'
panel[6] = 'force evaluations per independent U'
$points << EOD
# obabo
166.66667 0.94406209 0.023695849 17.583949 0.41115187 42.693551 0.31236322 -0.1090772 0.0059917793 -2.5992651 0.22585354 86.575648 5.4808786
250 0.3750406 0.024551683 7.3501675 0.3432189 17.052767 0.30278423 -0.055548456 0.0062053599 -1.4914437 0.25052733 142.38428 10.692929
500 0.09651479 0.022312323 1.4575704 0.39244598 4.2080901 0.23399911 -0.01802458 0.006354265 -0.14362617 0.21201356 304.50641 19.184126


# baoab
166.66667 -0.058206222 0.025285246 0.68552685 0.33909464 5.5864006 0.29825988 0.010868964 0.0071601673 -30.866294 0.23225059 110.71769 7.6824867
250 -0.029510505 0.025431311 0.54491233 0.31347518 2.0231679 0.26318219 0.0013826068 0.0066251094 -13.651786 0.20783732 145.34386 9.0355108
500 0.0086405783 0.022319192 0.061933441 0.36694554 0.85321017 0.26503904 -0.0014482857 0.0066685549 -3.2463462 0.20660146 279.73437 19.592695


# aboba
166.66667 0.43474557 0.02230065 -1.459586 0.34934886 -7.3033332 0.29524508 -0.089174247 0.0063511936 31.895746 0.27177404 99.573631 6.0063453
250 0.19051664 0.022039013 -0.98563059 0.32950735 -3.35803 0.25445109 -0.036807589 0.0069004435 13.081878 0.21291862 133.27528 7.4282037
500 0.057610388 0.025060199 -0.36130235 0.34521827 -0.91581343 0.28036035 -0.022705216 0.0061332562 2.9997756 0.21901585 343.48792 25.685468


# hoa2-ends
250 0.077808024 0.025058765 -0.37090101 0.32811898 -1.985468 0.28559555 -0.024485707 0.006195229 -0.32605674 0.24199596 148.79711 10.304161
333.33333 0.057260773 0.025292508 -0.17495902 0.34300112 -0.43052601 0.33225093 -0.022220141 0.006778819 -0.10909548 0.29088902 209.115 14.270786
500 0.021590965 0.024758153 -0.39002278 0.39400265 -0.45612205 0.29013146 -0.001260426 0.0068491736 -0.48556425 0.23768296 288.69091 18.115856


# hoa2-middle
250 0.5046216 0.024036427 6.3861884 0.3907665 12.934004 0.29506491 -0.077636977 0.0064219907 12.283733 0.2401413 145.30577 8.3968101
333.33333 0.28925739 0.023794484 3.2559632 0.38265571 7.6321424 0.25988533 -0.046813848 0.0062710976 6.4271088 0.24836442 197.679 12.062857
500 0.15739946 0.020153463 0.97353916 0.40336757 3.6434301 0.2484826 -0.018958713 0.00603594 3.0487602 0.21400495 328.86537 23.614566


# bcss3-ends
375 0.072478032 0.025997645 0.98175663 0.39515838 1.1018071 0.25813174 -0.013145747 0.006458343 -0.33158128 0.24820072 202.00131 14.537092
500 0.054530498 0.023730774 -0.3209191 0.23884992 0.72523223 0.25599082 -0.014906023 0.0066236119 -0.12943384 0.19836932 292.51518 21.973144
750 0.00047844673 0.02369986 -0.11720384 0.38999606 0.048360598 0.32095671 -0.0097250293 0.0064458158 -0.22899091 0.24807183 484.75778 31.878631


# bcss3-middle
375 -0.097997976 0.023454858 -2.2166628 0.39098709 -4.6855414 0.2979919 0.0070983946 0.0069168881 -4.9563823 0.2360376 239.95228 14.781457
500 -0.048897208 0.025527705 -0.57253985 0.30964569 -2.685676 0.28425694 0.0061405922 0.0067510219 -2.9449604 0.21636731 280.98832 19.570786
750 -0.026527036 0.023909391 -1.0110497 0.3591879 -0.8637733 0.32729889 0.0010912726 0.005777206 -1.0170338 0.22759405 430.271 31.594764


# gier4-fd-ends
375 -0.024823953 0.023016093 0.080861676 0.32877684 -1.0565022 0.27406259 7.9804953e-05 0.0064552297 -0.11399322 0.21645296 223.22084 15.92144
500 -0.020521056 0.025423494 -0.33415534 0.38809667 -0.49048899 0.30856559 -0.0028946773 0.0061804655 -0.22229772 0.2466043 261.15203 19.628226
750 -0.0047880022 0.021256473 0.10984834 0.3926006 -0.40435805 0.33320495 0.0029209571 0.005753957 -0.14963238 0.22412361 483.87936 33.568068


# gier4-fd-middle
500 0.58547992 0.023819777 9.0845971 0.41115638 19.489417 0.33338734 -0.075895446 0.0066062621 17.696381 0.27401703 311.85055 21.218678
666.66667 0.34984695 0.024812608 5.4518004 0.35878255 11.069745 0.33236965 -0.056219122 0.0061787562 9.8238012 0.27107057 345.68738 21.962667
1000 0.1337687 0.025730448 2.2720794 0.37268601 5.1844871 0.30798097 -0.019928309 0.0061708548 4.2798476 0.28724165 557.66966 40.625113


# hmc-hoa2
250 -0.047619122 0.029334186 -0.77254696 0.59260327 -0.63364722 0.36707666 0.010675391 0.0083957434 -0.057572065 0.13967325 171.61103 10.81622
333.33333 -0.011336077 0.028977542 0.11551962 0.49284061 0.49801168 0.3273757 0.0014832334 0.0083010831 -0.071945357 0.1596948 188.80218 15.442412
500 0.058955199 0.027590826 -0.035764436 0.30863417 0.32029751 0.32920284 -0.012158624 0.0076750499 0.0092118793 0.11275741 264.87688 23.398789


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
# The distance between tics that puts about five of them into a range.
tic(range) = range <= 0 ? 1 : nice(range, 10**floor(log10(range)))
nice(range, p) = range < 1.5*p ? 0.2*p : range < 3*p ? 0.5*p : range < 6*p ? p : 2*p

# Bias of canonical averages against cost, a panel for each quantity, and the cost of an independent sample. Above: for each
# scheme its name, colour, filled marker; caption; panels, panel (titles), strict1.., loose1.. (bounds; 0: none, a logarithmic
# axis), low1.., high1.. (of the vertical axes); cost_low, cost_high; $points, a block per scheme: force evaluations per ps, then value and
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
# Schemes of equal cost next to each other.
beside(cost, k) = cost*1.011**(k - 0.5*(curves + 1))
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
  strict = value(sprintf("strict%d", j))
  loose = value(sprintf("loose%d", j))
  if (strict > 0) {
    unset logscale y
    set ytics auto
    set format y "%g"
    set object 1 rectangle from graph 0, first -loose to graph 1, first loose fillstyle solid noborder fillcolor rgb "#f4f4f4" behind
    set object 2 rectangle from graph 0, first -strict to graph 1, first strict fillstyle solid noborder fillcolor rgb "#e2e2e2" behind
    set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead linewidth 1 linecolor rgb ink back
  } else {
    set logscale y
    set ytics (1)
    do for [d=-1:7] { do for [m in "1 2 5"] { y = m*10.0**d; set ytics add (sprintf("%g", y) y) } }
    unset object 1
    unset object 2
    unset arrow 1
  }
  set yrange [value(sprintf("low%d", j)):value(sprintf("high%d", j))]
  plot for [k=1:curves] $points index k-1 using (beside($1, k)):(column(2*j)) with lines linewidth 1.6 linecolor rgb colour[k], \
    for [k=1:curves] $points index k-1 using (beside($1, k)):(column(2*j)):(column(2*j+1)) with yerrorbars pointtype filled[k] pointsize 0.8 linewidth 1.2 linecolor rgb colour[k], \
    NaN notitle
  unset label 1
  unset label 2
}
unset multiplot
