# SPDX-License-Identifier: MIT
"""The figure of the time-step bias: biases against cost for all schemes."""

import half_femtosecond_tables as tables
import numpy as np
from lib import figures
from lib.statistics import inf

PANELS = {"difference": "|T$_{\\rm rot}$ − T$_{\\rm trans}$|, time-step bias  (K)", "potential": "|potential energy|, time-step bias  (kJ/mol)"}


def bias(points):
    """Draws two panels: the bias that runs at constant energy predict, against force evaluations per ps, with the required bias."""
    figure, (axes,) = figures.panels(2, size=(9.6, 5.2))
    style = figures.styles(dict.fromkeys(p.scheme for p in points))
    for ax, (name, label) in zip(axes, PANELS.items()):
        for scheme, look in style.items():
            rows = [(tables.cost(p), *tables.of_runs(runs, tables.predicted(name))) for p, runs in points.items() if p.scheme == scheme]
            x, y, error = map(np.abs, zip(*rows))
            error = np.where(error < inf, error, 0)
            ax.errorbar(x, y, [np.minimum(error, 0.9 * y), error], label=scheme, **look.of())
        bound, unit = tables.REQUIRED[name]
        ax.axhline(bound, color=figures.INK, linewidth=1, linestyle=":")
        ax.text(0.02, 0.85 * bound, f"{bound:g} {unit}", transform=ax.get_yaxis_transform(), fontsize=10, va="top")
        ax.set(xscale="log", yscale="log", xlim=(150, 3000), xlabel="force evaluations per ps", ylabel=label)
        figures.plain_ticks(ax.xaxis, (200, 500, 1000, 2000))
    figures.legend(figure, axes[0], 5)
    return figure


def draw(points, folder):
    folder.mkdir(parents=True, exist_ok=True)
    energy = {p: runs for p, runs in points.items() if p.group in ("energy", "quick")}
    if energy:
        figures.save(bias(energy), folder / "bias.svg")
