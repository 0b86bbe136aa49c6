# SPDX-License-Identifier: MIT
"""Figures by matplotlib, with the colours and markers of schemes of data/plots/schemes.toml."""

import tomllib
import warnings
from typing import NamedTuple

warnings.filterwarnings("ignore", message="Unable to import Axes3D")  # the system has another matplotlib
import matplotlib  # noqa: E402

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

from .study import ROOT  # noqa: E402

PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")  # of lines that are not schemes
INK = "#404040"
MARKERS = {"circle": "o", "square": "s", "triangle": "^", "inverted": "v", "diamond": "D", "pentagon": "p"}
matplotlib.rcParams.update({
    "font.family": "sans-serif", "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans"], "font.size": 11, "svg.fonttype": "none",
    "svg.hashsalt": "polhode", "text.color": INK, "axes.edgecolor": INK, "axes.labelcolor": INK, "axes.titlesize": 11,
    "axes.spines.top": False, "axes.spines.right": False, "xtick.color": INK, "ytick.color": INK, "axes.grid": True,
    "axes.axisbelow": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6, "legend.frameon": False, "legend.fontsize": 10,
    "lines.linewidth": 1.5, "lines.markersize": 5.5, "errorbar.capsize": 0, "savefig.dpi": 200})


class Style(NamedTuple):
    """Colour and marker of a scheme."""
    color: str
    marker: str

    def of(self, **more):
        """Arguments of plot(); open=True draws an open marker."""
        is_open = more.pop("open", False)
        return {**self._asdict(), **({"markerfacecolor": "white"} if is_open else {}), **more}


def styles(schemes):
    """Styles of the schemes of a figure: those of data/plots/schemes.toml, or for schemes that it does not name, as nested ones,
    its other styles in this order."""
    table = tomllib.loads((ROOT / "data/plots/schemes.toml").read_text(encoding="utf-8"))
    unnamed = [scheme for scheme in schemes if scheme not in table["schemes"]]
    entry = {scheme: table["other"][k % len(table["other"])] for k, scheme in enumerate(unnamed)} | table["schemes"]
    return {s: Style(entry[s]["colour"], MARKERS[entry[s]["marker"]]) for s in schemes}


def panels(columns, rows=1, size=(9.6, 5), **more):
    """A figure and its axes; size in inches of 100 pixels."""
    return plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False, **more)


def legend(figure, axes, columns, entries=None):
    """One legend above all panels."""
    handles, names = entries or axes.get_legend_handles_labels()
    unique = dict(zip(names, handles))
    figure.legend(unique.values(), unique.keys(), loc="outside upper center", ncols=columns)


def plain_ticks(axis, ticks):
    """Ticks of a logarithmic axis, as numbers without powers."""
    axis.set_ticks(ticks, [f"{t:g}" for t in ticks])
    axis.set_ticks([], minor=True)


def save(figure, path):
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None)
    plt.close(figure)
