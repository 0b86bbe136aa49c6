# A free top. Left: its polhode, ω on the inertia ellipsoid. Right: L on the ellipsoid of the same energy. Above: data, a file with
# the blocks 0: the inertia ellipsoid, 1: polhodes of the same energy, 2: that of the top, 3: its ω; and J1 J2 J3, L1 L2 L3.
tilt = 68  # viewing direction [degrees], as in `set view`
turn = 128
set angles degrees
v1 = sin(tilt)*sin(turn); v2 = -sin(tilt)*cos(turn); v3 = cos(tilt)
twice_E = L1**2/J1 + L2**2/J2 + L3**2/J3
# A point faces the viewer if the normal of the ellipsoid does: L at ω, and ω at L.
k1 = k2 = k3 = n1 = n2 = n3 = 1.0
faces(x, y, z) = n1*x*v1 + n2*y*v2 + n3*z*v3 > 0
visible(a, x, y, z) = faces(x, y, z) ? 1.003*a : NaN
max(a, b) = a > b ? a : b

unset border
unset tics
unset grid
unset key
unset colorbox
set palette defined (0 '#e9eef5', 1 '#cfdbe8')
set cbrange [-1:1]
set pm3d depthorder lighting primary 0.28 specular 0.1
set view tilt, turn, 1.65
set view equal xyz
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set multiplot
set label 1 sprintf("{/:Italic J} = (%.5g, %.5g, %.5g)   {/:Italic L} = (%.5g, %.5g, %.5g)   {/:Italic L}²/2{/:Italic E} = %.5g", \
  J1, J2, J3, L1, L2, L3, (L1**2 + L2**2 + L3**2)/twice_E) at screen 0.5,0.95 center textcolor rgb ink
do for [p=0:1] {
  k1 = J1**p; k2 = J2**p; k3 = J3**p                    # L = J ω
  n1 = J1**(1 - p); n2 = J2**(1 - p); n3 = J3**(1 - p)
  r1 = k1*sqrt(twice_E/J1); r2 = k2*sqrt(twice_E/J2); r3 = k3*sqrt(twice_E/J3)
  r = max(r1, max(r2, r3))
  name = p == 0 ? "ω" : "L"
  set size 0.5, 0.9
  set origin 0.5*p, -0.05
  set xrange [-1.22*r:1.22*r]
  set yrange [-1.22*r:1.22*r]
  set zrange [-1.22*r:1.22*r]
  set xyplane at -1.22*r
  set label 2 p == 0 ? "the polhode: ω on the inertia ellipsoid" : "L on the ellipsoid of the same energy" \
    at screen 0.25 + 0.5*p, 0.87 center textcolor rgb ink
  splot data index 0 using (k1*$1):(k2*$2):(k3*$3):(0) with pm3d
  # Lines are drawn after the surface, which would otherwise hide them.
  set arrow 1 from r1,0,0 to r1 + 0.24*r,0,0 head filled size screen 0.01,18 linecolor "#555555" linewidth 1.2 front
  set arrow 2 from 0,r2,0 to 0,r2 + 0.24*r,0 head filled size screen 0.01,18 linecolor "#555555" linewidth 1.2 front
  set arrow 3 from 0,0,r3 to 0,0,r3 + 0.24*r head filled size screen 0.01,18 linecolor "#555555" linewidth 1.2 front
  set label 3 sprintf("{/:Italic %s}_1", name) at r1 + 0.34*r,0,0 center front textcolor rgb ink
  set label 4 sprintf("{/:Italic %s}_2", name) at 0,r2 + 0.34*r,0 center front textcolor rgb ink
  set label 5 sprintf("{/:Italic %s}_3", name) at 0,0,r3 + 0.34*r center front textcolor rgb ink
  splot data index 1 using (visible(k1*$1, $1, $2, $3)):(k2*$2*1.003):(k3*$3*1.003) with lines linecolor "#6f8aa8" linewidth 1.1, \
    data index 2 using (visible(k1*$1, $1, $2, $3)):(k2*$2*1.003):(k3*$3*1.003) with lines linecolor "#D55E00" linewidth 3.4, \
    data index 3 using (k1*$1):(k2*$2):(k3*$3) with points pointtype 7 pointsize 1.2 linecolor "#802000"
  unset label
  unset arrow
}
unset multiplot
