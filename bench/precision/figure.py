# SPDX-License-Identifier: MIT
"""The figure: R against the step in both precisions, and how the fluctuation grows; drawn by gnuplot."""

import csv
import re
import sys
from math import floor, log10, sqrt
from pathlib import Path
from statistics import fmean
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent
SCHEMES = ("velocity-verlet", "hoa2", "gier4-fd")
ETA = 0.1931833275037836
# Sums of the squared weights of a step's force evaluations; GIER4 with lambda = 1.
WEIGHTS = {"velocity-verlet": 1.0, "hoa2": (2 * ETA) ** 2 + (1 - 2 * ETA) ** 2, "gier4-fd": 5 / 9}
PRECISIONS = ("mixed", "double")
ROUNDING, WALK = (f"linewidth 1.2 dashtype {k} linecolor rgb ink" for k in (3, 4))


def rms_potential(result):
    return fmean(r["rms_potential"] for r in result["runs"] if r["kind"] == "short")


def ladder(result, scheme, precision):
    """(step [fs], R [%]) of a scheme at its own lambda, means over initial configurations."""
    own = [r for r in result["runs"] if r["kind"] == "short" and r["electrostatics"] == "coulomb"
           and r["lambda"] == "" and (r["scheme"], r["precision"]) == (scheme, precision)]
    for step in sorted({r["step_fs"] for r in own}):
        yield step, 100 * fmean(r["R"] for r in own if r["step_fs"] == step)


def decade(x, up):
    return 10.0 ** (floor(log10(x)) + up)


def curve(name, style, precision):
    """Filled markers and full lines for mixed precision, open ones and dashes for double."""
    double = precision == "double"
    return (f'{name} using 1:2 with linespoints linewidth 1.6 dashtype {1 + double} pointsize {1.2 if double else 0.8} '
            f'pointtype {style.open if double else style.filled} linecolor "{style.colour}" notitle')


def block(name, points):
    return f"{name} << EOD\n" + "\n".join(f"{x:g} {y:.6g}" for x, y in points) + "\nEOD"


def ladders(result, schemes, looks):
    """Data and curves of R against the step."""
    data, plots = [], []
    for s in schemes:
        for precision in PRECISIONS:
            name = f"${s.replace('-', '_')}_{precision}"
            data.append(block(name, ladder(result, s, precision)))
            plots.append(curve(name, looks[s], precision))
    return data, plots


def windows(result, looks):
    """Data and curves of the fluctuation in windows of the long runs."""
    data, plots = [], []
    for s, h in long_cases(result):
        for precision in PRECISIONS:
            name = f"$growth_{s.replace('-', '_')}_{precision}"
            own = [g for g in result["growth"] if (g["scheme"], g["step_fs"], g["precision"]) == (s, h, precision)]
            data.append(block(name, [(g["window_ps"], g["rms_total"]) for g in own]))
            plots.append(curve(name, looks[s], precision))
    return data, plots


def long_cases(result):
    """Scheme and step [fs] of the long runs."""
    return sorted({(g["scheme"], g["step_fs"]) for g in result["growth"]})


def legend(schemes, looks, walk):
    """Entries for both panels."""
    entries = [f'with linespoints linewidth 1.6 pointtype {looks[s].filled} linecolor "{looks[s].colour}" title "{s}"' for s in schemes]
    entries += ['with linespoints linewidth 1.6 pointtype 7 linecolor rgb ink title "mixed precision"',
                'with linespoints linewidth 1.6 dashtype 2 pointtype 6 linecolor rgb ink title "double precision"',
                f'with lines {ROUNDING} title "rounding of gier4-fd, mixed"']
    return entries + ([f'with lines {WALK} title "its random walk"'] if walk else [])


def script(result, image):
    looks = drawing.styles(SCHEMES)
    schemes = [s for s in SCHEMES if any(r["scheme"] == s for r in result["runs"])]
    (data, steps), (more, growth) = ladders(result, schemes, looks), windows(result, looks)
    a, scale = result["a_kJ_per_mol"], rms_potential(result)
    steps.append(f"{100 * a / scale:.6g} with lines {ROUNDING} notitle")
    walk = result["c_kJ_per_mol_ps"] ** 2 * 1e-3 * result["weights"]["gier4-fd"] / 6  # gier4-fd at 1 fs
    growth.append(f"sqrt({a**2:.6g} + {walk:.6g}*x) with lines {ROUNDING} notitle")
    if walk > 0:  # a short run does not show it
        growth.append(f"sqrt({walk:.6g}*x) with lines {WALK} notitle")
    shown = [100 * r["R"] for r in result["runs"] if r["kind"] == "short" and r["lambda"] == ""]
    sizes = [g["rms_total"] for g in result["growth"]] + [sqrt(walk * 0.25) or a]
    lengths = {kind: next(r["length_ps"] for r in result["runs"] if r["kind"] == kind) for kind in ("short", "long")}
    return Template((HERE / "figure.gp").read_text(encoding="utf-8")).substitute(
        style=drawing.begin(image, 1000, 500), key=drawing.key(legend(schemes, looks, walk > 0), 0.88, 4), data="\n".join(data + more),
        steps=", \\\n  ".join(steps), growth=", \\\n  ".join(growth), short=f"{lengths['short']:g}", long=f"{lengths['long']:g}",
        cases=", ".join(f"{s} at {h:g} fs" for s, h in long_cases(result)), low=f"{decade(min(shown), 0):g}",
        high=f"{decade(max(shown), 1):g}", widest=f"{1.25 * lengths['long']:g}", growth_low=f"{decade(min(sizes), 0):g}",
        growth_high=f"{decade(max(sizes), 1):g}")


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


def table(path):
    """Rows of a CSV file, numbers as numbers, and its comments."""
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    text = {"kind", "electrostatics", "scheme", "lambda", "precision"}
    return ([{k: v if k in text or v == "" else float(v) for k, v in row.items()} for row in rows],
            [line for line in lines if line.startswith("#")])


def stored(prefix):
    """The result in PREFIX.csv and PREFIX-growth.csv; the comments of the second have a and c."""
    runs, _ = table(prefix.with_name(prefix.name + ".csv"))
    growth, comments = table(prefix.with_name(prefix.name + "-growth.csv"))
    a, c = re.search(r"a ([\d.e+-]+) kJ/mol, c ([\d.e+-]+) kJ/mol/ps", "\n".join(comments)).groups()
    return {"runs": runs, "growth": growth, "weights": WEIGHTS, "a_kJ_per_mol": float(a), "c_kJ_per_mol_ps": float(c)}


if __name__ == "__main__":  # figure.py PREFIX IMAGE: redraws stored results
    draw(stored(Path(sys.argv[1])), Path(sys.argv[2]))
