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


def density_looks(names):
    """Colour, marker and dashes of each curve: colours are those of schemes; a step shorter than another of its scheme is open, and
    its line dashed."""
    scheme, step = (lambda name: name.split(",")[0]), (lambda name: float(name.split(", ")[1].split()[0]))
    style = drawing.styles({scheme(n) for n in names})
    short = {n for n in names if any(scheme(m) == scheme(n) and step(m) > step(n) for m in names)}
    return {n: (style[scheme(n)].colour, style[scheme(n)].open if n in short else style[scheme(n)].filled, 2 if n in short else 1) for n in names}


def polynomial(fit):
    """A fit as a function of gnuplot's x."""
    middle = sum(fit.domain) / 2
    terms = fit.convert(domain=[middle - 1, middle + 1]).coef
    return " + ".join(f"{c:.10g}*(x - {middle:.6g})**{k}" for k, c in enumerate(terms))


def density_script(points, image):
    """Above: densities without a bias of the step and those of schemes without a prediction, with cubics; those of the other schemes
    as predicted. Below: the predicted biases, with parabolas."""
    maxima, own, biases = tables.maxima_of(points), tables.own_densities(points), tables.density_biases(points)
    looks = {tables.LIMIT: ("#404040", 7, 1), **density_looks([n for n in maxima if n != tables.LIMIT])}
    title = lambda n: f"{n}: maximum at {tables.cell(maxima[n].place, 1)} K"
    line = lambda n, fit: f'{polynomial(fit)} with lines linewidth 1.6 dashtype {looks[n][2]} linecolor "{looks[n][0]}" notitle'
    marks = lambda n, k: f'$curve{k} using 1:2:3 with yerrorbars linewidth 1.2 pointtype {looks[n][1]} pointsize 0.9 linecolor "{looks[n][0]}" notitle'
    measured = {tables.LIMIT: tables.limit_densities(points), **{n: own[n] for n in maxima if n in own}}
    predicted = {n: biases[n] for n in maxima if n in biases}
    above = [line(n, m.fit) for n, m in maxima.items()] + [marks(n, k) for k, n in enumerate(measured)]
    below = [line(n, tables.bias_fit(*list(zip(*rows))[:2])) for n, rows in predicted.items()]
    below += [marks(n, k + len(measured)) for k, n in enumerate(predicted)]
    entries = [f'with linespoints linewidth 1.6 dashtype {looks[n][2]} pointtype {looks[n][1]} linecolor "{looks[n][0]}" title "{title(n)}"' for n in maxima]
    temperatures = [row[0] for row in measured[tables.LIMIT]]
    return "\n".join([
        drawing.begin(image, 760, 760), *blocks([*measured.values(), *predicted.values()]), "set multiplot", drawing.key(entries, 0.865, 1), "set grid",
        "set lmargin at screen 0.13", f"set xrange [{min(temperatures) - 3:g}:{max(temperatures) + 3:g}]",
        "set tmargin at screen 0.855", "set bmargin at screen 0.42", 'set format x ""', 'set ylabel "density  (kg/m³)"', "set yrange [*:*]",
        "plot " + ", \\\n  ".join(above),
        "set tmargin at screen 0.39", "set bmargin at screen 0.1", 'set format x "%g"', 'set xlabel "temperature  (K)"',
        'set ylabel "predicted bias by the step  (kg/m³)"', "set xzeroaxis linewidth 1 linecolor rgb ink",
        "plot " + ", \\\n  ".join(below), "unset multiplot", ""])


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
