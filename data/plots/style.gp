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
