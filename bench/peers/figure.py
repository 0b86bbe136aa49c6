# SPDX-License-Identifier: MIT
"""The picture of a benchmark: bars of seconds for a nanosecond at each R, program by program, drawn by gnuplot."""

import json
import shutil
import subprocess
import sys
from math import floor, log10
from pathlib import Path
from string import Template

HERE = Path(__file__).resolve().parent
# Okabe and Ito's colours, as in all figures here: one hue for ours, others for the peers.
OURS = ("#0072B2", "#56B4E9", "#9AD0F0")
GAP = 1.5  # bars between clusters
KEY = 100  # height of the key and of the first title
PEERS = ("#D55E00", "#009E73", "#E69F00", "#CC79A7", "#000000", "#8C510A", "#7F7F7F", "#B2ABD2")


def panels(result):
    """(molecules, threads) of each panel, in the order they were measured."""
    return list(dict.fromkeys((r["molecules"], r["threads"]) for r in result["costs"]))


def block(result, panel, names):
    """Rows of R, columns of engines; ? where R is not reached."""
    rows = [r for r in result["costs"] if (r["molecules"], r["threads"]) == panel]
    lines = []
    for target in dict.fromkeys(r["R_percent"] for r in rows):
        cells = {r["engine"]: r["seconds_per_ns"] for r in rows if r["R_percent"] == target}
        lines.append(f'"R = {target:g} %" ' + " ".join(f"{cells[n]:.6g}" if cells.get(n) else "?" for n in names))
    return "\n".join(lines)


def absent(result, panel, names):
    """Labels where a bar is missing, in gnuplot's clusters with a gap of GAP bars."""
    rows = [r for r in result["costs"] if (r["molecules"], r["threads"]) == panel and not r["seconds_per_ns"]]
    targets = list(dict.fromkeys(r["R_percent"] for r in result["costs"]))
    places = [targets.index(r["R_percent"]) + (names.index(r["engine"]) - (len(names) - 1) / 2) / (len(names) + GAP)
              for r in rows]
    return "unset label\n" + "".join(
        f'set label "not reached" at first {x:.4f}, graph 0.02 rotate left textcolor "#808080"\n' for x in places)


def script(result, image):
    """The gnuplot script."""
    names = list(dict.fromkeys(r["engine"] for r in result["costs"]))
    shown = panels(result)
    ours, peers = iter(OURS), iter(PEERS)
    colours = [next(ours if n.startswith("polhode") else peers) for n in names]
    across = 2 if len(shown) > 1 else 1
    down = -(-len(shown) // across)
    values = [r["seconds_per_ns"] for r in result["costs"] if r["seconds_per_ns"]]
    data, plots = [], []
    for i, panel in enumerate(shown):
        data.append(f"$panel{i} << EOD\n{block(result, panel, names)}\nEOD")
        molecules, threads = panel
        plots.append(absent(result, panel, names) + f'set title "{molecules} molecules, {threads} thread{"s" * (threads > 1)}"\n'
                     + ("set key at screen 0.5, screen 0.985 center top horizontal Left reverse maxcols 4 width 2\n" if i == 0
                        else "unset key\n")
                     + "plot " + ", \\\n  ".join(
                         f'$panel{i} using {k + 2}{":xtic(1)" if k == 0 else ""} with histogram '
                         f'linecolor "{c}" title "{n}"' for k, (n, c) in enumerate(zip(names, colours))))
    width, height = (940 if across == 2 else 640), 320 * down + KEY
    svg = image.suffix != ".png"
    terminal = (f'svg size {width},{height} dynamic enhanced font "Helvetica,14" background "white"' if svg else
                f'pngcairo size {2 * width},{2 * height} fontscale 2 linewidth 2 enhanced font "Helvetica,11" '
                'background "white"')
    return Template((HERE / "figure.gp").read_text(encoding="utf-8")).substitute(
        image=image.name, terminal=terminal, data="\n".join(data), plots="\n".join(plots), down=down, across=across, gap=GAP,
        left=f"{80 / width:.3f}", between=f"{90 / width:.3f}", base=f"{30 / height:.3f}",
        top=f"{1 - KEY / height:.3f}", above=f"{70 / height:.3f}", low=f"{10 ** floor(log10(min(values))):g}", high=f"{2 * max(values):g}")


def draw(result, image):
    """Writes the script beside the image and runs gnuplot on it."""
    text = script(result, image)
    image.with_suffix(".gp").write_text(text, encoding="utf-8")
    if not shutil.which("gnuplot"):
        print(f"no gnuplot on PATH, so no figure; its script is {image.with_suffix('.gp')}")
        return
    subprocess.run(["gnuplot", image.with_suffix(".gp").name], cwd=image.resolve().parent, check=True)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: draws kept numbers again
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
