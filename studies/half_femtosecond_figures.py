# SPDX-License-Identifier: MIT
"""Figures of the time-step bias: biases against cost for all schemes, and density against temperature."""

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


def looks(names):
    """The style of each curve. If a scheme has two steps, the shorter one has open markers and a dashed line."""
    scheme, step = (lambda name: name.split(",")[0]), (lambda name: float(name.split(", ")[1].split()[0]))
    style = figures.styles(dict.fromkeys(map(scheme, names)))
    short = {n for n in names if any(scheme(m) == scheme(n) and step(m) > step(n) for m in names)}
    return {n: (style[scheme(n)].of(open=n in short), "--" if n in short else "-") for n in names}


def density(points):
    """Draws two panels. Points with error bars are measured, lines are predicted. The upper panel has the measured densities; its lines are
    the limit of short steps and its sum with the predicted biases. The lower panel has the same densities minus the limit."""
    (_, predictions), biases, measured = tables.maxima_of(points), tables.density_biases(points), tables.measured_densities(points)
    style = {tables.LIMIT: (figures.Style(figures.INK, "o").of(), ":"), **looks(list(measured))}
    limit = predictions[tables.LIMIT].fit
    figure, ((above,), (below,)) = figures.panels(1, 2, size=(7.6, 7.6), sharex=True, height_ratios=(3, 2))
    T = np.linspace(*limit.domain, 200)
    for k, (name, rows) in enumerate(measured.items()):
        look, _ = style[name]
        at, value, error = map(np.array, zip(*rows))
        shifted = at + 0.5 * (k - (len(measured) - 1) / 2)  # so that the points of a temperature do not cover each other
        above.errorbar(shifted, value, error, linestyle="none", label=f"{name}, measured", **look)
        below.errorbar(shifted, value - limit(at), error, linestyle="none", **look)
    for name, prediction in predictions.items():
        look, line = style[name]
        above.plot(T, prediction.fit(T), color=look["color"], linestyle=line, label=name if name == tables.LIMIT else f"{name}, predicted")
        if name in biases:
            below.plot(T, tables.bias_fit(*list(zip(*biases[name]))[:2])(T), color=look["color"], linestyle=line)
    above.set(ylabel="density  (kg/m³)")
    below.set(xlabel="temperature  (K)", ylabel="density minus limit  (kg/m³)")
    below.axhline(0, color=figures.INK, linewidth=1, linestyle=":")
    figures.legend(figure, above, 2)
    return figure


def draw(points, folder):
    folder.mkdir(parents=True, exist_ok=True)
    energy = {p: runs for p, runs in points.items() if p.group in ("energy", "quick")}
    pressure = {p: runs for p, runs in points.items() if p.ensemble == "constant pressure"}
    if energy:
        figures.save(bias(energy), folder / "bias.svg")
    if len({p.temperature for p in pressure}) > 3:
        figures.save(density(pressure), folder / "density.svg")
