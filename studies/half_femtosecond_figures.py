# SPDX-License-Identifier: MIT
"""Figures of the time-step bias: biases against cost for all schemes, and density against temperature."""

import half_femtosecond_tables as tables
import numpy as np
from lib import figures
from lib.statistics import inf, text

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


def looks(names):
    """The style of each curve. If a scheme has two steps, the shorter one has open markers and a dashed line."""
    scheme, step = (lambda name: name.split(",")[0]), (lambda name: float(name.split(", ")[1].split()[0]))
    style = figures.styles(dict.fromkeys(map(scheme, names)))
    short = {n for n in names if any(scheme(m) == scheme(n) and step(m) > step(n) for m in names)}
    return {n: (style[scheme(n)].of(open=n in short), "--" if n in short else "-") for n in names}


def density(points):
    """Draws two panels. The upper panel has densities without a time-step bias and of schemes without a prediction, with cubics, and the
    predicted densities of the other schemes. The lower panel has the predicted biases, with parabolas."""
    maxima, own, biases = tables.maxima_of(points), tables.own_densities(points), tables.density_biases(points)
    style = {tables.LIMIT: (figures.Style(figures.INK, "o").of(), "-"), **looks([n for n in maxima if n != tables.LIMIT])}
    limit = tables.limit_densities(points)
    measured = {tables.LIMIT: limit, **{n: own[n] for n in maxima if n in own}}
    T = np.linspace(limit[0][0], limit[-1][0], 200)
    figure, ((above,), (below,)) = figures.panels(1, 2, size=(7.6, 7.6), sharex=True, height_ratios=(3, 2))
    marks = lambda ax, n, rows: ax.errorbar(*zip(*rows), linestyle="none", **style[n][0])
    for n, m in maxima.items():
        look, line = style[n]
        above.plot(T, m.fit(T), color=look["color"], linestyle=line)
        above.plot([], [], linestyle=line, label=f"{n}: maximum at {text(m.place, 1)} K", **look)
        if n in measured:
            marks(above, n, measured[n])
        elif n in biases:
            below.plot(T, tables.bias_fit(*list(zip(*biases[n]))[:2])(T), color=look["color"], linestyle=line)
            marks(below, n, biases[n])
    above.set(ylabel="density  (kg/m³)")
    below.set(xlabel="temperature  (K)", ylabel="time-step bias  (kg/m³)")
    below.axhline(0, color=figures.INK, linewidth=1)
    figures.legend(figure, above, 1)
    return figure


def draw(points, folder):
    folder.mkdir(parents=True, exist_ok=True)
    energy = {p: runs for p, runs in points.items() if p.group in ("energy", "quick")}
    pressure = {p: runs for p, runs in points.items() if p.ensemble == "constant pressure"}
    if energy:
        figures.save(bias(energy), folder / "bias.svg")
    if len({p.temperature for p in pressure}) > 3:
        figures.save(density(pressure), folder / "density.svg")
