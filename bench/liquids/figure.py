# SPDX-License-Identifier: MIT
"""The figure: g(r) of the oxygens of each water, and their first peaks larger, drawn by gnuplot."""

import json
import sys
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

SCRIPT = Template("""${style}
set title offset 0,-0.4
set key top right

${data}

set multiplot
set bmargin at screen 0.145
set tmargin at screen 0.905
set ylabel "g_{OO}" offset 0.8
set xlabel "r  (nm)" offset 0,0.3

set lmargin at screen 0.075
set rmargin at screen 0.555
set title "oxygen-oxygen radial distribution, 298 K"
set xrange [0.2:0.9]
set yrange [0:3.5]
plot ${plots}, 1 with lines linewidth 0.8 dashtype 3 linecolor rgb ink title "no structure"

set lmargin at screen 0.655
set rmargin at screen 0.97
set title "first peak"
set xrange [0.26:0.30]
set yrange [2:3.5]
set xtics 0.01
unset key
plot ${plots}
unset multiplot
""")


def script(result, image):
    data, plots = [], []
    for w, colour in zip(result["waters"], drawing.PALETTE):
        name = "$" + w["model"].replace("-", "_")
        points = "\n".join(f"{r:g} {g:.4g}" for r, g in w["g"])
        data.append(f"{name} << EOD\n{points}\nEOD")
        plots.append(f'{name} using 1:2 with lines linewidth 1.6 linecolor "{colour}" '
                     f'title "{w["name"]}"')
    return SCRIPT.substitute(style=drawing.begin(image, 1000, 440), data="\n".join(data), plots=", \\\n  ".join(plots))


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
