# SPDX-License-Identifier: MIT
"""Figures made with matplotlib, in the colours of the documents."""

from .errors import Error

# Colours of the schemes of the paper, as in data/plots/schemes.toml, and a sequence of colours for all other schemes.
COLOURS = {"velocity-verlet": "#0072b2", "hoa2": "#d55e00", "gier4": "#009e73",
           "gier4-fd": "#009e73", "bcss3": "#cc79a7"}
OTHERS = ("#e69f00", "#56b4e9", "#999999", "#f0e442", "#000000")


def _axes(ax, count=1, **options):
    """The Axes on which to draw."""
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise Error("figures need matplotlib, which is not installed; pip install matplotlib") \
            from None
    return ax if ax is not None else plt.subplots(count, 1, layout="constrained", **options)[1]


def plot_energies(energies, ax=None):
    """Plots the total energy about its mean, and the potential energy, against time."""
    axes = _axes(ax, 2, sharex=True, figsize=(6, 4.5))
    time = energies["time"]
    axes[0].plot(time, energies["conserved"] - energies["conserved"].mean(), color="#d55e00", lw=0.8)
    axes[0].set_ylabel("$E - \\langle E\\rangle$ [kJ/mol]")
    axes[1].plot(time, energies["potential"], color="#0072b2", lw=0.8)
    axes[1].set_ylabel("$V$ [kJ/mol]")
    axes[1].set_xlabel("time [ps]")
    if len(energies) >= 3 and energies.conserves:
        axes[0].set_title(f"R = {100 * energies.ratio:.3g} %", fontsize="medium")
    return axes


def _plot_study(report, ax):
    """Plots R against cost, with standard errors."""
    ax = _axes(ax, figsize=(6, 4.5))
    points = report.data["points"]
    names = list(dict.fromkeys(p["scheme"] for p in points))
    for k, name in enumerate(names):
        mine = [p for p in points if p["scheme"] == name and p.get("stable", True) and p.get("R")]
        ax.errorbar([p["force_evaluations_per_ps"] for p in mine], [100 * p["R"] for p in mine],
                    yerr=[100 * (p.get("R_error") or 0) for p in mine], marker="o", ms=4, capsize=2,
                    color=COLOURS.get(name, OTHERS[k % len(OTHERS)]), label=name)
    ax.set(xscale="log", yscale="log", xlabel="force evaluations per ps", ylabel="R [%]")
    ax.legend()
    return ax


def plot_report(report, ax=None):
    """The figure of a report."""
    if report.job == "study" and "points" in report.data:
        if not any("R" in point for point in report.data["points"]):
            raise Error("plot() draws R, which a study with the ensemble nvt does not have; such a study writes its figure as PREFIX.svg")
        return _plot_study(report, ax)
    raise Error(f"a report of {report.job} has no figure; study and Simulation.run() have one")
