# SPDX-License-Identifier: MIT
"""The figure of the benchmark: seconds per nanosecond against the required R, a panel for each size and number of threads, drawn by
gnuplot."""

import json
import sys
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent
KEY, PANEL, CAVEAT = 60, 380, 40  # heights [pixel]
PEERS = ("#404040", "#707070", "#9a9a9a", "#c0c0c0", "#585858", "#868686", "#aeaeae", "#d4d4d4")  # schemes have the colours
MARKERS = (4, 6, 8, 10, 12, 14)  # of peers: open ones


def panels(result):
    """(molecules, threads) of each panel, in the order they were measured."""
    return list(dict.fromkeys((r["molecules"], r["threads"]) for r in result["costs"]))


def looks(names):
    """Colour and point type of each engine: of its scheme for polhode, grey and open for other programs."""
    ours = drawing.styles([n.removeprefix("polhode ") for n in names if n.startswith("polhode ")])
    peers = [n for n in names if not n.startswith("polhode ")]
    grey = {n: (PEERS[k % len(PEERS)], MARKERS[k % len(MARKERS)]) for k, n in enumerate(peers)}
    return {n: grey.get(n) or ours[n.removeprefix("polhode ")][:2] for n in names}


def block(result, panel, engine):
    """Rows of R [%] and seconds per nanosecond, where R is reached."""
    rows = [r for r in result["costs"] if (r["molecules"], r["threads"]) == panel and r["engine"] == engine and r["seconds_per_ns"]]
    return "\n".join(f"{r['R_percent']:g} {r['seconds_per_ns']:.6g}" for r in rows) or "NaN NaN"


def absent(result, panel):
    """The engines that do not reach an R, as a text."""
    return "; ".join(f"{r['engine']} does not reach {r['R_percent']:g} %" for r in result["costs"]
                     if (r["molecules"], r["threads"]) == panel and not r["seconds_per_ns"])


def margins(width, height, across, i):
    """Screen margins of panel i, of PANEL pixels with room for its title and axes."""
    column, row = i % across, i // across
    left, top = column * width / across, KEY + row * PANEL
    sides = {"l": (left + 80) / width, "r": (left + width / across - 10) / width,
             "t": 1 - (top + 40) / height, "b": 1 - (top + PANEL - 50) / height}
    return "".join(f"set {side}margin at screen {place:.4f}\n" for side, place in sides.items())


def caveat(result, names):
    """The builds that are compared, since a build for another instruction set has another speed."""
    versions = result.get("versions", {})
    builds = [f"{n} {versions[n]}" for n in names if n in versions and not n.startswith("polhode")]
    return "Builds as distributed; others are faster or slower: " + "; ".join(builds) if builds else ""


def script(result, image):
    """The gnuplot script: a strip with the key, then a panel for each size and number of threads."""
    names = list(dict.fromkeys(r["engine"] for r in result["costs"]))
    shown, style = panels(result), looks(names)
    across = 2 if len(shown) > 1 else 1
    width, height = 1020 if across == 2 else 860, PANEL * -(-len(shown) // across) + KEY + CAVEAT
    values = [r["seconds_per_ns"] for r in result["costs"] if r["seconds_per_ns"]]
    targets = sorted({r["R_percent"] for r in result["costs"]})
    data, plots = [], []
    for i, panel in enumerate(shown):
        data += [f"$panel{i}_{k} << EOD\n{block(result, panel, name)}\nEOD" for k, name in enumerate(names)]
        molecules, threads = panel
        plots.append(f'{margins(width, height, across, i)}set title "{molecules} molecules, {threads} thread{"s" * (threads > 1)}"\n'
                     f'set label 1001 "{absent(result, panel)}" at graph 0.02, graph 0.04 left noenhanced textcolor rgb ink font small\n'
                     "plot " + ", \\\n  ".join(f"$panel{i}_{k} using 1:2 with {look(*style[n])} notitle" for k, n in enumerate(names)))
    return Template((HERE / "figure.gp").read_text(encoding="utf-8")).substitute(
        style=drawing.begin(image, width, height), caveat=caveat(result, names), data="\n".join(data), plots="\n".join(plots),
        key=drawing.key([f'with {look(*style[n])} title "{n}"' for n in names], f"{1 - KEY / height:.4f}", 3),
        targets=", ".join(f"{t:g}" for t in targets), loosest=f"{1.6 * targets[-1]:g}", strictest=f"{targets[0] / 1.6:g}",
        low=f"{0.6 * min(values):g}", high=f"{1.6 * max(values):g}")


def look(colour, mark):
    return f'linespoints linewidth 1.4 pointsize 1.1 pointtype {mark} linecolor "{colour}"'


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":  # figure.py RESULT.json IMAGE: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
