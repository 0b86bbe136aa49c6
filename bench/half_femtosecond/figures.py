#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures of the study, from its record: biases against cost for all schemes, and density against temperature."""

import json
import sys
from pathlib import Path

import numpy as np
import tables

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

PANELS = {"difference": "|T_{rot} − T_{trans}| by the step [K]", "potential": "|potential energy| by the step [kJ/mol]"}


def blocks(curves):
    return [f"$curve{k} << EOD\n" + "\n".join(" ".join(f"{x:.6g}" for x in row) for row in rows) + "\nEOD" for k, rows in enumerate(curves)]


def bar(mean, error):
    """Size, and ends of the error bar, on a logarithmic scale; no bar where the error is not known."""
    size = abs(mean)
    return size, max(size - error, size / 10) if error < np.inf else size, size + error if error < np.inf else size


def bias_script(points, image):
    """Two panels: the bias that runs at constant energy predict, against force evaluations per ps, with the required bias."""
    schemes = list(dict.fromkeys(p.scheme for p in points))
    style = drawing.styles(schemes)
    lines = [drawing.begin(image, 960, 520), "set multiplot",
             drawing.key([f'with linespoints linecolor "{style[s].colour}" pointtype {style[s].filled} title "{s}"' for s in schemes], 0.88, 5),
             "set logscale xy", "set grid", 'set xlabel "force evaluations per ps"', "set xrange [150:3000]", "set yrange [*:*]", "set xtics (200, 500, 1000, 2000)", 'set format y "10^{%T}"', "set tmargin at screen 0.85",
             "set bmargin at screen 0.14"]
    for k, (name, label) in enumerate(PANELS.items()):
        curves = [[(p.evaluations_per_ps, *bar(*tables.of_runs(runs, tables.predicted(name)))) for p, runs in points.items() if p.scheme == scheme]
                  for scheme in schemes]
        bound, unit = tables.REQUIRED[name]
        lines += [*blocks(curves), f"set lmargin at screen {0.09 + 0.5 * k}", f"set rmargin at screen {0.48 + 0.5 * k}", f'set ylabel "{label}"',
                  f'set label 1 "{bound:g} {unit}" at graph 0.03, first {1.25 * bound:g} font small textcolor rgb ink',
                  f"plot {bound} with lines linewidth 1 dashtype 3 linecolor rgb ink notitle, \\\n  "
                  + ", \\\n  ".join(f'$curve{n} using 1:2:3:4 with yerrorlines linewidth 1.6 linecolor "{style[s].colour}" '
                                    f'pointtype {style[s].filled} pointsize 0.9 notitle' for n, s in enumerate(schemes))]
    return "\n".join([*lines, "unset multiplot", ""])


def density_script(points, image):
    curves = tables.density_curves(points)
    lines = [drawing.begin(image, 720, 520), *blocks(curves.values()), "set grid", 'set xlabel "temperature [K]"', 'set ylabel "density [kg/m³]"',
             "set key bottom left"]
    plots, arrows = [], []
    for k, (name, rows) in enumerate(curves.items()):
        T, density = [row[0] for row in rows], [row[1] for row in rows]
        top = tables.maximum(T, density)
        middle = np.mean(T)
        a, b, c = np.polyfit(np.array(T) - middle, density, 2)
        colour = drawing.PALETTE[k]
        plots += [f'$curve{k} using 1:2:3 with yerrorbars linecolor "{colour}" pointtype 7 title "{name}: maximum at {top:.1f} K"',
                  f'{a:.8g}*(x-{middle:.6g})**2 + {b:.8g}*(x-{middle:.6g}) + {c:.10g} with lines linewidth 1.6 linecolor "{colour}" notitle']
        height = a * (top - middle) ** 2 + b * (top - middle) + c
        arrows.append(f'set arrow from {top:.4f}, {height + 1:.4f} to {top:.4f}, {height:.4f} linecolor "{colour}" linewidth 1.6')
    return "\n".join([*lines, *arrows, "plot " + ", \\\n  ".join(plots), ""])


def draw(lines, folder, form="svg"):
    points = tables.by_point(lines)
    energy = {p: runs for p, runs in points.items() if p.group in ("energy", "quick")}
    pressure = {p: runs for p, runs in points.items() if p.ensemble == "constant pressure"}
    for name, chosen, script in (("bias", energy, bias_script), ("density", pressure, density_script)):
        if len({p.temperature for p in chosen}) > 3 or name == "bias" and chosen:
            image = folder / f"{name}.{form}"
            drawing.draw(script(chosen, image), image)


if __name__ == "__main__":  # figures.py RECORD FOLDER [svg|png]
    draw([json.loads(line) for line in Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()], Path(sys.argv[2]), *sys.argv[3:4])
