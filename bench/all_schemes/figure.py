# SPDX-License-Identifier: MIT
"""The figure: R against cost, a panel for each system; the schemes that are cheapest at some R in colour, the others pale."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import curves  # noqa: E402
import drawing  # noqa: E402

ALWAYS = ("velocity-verlet", "hoa2", "gier4", "gier4-fd")
PALE = "#c8c8c8"
CAVEAT = ("A derivative of the forces counts as two evaluations; energy not conserved: R above 10 %, or a run blew up. "
          "R levels off at that of rounding in mixed precision.")


def highlighted(systems):
    """Those of the paper, and those with the lowest cost at some R of some system."""
    first = (row["schemes"][0]["scheme"] for of in systems for row in of["ranking"] if row["schemes"])
    return list(dict.fromkeys([*ALWAYS, *first]))


def script(result, image):
    data, panels = [], []
    systems = list(result["systems"].items())
    measured = {p["scheme"] for _, of in systems for p in of["points"]}
    told = drawing.styles([s for s in highlighted(of for _, of in systems) if s in measured])
    others = len(measured - told.keys())
    for column, (system, of) in enumerate(systems):
        own = curves.by_scheme(p for p in of["points"] if p["stable"])
        plots = []
        for k, scheme in enumerate(sorted(own, key=lambda s: s in told)):  # pale ones below
            name = f"$c{column}k{k}"
            good = len(curves.usable(own[scheme]))
            row = lambda p: f"{p['force_evaluations_per_ps']:g} {100 * p['R']:.5g}"
            data.append(f"{name} << EOD\n" + "\n".join(map(row, own[scheme][:good])) + "\nEOD")
            if good and scheme in told:
                plots.append(f'{name} using 1:2 with linespoints pointtype {told[scheme].filled} pointsize 0.7 linewidth 1.8 '
                             f'linecolor "{told[scheme].colour}" notitle')
            elif good:
                plots.append(f'{name} using 1:2 with lines linewidth 1 linecolor "{PALE}" notitle')
            if scheme in told and good < len(own[scheme]):
                data.append(f"{name}d << EOD\n" + "\n".join(map(row, own[scheme][good:])) + "\nEOD")
                plots.append(f'{name}d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 '
                             f'linecolor "{told[scheme].colour}" notitle')
        width, labels = 0.98 / len(systems), 80 / (340 * len(systems))
        costs = [p["force_evaluations_per_ps"] for p in of["points"]]
        panels.append(f'set xrange [{0.9 * min(costs):.0f}:{1.05 * max(costs):.0f}]\n'
                      f'set lmargin at screen {labels + width * column:.3f}\n'
                      f'set rmargin at screen {width * (column + 1):.3f}\n'
                      f'set title "{system}"\nplot {", ".join(plots)}')
    key = [f'with linespoints pointtype {style.filled} linewidth 1.8 linecolor "{style.colour}" title "{scheme}"'
           for scheme, style in told.items()]
    if others:
        key.append(f'with lines linewidth 1 linecolor "{PALE}" title "{others} others"')
    key.append('with points pointtype 2 linewidth 1.4 linecolor rgb ink title "energy not conserved"')
    return "\n".join([
        drawing.begin(image, 340 * len(systems), 560), *data, "set multiplot", drawing.key(key, 0.86), "set logscale xy",
        "set tmargin at screen 0.78", "set bmargin at screen 0.17", 'set ylabel "R  (%)" offset 2', 'set format y "%g"',
        'set xlabel "cost:  force evaluations per ps" offset 0,0.4', "set xtics (60, 100, 200, 400, 1000, 2000)",
        f'set label 1 "{CAVEAT}" at screen 0.01, screen 0.03 left noenhanced textcolor rgb ink font small',
        "set yrange [0.001:20]", *panels, "unset multiplot", ""])


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
