# SPDX-License-Identifier: MIT
"""The figure: R against cost, a panel for each system; the schemes that are cheapest at some R in colour, the others grey."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import curves  # noqa: E402
import drawing  # noqa: E402

# The colours of Okabe and Ito, as in all figures here.
ALWAYS = {"velocity-verlet": "#0072B2", "hoa2": "#D55E00", "gier4": "#009E73", "gier4-fd": "#56B4E9"}
WINNERS = ["#CC79A7", "#E69F00", "#000000", "#F0E442"]


def colours(of):
    """The highlighted schemes: those of the paper, and those with the lowest cost at some R."""
    first = dict.fromkeys(row["schemes"][0]["scheme"] for row in of["ranking"] if row["schemes"])
    others = [s for s in first if s not in ALWAYS]
    return {**ALWAYS, **dict(zip(others, WINNERS))}


def script(result, image):
    data, panels = [], []
    systems = list(result["systems"].items())
    for column, (system, of) in enumerate(systems):
        told = colours(of)
        own = curves.by_scheme(p for p in of["points"] if p["stable"])
        plots = []
        for k, scheme in enumerate(sorted(own, key=lambda s: s in told)):  # grey ones below
            name = f"$c{column}k{k}"
            good = len(curves.usable(own[scheme]))
            row = lambda p: f"{p['force_evaluations_per_ps']:g} {100 * p['R']:.5g}"
            data.append(f"{name} << EOD\n" + "\n".join(map(row, own[scheme][:good])) + "\nEOD")
            if good and scheme in told:
                plots.append(f'{name} using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 1.8 '
                             f'linecolor "{told[scheme]}" title "{scheme}"')
            elif good:
                plots.append(f'{name} using 1:2 with lines linewidth 1 linecolor "#b8b8b8" notitle')
            if scheme in told and good < len(own[scheme]):
                data.append(f"{name}d << EOD\n" + "\n".join(map(row, own[scheme][good:])) + "\nEOD")
                plots.append(f'{name}d using 1:2 with points pointtype 2 pointsize 0.9 linewidth 1.4 '
                             f'linecolor "{told[scheme]}" notitle')
        width, labels = 0.98 / len(systems), 75 / (450 * len(systems))
        costs = [p["force_evaluations_per_ps"] for p in of["points"]]
        panels.append(f'set xrange [{0.9 * min(costs):.0f}:{1.05 * max(costs):.0f}]\n'
                      f'set lmargin at screen {labels + width * column:.3f}\n'
                      f'set rmargin at screen {width * (column + 1):.3f}\n'
                      f'set title "{system}"\nplot {", ".join(plots)}')
    return "\n".join([
        *drawing.head(image, 450 * len(systems), 460), "set logscale x",
        'set xlabel "cost  (force evaluations per ps)" offset 0,0.4', "set xtics (60, 100, 150, 200, 300, 400, 600, 1000, 2000)",
        "set yrange [0.002:20]", *data, "set multiplot", *panels, "unset multiplot", ""])


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
