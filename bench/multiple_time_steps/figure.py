# SPDX-License-Identifier: MIT
"""The figure: R against cost for single and nested schemes, and R against the outer step; drawn by gnuplot."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import curves  # noqa: E402
import drawing  # noqa: E402

# The colours of Okabe and Ito, as in all figures here.
SINGLE = {"velocity-verlet": "#0072B2", "hoa2": "#D55E00", "bcss3": "#CC79A7", "gier4": "#009E73", "gier4-fd": "#56B4E9"}
NESTED = ["#E69F00", "#000000", "#8C564B", "#7F7F7F", "#9467BD", "#BCBD22"]


def shown(points, most):
    """Curves by scheme: the single schemes, and of each pair of nested schemes the one that is cheapest at its middle R."""
    own = {}
    for p in points:
        if p["stable"]:
            own.setdefault(p["scheme"], []).append(p)
    best = {}
    for scheme, curve in own.items():
        curve.sort(key=lambda p: p["step_fs"])
        if "/" not in scheme:
            continue
        # The largest gain over an h² law represents the whole curve.
        worth = min(p["force_evaluations_per_ps"] * p["R"] ** 0.5 for p in curve)
        pair = scheme.split(" x ")[0]
        if pair not in best or worth < best[pair][0]:
            best[pair] = (worth, scheme)
    nested = [scheme for _, scheme in sorted(best.values())][:most]
    return {s: own[s] for s in (*[s for s in SINGLE if s in own], *nested)}


def script(result, image):
    data, panels = [], []
    width = 0.98 / len(result["laws"])
    for column, (law, of) in enumerate(result["laws"].items()):
        drawn = shown(of["points"], len(NESTED))
        costs = [p["force_evaluations_per_ps"] for curve in drawn.values() for p in curve]
        for row, (x, label) in enumerate((("force_evaluations_per_ps", "cost  (force evaluations per ps)"),
                                          ("step_fs", "outer step  (fs)"))):
            plots = []
            nested = iter(NESTED)
            for k, (scheme, curve) in enumerate(drawn.items()):
                colour = SINGLE.get(scheme) or next(nested)
                good = len(curves.usable(curve))
                for usable in (True, False):
                    name = f"$c{column}r{row}k{k}u{int(usable)}"
                    chosen = "\n".join(f"{p[x]:g} {100 * p['R']:.5g}" for p in curve[0 if usable else good:])
                    if not chosen:
                        continue
                    data.append(f"{name} << EOD\n{chosen}\nEOD")
                    style = (f'with linespoints pointtype {5 if "/" in scheme else 7} pointsize 0.6 linewidth 1.6 '
                             f'linecolor "{colour}" title "{scheme if row == 0 else ""}"' if usable else
                             f'with points pointtype 2 pointsize 1.4 linewidth 1.6 linecolor "{colour}" notitle')
                    plots.append(f"{name} using 1:2 {style}")
            panels.append(f'set lmargin at screen {0.11 + width * column}\nset rmargin at screen {width * (column + 1)}\n'
                          f'set tmargin at screen {0.93 - 0.5 * row}\nset bmargin at screen {0.58 - 0.5 * row}\n'
                          f'set xlabel "{label}" offset 0,0.4\n'
                          + (f'set title "{law}"\nset logscale x\nset xtics (100, 150, 200, 300, 400, 600, 1000)\n'
                             f'set xrange [{0.9 * min(costs):.0f}:{1.1 * max(costs):.0f}]\n'
                             if row == 0 else "unset title\nunset logscale x\nset xtics autofreq\nset xrange [0:*]\n")
                          + f"plot {', '.join(plots)}")
    return "\n".join([*drawing.head(image, 150 + 480 * len(result["laws"]), 860), "set yrange [0.01:30]", *data,
                      "set multiplot", *panels, "unset multiplot", ""])


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
