# SPDX-License-Identifier: MIT
"""The figure: R against the step in both precisions, and how the fluctuation grows; drawn by gnuplot."""

import json
import sys
from math import floor, log10, sqrt
from pathlib import Path
from statistics import fmean
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent
SCHEMES = ("velocity-verlet", "hoa2", "gier4-fd")


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


def script(result, image):
    looks = drawing.styles(SCHEMES)
    schemes = [s for s in SCHEMES if any(r["scheme"] == s for r in result["runs"])]
    data, steps, growth = [], [], []
    for s in schemes:
        for k, precision in enumerate(("mixed", "double")):
            name = f"${s.replace('-', '_')}_{precision}"
            points = "\n".join(f"{h:g} {r:.6g}" for h, r in ladder(result, s, precision))
            data.append(f"{name} << EOD\n{points}\nEOD")
            steps.append(f'{name} using 1:2 with linespoints linewidth 1.6 dashtype {2 if k else 1} pointsize '
                         f'{1.2 if k else 0.8} pointtype {looks[s][1 + k]} linecolor "{looks[s].colour}" '
                         + (f'title "{s}"' if k == 0 else "notitle"))
    a, scale = result["a_kJ_per_mol"], rms_potential(result)
    steps.append(f'{100 * a / scale:.6g} with lines linewidth 1.2 dashtype 3 linecolor rgb ink '
                 'title "rounding alone"')
    long = sorted({(g["scheme"], g["step_fs"]) for g in result["growth"]})
    for s, h in long:
        for k, precision in enumerate(("mixed", "double")):
            name = f"$growth_{s.replace('-', '_')}_{precision}"
            own = [g for g in result["growth"] if (g["scheme"], g["step_fs"], g["precision"]) == (s, h, precision)]
            points = "\n".join(f"{g['window_ps']:g} {g['rms_total']:.6g}" for g in own)
            data.append(f"{name} << EOD\n{points}\nEOD")
            growth.append(f'{name} using 1:2 with linespoints linewidth 1.6 dashtype {2 if k else 1} pointsize '
                          f'{1.2 if k else 0.8} pointtype {looks[s][1 + k]} linecolor "{looks[s].colour}" '
                          f'title "{s} {h:g} fs, {precision}"')
    walk = result["c_kJ_per_mol_ps"] ** 2 * 1e-3 * result["weights"]["gier4-fd"] / 6  # gier4-fd at 1 fs
    growth.append(f'sqrt({a**2:.6g} + {walk:.6g}*x) with lines linewidth 1.2 dashtype 3 linecolor rgb ink '
                  'title "rounding of gier4-fd"')
    if walk > 0:  # a short run does not show it
        growth.append(f'sqrt({walk:.6g}*x) with lines linewidth 1.2 dashtype 4 linecolor rgb ink title "its walk"')
    shown = [100 * r["R"] for r in result["runs"] if r["kind"] == "short" and r["lambda"] == ""]
    sizes = [g["rms_total"] for g in result["growth"]] + [sqrt(walk * 0.25) or a]
    lengths = {kind: next(r["length_ps"] for r in result["runs"] if r["kind"] == kind) for kind in ("short", "long")}
    return Template((HERE / "figure.gp").read_text(encoding="utf-8")).substitute(
        style=drawing.begin(image, 1000, 500), data="\n".join(data), steps=", \\\n  ".join(steps),
        growth=", \\\n  ".join(growth), short=f"{lengths['short']:g}", long=f"{lengths['long']:g}",
        low=f"{decade(min(shown), 0):g}", high=f"{decade(max(shown), 1):g}", widest=f"{1.25 * lengths['long']:g}",
        growth_low=f"{decade(min(sizes), 0):g}",
        growth_high=f"{decade(max(sizes), 2):g}")  # with room for the key


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
