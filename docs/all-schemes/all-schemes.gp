# Restyle this and run it again: gnuplot draws all-schemes.svg.
image = "all-schemes.svg"
format = "svg"
width = 1020
height = 560
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

$c0k0 << EOD
2000 0.054335
1414.43 0.11341
1000 0.21704
709.22 0.43396
500 0.87346
353.357 1.7752
250 3.5924
176.678 7.7104
EOD
$c0k1 << EOD
2000 0.028489
1418.44 0.056064
1000 0.12001
706.714 0.2366
500 0.43014
353.357 0.86448
250 2.1024
EOD
$c0k2 << EOD
2000 0.023031
1413.43 0.043836
1000 0.082739
706.714 0.16913
500 0.37056
353.982 0.88054
250 2.9339
EOD
$c0k3 << EOD
2000 0.014177
1415.09 0.055954
1000 0.21919
707.547 1.0222
500 6.1377
EOD
$c0k4 << EOD
2000 0.0067166
1412.43 0.025274
1000 0.1072
707.214 1.5272
EOD
$c0k5 << EOD
2000 0.0029964
1412.43 0.0042552
1000 0.012859
707.214 0.16652
500 2.9567
EOD
$c0k6 << EOD
2000 0.0099441
1414.14 0.067624
1000 0.74177
EOD
$c0k7 << EOD
2000 0.0032253
1413.43 0.0050508
1000 0.016549
706.714 0.096786
500 1.8039
EOD
$c0k8 << EOD
2000 0.0048541
1413.43 0.0054815
1000 0.014688
706.714 0.10479
500 1.6865
EOD
$c0k9 << EOD
2000 0.0032138
1412.43 0.0033068
1000 0.0045714
707.214 0.05717
500 0.80007
354.61 7.5364
EOD
$c0k10 << EOD
2000 0.0031378
1412.43 0.0030395
1000 0.0046778
707.214 0.097364
500 2.3796
EOD
$c0k11 << EOD
2000 0.0031816
1415.09 0.00333
1000 0.012864
706.714 0.12851
500 0.63346
EOD
$c0k12 << EOD
2000 0.0030301
1415.09 0.0029613
1000 0.013733
706.714 0.37879
500 1.8779
EOD
$c0k13 << EOD
2000 0.0030198
1413.88 0.0040693
1000 0.03372
705.128 0.2377
500 2.5582
EOD
$c0k14 << EOD
2000 0.0030754
1414.14 0.016979
1000 0.13656
707.071 1.3683
EOD
$c0k15 << EOD
2000 0.0068896
1415.09 0.025445
1000 0.16187
706.714 5.6865
EOD
$c0k16 << EOD
2000 0.0041661
1412.43 0.012362
1000 0.054937
707.214 0.89948
EOD
$c0k17 << EOD
2000 0.0029345
1412.43 0.0032356
1000 0.0066246
707.214 0.11195
500 1.6391
EOD
$c0k18 << EOD
2000 0.059721
1414.43 0.11769
1000 0.23616
709.22 0.46467
500 0.91853
353.357 1.8361
250 3.752
176.678 7.5616
EOD
$c0k19 << EOD
2000 0.022772
1418.44 0.04031
1000 0.088991
706.714 0.1728
500 0.32564
353.357 0.62827
250 3.5888
EOD
$c0k19d << EOD
176.991 135.45
EOD
$c0k20 << EOD
2000 0.0031313
1413.43 0.0048774
1000 0.016213
706.714 0.16599
500 1.7621
EOD
$c0k20d << EOD
353.982 88.531
EOD
$c0k21 << EOD
2000 0.0028527
1415.09 0.0030759
1000 0.006007
707.547 0.020898
500 0.19384
353.357 6.7727
EOD
$c0k21d << EOD
250 134.04
EOD
$c0k22 << EOD
2000 0.024333
1415.09 0.045302
1000 0.089785
707.547 0.19375
500 0.38104
353.357 0.73474
250 1.719
EOD
$c0k22d << EOD
176.471 29.551
EOD
$c1k0 << EOD
2000 0.0552
1414.43 0.10781
1000 0.22829
709.22 0.43985
500 0.8829
353.357 1.8192
250 3.7053
176.678 7.5583
EOD
$c1k1 << EOD
2000 0.029369
1418.44 0.059299
1000 0.11439
706.714 0.22357
500 0.45299
353.357 0.83643
250 2.1369
EOD
$c1k2 << EOD
2000 0.023906
1413.43 0.040161
1000 0.10177
706.714 0.18015
500 0.37911
353.982 0.76844
250 2.1572
EOD
$c1k3 << EOD
2000 0.014153
1415.09 0.0512
1000 0.22394
707.547 0.94935
EOD
$c1k4 << EOD
2000 0.0069306
1412.43 0.022512
1000 0.10262
707.214 0.86967
EOD
$c1k5 << EOD
2000 0.0037524
1412.43 0.0048423
1000 0.012279
707.214 0.20873
500 1.2663
EOD
$c1k6 << EOD
2000 0.0095823
1414.14 0.06979
1000 0.5901
EOD
$c1k7 << EOD
2000 0.0038124
1413.43 0.0051788
1000 0.016547
706.714 0.098259
500 0.63228
EOD
$c1k8 << EOD
2000 0.0040946
1413.43 0.0049618
1000 0.015117
706.714 0.089044
500 2.2984
EOD
$c1k9 << EOD
2000 0.0038716
1412.43 0.003738
1000 0.004287
707.214 0.037
500 0.4621
354.61 3.8387
EOD
$c1k10 << EOD
2000 0.0036853
1412.43 0.0037099
1000 0.004687
707.214 0.086964
500 2.1372
EOD
$c1k11 << EOD
2000 0.0037758
1415.09 0.0042098
1000 0.011159
706.714 0.09517
500 0.51269
352.941 2.5094
EOD
$c1k12 << EOD
2000 0.003718
1415.09 0.0037337
1000 0.0090892
706.714 0.26448
500 2.7776
EOD
$c1k13 << EOD
2000 0.0037211
1413.88 0.0054396
1000 0.017924
705.128 0.2076
500 2.0459
EOD
$c1k14 << EOD
2000 0.0036211
1414.14 0.011795
1000 0.089804
707.071 1.0391
EOD
$c1k15 << EOD
2000 0.0073978
1415.09 0.027083
1000 0.1459
706.714 2.6197
EOD
$c1k16 << EOD
2000 0.0047897
1412.43 0.012659
1000 0.052526
707.214 0.78704
EOD
$c1k17 << EOD
2000 0.0038392
1412.43 0.0039772
1000 0.0076058
707.214 0.13362
500 0.92421
354.61 3.933
EOD
$c1k18 << EOD
2000 0.060305
1414.43 0.11472
1000 0.21498
709.22 0.4526
500 0.93076
353.357 2.0646
250 3.8219
176.678 7.8442
EOD
$c1k19 << EOD
2000 0.020199
1418.44 0.045628
1000 0.089405
706.714 0.14697
500 0.30733
353.357 0.6944
250 2.4403
EOD
$c1k19d << EOD
176.991 120.45
EOD
$c1k20 << EOD
2000 0.003727
1413.43 0.0049743
1000 0.016179
706.714 0.087987
500 1.7477
EOD
$c1k20d << EOD
353.982 65.596
EOD
$c1k21 << EOD
2000 0.0038163
1415.09 0.0037039
1000 0.0062223
707.547 0.020372
500 0.19655
353.357 1.5459
EOD
$c1k21d << EOD
250 111.42
EOD
$c1k22 << EOD
2000 0.021974
1415.09 0.043911
1000 0.089294
707.547 0.165
500 0.35105
353.357 0.77357
250 1.6881
EOD
$c1k22d << EOD
176.471 20.21
EOD
$c2k0 << EOD
1000 0.014072
709.22 0.026173
500 0.05401
353.357 0.10207
250 0.21773
176.678 0.40959
125 0.83601
88.4956 1.7104
62.5 3.5872
EOD
$c2k1 << EOD
1000 0.0056764
706.714 0.010703
500 0.020729
353.357 0.04461
250 0.085295
176.991 0.17605
125 0.40671
88.4956 1.7641
EOD
$c2k2 << EOD
1000 0.0062564
706.714 0.01181
500 0.023079
353.982 0.046718
250 0.094695
176.991 0.17165
125 0.32071
88.3002 1.056
EOD
$c2k3 << EOD
1000 0.0029885
707.547 0.008906
500 0.039126
353.357 0.17145
EOD
$c2k4 << EOD
1000 0.0016402
707.214 0.0051945
500 0.025006
354.61 0.25185
250 1.4815
EOD
$c2k5 << EOD
1000 0.0014482
707.214 0.0018774
500 0.0030711
354.61 0.032418
250 0.18033
176.678 1.6148
125 8.6991
EOD
$c2k6 << EOD
1000 0.0029326
707.071 0.0070416
500 0.056588
353.535 0.62558
250 5.6789
EOD
$c2k7 << EOD
1000 0.0015283
706.714 0.0020465
500 0.0045143
353.982 0.015277
250 0.14224
176.991 1.5255
125 6.2226
EOD
$c2k8 << EOD
1000 0.0014544
706.714 0.0029703
500 0.0055787
353.982 0.017226
250 0.063565
176.991 0.53207
EOD
$c2k9 << EOD
1000 0.0015878
707.214 0.0014904
500 0.0045283
354.61 0.013085
250 0.045233
176.678 0.34327
125 1.0368
88.3392 3.8664
EOD
$c2k10 << EOD
1000 0.0013536
707.214 0.0014413
500 0.0028636
354.61 0.018781
250 0.23107
176.678 1.3104
EOD
$c2k11 << EOD
1000 0.0014018
706.714 0.0016643
500 0.003369
352.941 0.013669
250 0.054018
176.991 0.45791
125 5.8269
EOD
$c2k12 << EOD
1000 0.0013776
706.714 0.0019431
500 0.0055067
352.941 0.036814
250 0.17846
176.991 1.1348
125 2.866
EOD
$c2k13 << EOD
1000 0.0013701
705.128 0.0018553
500 0.0038334
353.698 0.033929
250 0.28526
176.849 1.0288
EOD
$c2k14 << EOD
1000 0.0014201
707.071 0.0017716
500 0.012199
353.535 0.17636
250 1.237
176.768 3.7335
EOD
$c2k15 << EOD
1000 0.00205
706.714 0.0058435
500 0.024024
352.941 0.20451
250 1.3344
EOD
$c2k16 << EOD
1000 0.0014774
707.214 0.0024786
500 0.0078524
354.61 0.073151
250 0.79879
176.678 6.2746
EOD
$c2k17 << EOD
1000 0.0016747
707.214 0.0020714
500 0.0037324
354.61 0.015491
250 0.061457
176.678 0.33319
125 3.6041
EOD
$c2k18 << EOD
1000 0.011272
709.22 0.021585
500 0.040749
353.357 0.084359
250 0.18473
176.678 0.33504
125 0.67202
88.4956 1.4403
62.5 2.6459
EOD
$c2k19 << EOD
1000 0.0052197
706.714 0.0099941
500 0.022154
353.357 0.043014
250 0.081985
176.991 0.17665
125 0.44193
88.4956 3.537
EOD
$c2k19d << EOD
62.5 65.039
EOD
$c2k20 << EOD
1000 0.001538
706.714 0.0023351
500 0.0056545
353.982 0.015547
250 0.17085
176.991 1.4579
125 8.2635
EOD
$c2k21 << EOD
1000 0.0013779
707.547 0.0016182
500 0.0029338
353.357 0.0066553
250 0.027613
176.471 0.52655
125 1.6541
EOD
$c2k21d << EOD
88.4956 14.848
62.5 138.02
EOD
$c2k22 << EOD
1000 0.0056049
707.547 0.0093442
500 0.021191
353.357 0.044022
250 0.078638
176.471 0.15446
125 0.33448
88.4956 0.79014
EOD
$c2k22d << EOD
62.5 10.683
EOD
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.86
set tmargin at screen 0.99
unset border
unset grid
set tics scale 0
set format ""
set xrange [0:1]
set yrange [0:1]
set key inside center center horizontal maxcols 3 font small
plot NaN notitle, \
  keyentry with linespoints pointtype 7 linewidth 1.8 linecolor "#0072B2" title "velocity-verlet", \
  keyentry with linespoints pointtype 5 linewidth 1.8 linecolor "#D55E00" title "hoa2", \
  keyentry with linespoints pointtype 11 linewidth 1.8 linecolor "#117733" title "gier4", \
  keyentry with linespoints pointtype 9 linewidth 1.8 linecolor "#009E73" title "gier4-fd", \
  keyentry with linespoints pointtype 13 linewidth 1.8 linecolor "#CC79A7" title "bcss3", \
  keyentry with lines linewidth 1 linecolor "#c8c8c8" title "18 others", \
  keyentry with points pointtype 2 linewidth 1.4 linecolor rgb ink title "energy not conserved"
