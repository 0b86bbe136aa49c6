# SPDX-License-Identifier: MIT
"""Figures of the benchmarks, in the style of those of the program and with the same colours and markers of schemes (data/plots).
A gnuplot script is stored with its image, so that the figure can be changed."""

import shutil
import subprocess
import tomllib
from pathlib import Path
from typing import NamedTuple

PLOTS = Path(__file__).resolve().parents[1] / "data/plots"
# For lines that are not schemes.
PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")


class Style(NamedTuple):
    colour: str
    filled: int  # point types of gnuplot
    open: int


def styles(schemes):
    """Styles of the schemes of a figure: those of data/plots/schemes.toml, or for schemes that it does not name, as nested ones,
    its other styles in this order."""
    table = tomllib.loads((PLOTS / "schemes.toml").read_text(encoding="utf-8"))
    unnamed = [scheme for scheme in schemes if scheme not in table["schemes"]]
    entry = {scheme: table["other"][k % len(table["other"])] for k, scheme in enumerate(unnamed)} | table["schemes"]
    return {s: Style(entry[s]["colour"], *table["markers"][entry[s]["marker"]]) for s in schemes}


def begin(image, width, height):
    """What every script begins with."""
    return "\n".join([f"# Restyle this and run it again: gnuplot draws {image.name}.", f'image = "{image.name}"',
                      f'format = "{image.suffix[1:]}"', f"width = {width}", f"height = {height}",
                      (PLOTS / "style.gp").read_text(encoding="utf-8")])


def key(entries, bottom, columns=3):
    """Lines of a multiplot that draw the legend alone, across the figure, above `bottom` (a fraction of its height), in columns. What
    follows sets its own ranges and margins."""
    return "\n".join([
        "set lmargin at screen 0.02", "set rmargin at screen 0.98", f"set bmargin at screen {bottom}", "set tmargin at screen 0.99",
        "unset border", "unset grid", 'set tics scale 0', 'set format ""', "set xrange [0:1]", "set yrange [0:1]",
        f"set key inside center center horizontal maxcols {columns} font small", "plot NaN notitle, \\\n  " + ", \\\n  ".join(f"keyentry {e}" for e in entries),
        "unset key", 'set format "%g"', (PLOTS / "style.gp").read_text(encoding="utf-8").split("set output image\n")[1]])


def draw(script, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    stored = image.with_suffix(".gp")
    stored.write_text(script, encoding="utf-8")
    if not shutil.which("gnuplot"):
        print(f"no gnuplot on PATH, so no figure; its script is {stored}")
        return
    subprocess.run(["gnuplot", stored.name], cwd=image.resolve().parent, check=True)
