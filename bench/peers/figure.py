# SPDX-License-Identifier: MIT
"""The figure of the benchmark: bars of seconds per nanosecond at each R, program by program, drawn by gnuplot."""

import json
import sys
from math import floor, log10
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent
GAP = 1.5  # bars between clusters
KEY, PANEL, CAVEAT = 60, 320, 30  # heights [pixel]
PEERS = ("#404040", "#707070", "#9a9a9a", "#c0c0c0", "#585858", "#868686", "#aeaeae", "#d4d4d4")  # schemes have the colours


def panels(result):
    """(molecules, threads) of each panel, in the order they were measured."""
    return list(dict.fromkeys((r["molecules"], r["threads"]) for r in result["costs"]))


def block(result, panel, names):
    """Rows of R, columns of engines; ? if R is not reached."""
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


def margins(width, height, across, i):
    """Screen margins of panel i, of PANEL pixels with room for its title and axes."""
    column, row = i % across, i // across
    left, top = column * width / across, KEY + row * PANEL
    sides = {"l": (left + 80) / width, "r": (left + width / across - 10) / width,
             "t": 1 - (top + 40) / height, "b": 1 - (top + PANEL - 30) / height}
    return "".join(f"set {side}margin at screen {place:.4f}\n" for side, place in sides.items())


def caveat(result, names):
    """The builds that are compared, since a build for another instruction set has another speed."""
    versions = result.get("versions", {})
    builds = [f"{n} {versions[n]}" for n in names if n in versions and not n.startswith("polhode")]
    return "Builds as distributed; others are faster or slower: " + "; ".join(builds) if builds else ""


def script(result, image):
    """The gnuplot script: a strip with the key, then a panel for each size and number of threads."""
    names = list(dict.fromkeys(r["engine"] for r in result["costs"]))
    shown = panels(result)
    ours = drawing.styles([n.removeprefix("polhode ") for n in names if n.startswith("polhode ")])
    peers = iter(PEERS)
    colours = [ours[n.removeprefix("polhode ")].colour if n.startswith("polhode ") else next(peers) for n in names]
    across = 2 if len(shown) > 1 else 1
    width, height = 1020 if across == 2 else 940, PANEL * -(-len(shown) // across) + KEY + CAVEAT
    values = [r["seconds_per_ns"] for r in result["costs"] if r["seconds_per_ns"]]
    data, plots = [], []
    for i, panel in enumerate(shown):
        data.append(f"$panel{i} << EOD\n{block(result, panel, names)}\nEOD")
        molecules, threads = panel
        bars = [f'$panel{i} using {k + 2}{":xtic(1)" if k == 0 else ""} with histogram linecolor "{c}"'
                for k, c in enumerate(colours)]
        plots.append(f'{margins(width, height, across, i)}{absent(result, panel, names)}'
                     f'set title "{molecules} molecules, {threads} thread{"s" * (threads > 1)}"\n'
                     "plot " + ", \\\n  ".join(bars))
    key = [f'NaN with boxes linecolor "{c}" title "{n}"' for n, c in zip(names, colours)]
    return Template((HERE / "figure.gp").read_text(encoding="utf-8")).substitute(
        style=drawing.begin(image, width, height), caveat=caveat(result, names), data="\n".join(data), plots="\n".join(plots),
        key=", \\\n  ".join(key), strip=f"{1 - KEY / height:.4f}", gap=GAP,
        low=f"{10 ** floor(log10(min(values))):g}", high=f"{2 * max(values):g}")


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