unset key
set format "%g"
set border 3 linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linewidth 0.5 linecolor "#e4e4e4"
set key noenhanced Left reverse samplen 1.6 textcolor rgb ink
set title noenhanced textcolor rgb ink

set logscale xy
set tmargin at screen 0.78
set bmargin at screen 0.17
set ylabel "R  (%)" offset 2
set format y "%g"
set xlabel "cost:  force evaluations per ps" offset 0,0.4
set xtics (60, 100, 200, 400, 1000, 2000)
set label 1 "A derivative of the forces counts as two evaluations; energy not conserved: R above 10 %, or a run blew up. R levels off at that of rounding in mixed precision." at screen 0.01, screen 0.03 left noenhanced textcolor rgb ink font small
set yrange [0.001:20]
set xrange [159:2100]
set lmargin at screen 0.078
set rmargin at screen 0.327
set title "reaction-field"
plot $c0k0 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k1 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k2 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k3 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k4 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k5 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k6 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k7 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k8 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k9 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k10 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k11 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k12 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k13 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k14 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k15 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k16 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k17 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c0k18 using 1:2 with linespoints pointtype 7 pointsize 0.7 linewidth 1.8 linecolor "#0072B2" notitle, $c0k19 using 1:2 with linespoints pointtype 5 pointsize 0.7 linewidth 1.8 linecolor "#D55E00" notitle, $c0k19d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#D55E00" notitle, $c0k20 using 1:2 with linespoints pointtype 11 pointsize 0.7 linewidth 1.8 linecolor "#117733" notitle, $c0k20d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#117733" notitle, $c0k21 using 1:2 with linespoints pointtype 9 pointsize 0.7 linewidth 1.8 linecolor "#009E73" notitle, $c0k21d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#009E73" notitle, $c0k22 using 1:2 with linespoints pointtype 13 pointsize 0.7 linewidth 1.8 linecolor "#CC79A7" notitle, $c0k22d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#CC79A7" notitle
set xrange [159:2100]
set lmargin at screen 0.405
set rmargin at screen 0.653
set title "pme"
plot $c1k0 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k1 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k2 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k3 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k4 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k5 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k6 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k7 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k8 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k9 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k10 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k11 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k12 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k13 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k14 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k15 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k16 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k17 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c1k18 using 1:2 with linespoints pointtype 7 pointsize 0.7 linewidth 1.8 linecolor "#0072B2" notitle, $c1k19 using 1:2 with linespoints pointtype 5 pointsize 0.7 linewidth 1.8 linecolor "#D55E00" notitle, $c1k19d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#D55E00" notitle, $c1k20 using 1:2 with linespoints pointtype 11 pointsize 0.7 linewidth 1.8 linecolor "#117733" notitle, $c1k20d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#117733" notitle, $c1k21 using 1:2 with linespoints pointtype 9 pointsize 0.7 linewidth 1.8 linecolor "#009E73" notitle, $c1k21d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#009E73" notitle, $c1k22 using 1:2 with linespoints pointtype 13 pointsize 0.7 linewidth 1.8 linecolor "#CC79A7" notitle, $c1k22d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#CC79A7" notitle
set xrange [56:1050]
set lmargin at screen 0.732
set rmargin at screen 0.980
set title "co2"
plot $c2k0 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k1 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k2 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k3 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k4 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k5 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k6 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k7 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k8 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k9 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k10 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k11 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k12 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k13 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k14 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k15 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k16 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k17 using 1:2 with lines linewidth 1 linecolor "#c8c8c8" notitle, $c2k18 using 1:2 with linespoints pointtype 7 pointsize 0.7 linewidth 1.8 linecolor "#0072B2" notitle, $c2k19 using 1:2 with linespoints pointtype 5 pointsize 0.7 linewidth 1.8 linecolor "#D55E00" notitle, $c2k19d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#D55E00" notitle, $c2k20 using 1:2 with linespoints pointtype 11 pointsize 0.7 linewidth 1.8 linecolor "#117733" notitle, $c2k21 using 1:2 with linespoints pointtype 9 pointsize 0.7 linewidth 1.8 linecolor "#009E73" notitle, $c2k21d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#009E73" notitle, $c2k22 using 1:2 with linespoints pointtype 13 pointsize 0.7 linewidth 1.8 linecolor "#CC79A7" notitle, $c2k22d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 linecolor "#CC79A7" notitle
unset multiplot
