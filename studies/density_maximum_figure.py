# SPDX-License-Identifier: MIT
"""The figure of the density maximum: densities against temperature, and the maximum against the time step."""

import density_maximum_tables as tables
import numpy as np
from lib import figures
from lib.statistics import mean


def draw(lines, path):
    """Left: the limit of short steps as points, a cubic through them, and curves of velocity Verlet with vertical lines at their maxima.
    Right: the maximum against the step, with the published ones."""
    of = tables.by_temperature(lines)
    curves = tables.resampled(of, draws=500)
    figure, ((left, right),) = figures.panels(2, size=(9.6, 4.6))
    T, look = np.linspace(min(of), max(of), 200), figures.styles(["velocity-verlet"])["velocity-verlet"]
    points = {t: mean(tables.limits(runs)[0]) for t, runs in of.items()}
    left.errorbar(list(points), *zip(*points.values()), linestyle="none", color=figures.INK, marker="o", label="limit of short steps")
    for step, line in ((0, ":"), (2, "--"), (4, "-")):
        colour, top = look.color if step else figures.INK, curves.maximum(step)[0]
        left.plot(T, curves.whole.of(step)(T), color=colour, linestyle=line, label=f"velocity Verlet, {step} fs, predicted" if step else None)
        left.axvline(top, color=colour, linestyle=line, linewidth=0.8)
    left.set(xlabel="temperature  (K)", ylabel="density at 1 bar  (kg/m³)")
    steps = np.linspace(0, 4, 17)
    middle, error = np.array([curves.maximum(h)[:2] for h in steps]).T
    right.fill_between(steps, middle - error, middle + error, color=look.color, alpha=0.25, linewidth=0)
    right.plot(steps, middle, color=look.color, label="velocity Verlet, predicted")
    right.plot(list(tables.PUBLISHED), list(tables.PUBLISHED.values()), linestyle="none", marker="D", color=figures.PALETTE[1], label="published")
    right.set(xlabel="time step  (fs)", ylabel="temperature of maximum density  (K)")
    handles = [one for ax in (left, right) for one in zip(*ax.get_legend_handles_labels())]
    unique = {name: handle for handle, name in handles}
    figures.legend(figure, left, 3, (list(unique.values()), list(unique)))
    figures.save(figure, path)
