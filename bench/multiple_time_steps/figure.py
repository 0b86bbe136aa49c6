# SPDX-License-Identifier: MIT
"""The figure: R against cost for single and nested schemes, and R against the outer step; drawn by gnuplot."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import curves  # noqa: E402
import drawing  # noqa: E402

SINGLE = ("velocity-verlet", "hoa2", "bcss3", "gier4", "gier4-fd")
NESTED = 6  # the most nested schemes
CAVEAT = ("cost: evaluations of all forces, and of near forces times their share of the time.  outer / inner x n within r: n inner "
          "steps an outer drift, near forces up to r.  Crossed: R above 10 %")


def shown(points, max_nested):
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
    nested = [scheme for _, scheme in sorted(best.values())][:max_nested]
    return {s: own[s] for s in (*[s for s in SINGLE if s in own], *nested)}


def data_and_plots(name, curve, x, style):
    """The data blocks of a curve and the plots of them: up to its end, and crossed beyond."""
    good = len(curves.usable(curve))
    data, plots = [], []
    for part, chosen, look in (("u", curve[:good], f"linespoints pointtype {style.filled} pointsize 0.8 linewidth 1.6"),
                               ("o", curve[good:], "points pointtype 2 pointsize 1.4 linewidth 1.6")):
        if chosen:
            points = "\n".join(f"{p[x]:g} {100 * p['R']:.5g}" for p in chosen)
            data.append(f"{name}{part} << EOD\n{points}\nEOD")
            plots.append(f'{name}{part} using 1:2 with {look} linecolor "{style.colour}" notitle')
    return data, plots


def script(result, image):
    data, panels = [], []
    drawn = {law: shown(of["points"], NESTED) for law, of in result["laws"].items()}
    looks = drawing.styles(list(dict.fromkeys(s for of in drawn.values() for s in of)))
    for column, (law, of) in enumerate(drawn.items()):
        costs = [p["force_evaluations_per_ps"] for curve in of.values() for p in curve]
        left, right = 0.5 * column if len(drawn) > 1 else 0, (0.5 * (column + 1) if len(drawn) > 1 else 1)
        for row, (x, label) in enumerate((("force_evaluations_per_ps", "cost:  force evaluations per ps"),
                                          ("step_fs", "outer step  (fs)"))):
            plots = []
            for k, (scheme, curve) in enumerate(of.items()):
                more, drawings = data_and_plots(f"$c{column}r{row}k{k}", curve, x, looks[scheme])
                data += more
                plots += drawings
            middle, width = (left + right) / 2, (right - left) / 2
            panels.append(f'set lmargin at screen {(left if row == 0 else middle) + 0.15 * width:.4f}\n'
                          f'set rmargin at screen {(left if row == 0 else middle) + 0.97 * width:.4f}\n'
                          f'set xlabel "{label}" offset 0,0.4\nset title "{law}"\n'
                          + (f'set logscale x\nset xtics (100, 150, 200, 300, 400, 600, 1000)\n'
                             f'set xrange [{0.9 * min(costs):.0f}:{1.1 * max(costs):.0f}]\n'
                             if row == 0 else "unset logscale x\nset xtics autofreq\nset xrange [0:*]\n")
                          + f"plot {', '.join(plots)}")
    key = [f'with linespoints pointtype {style.filled} linewidth 1.6 linecolor "{style.colour}" title "{scheme}"'
           for scheme, style in looks.items()]
    return "\n".join([drawing.begin(image, 1000, 680), *data, "set multiplot", drawing.key(key, 0.82, 2),
                      f'set label 1 "{CAVEAT}" at screen 0.01, screen 0.03 left noenhanced textcolor rgb ink font small',
                      "set tmargin at screen 0.76", "set bmargin at screen 0.155", 'set ylabel "R  (%)" offset 2',
                      "set logscale y", 'set format y "%g"', "set yrange [0.01:30]", *panels, "unset multiplot", ""])


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
