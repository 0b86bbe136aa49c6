# SPDX-License-Identifier: MIT
"""The dependence of dynamics on the accuracy of the integration. Diffusion, relaxation times and temperatures of liquid
TIP4P are measured with schemes and time steps of very different R, from the same initial configurations."""

from statistics import fmean

from lib import runs, study
from lib.statistics import estimate, text

POINTS = ["velocity-verlet 1", "velocity-verlet 2", "velocity-verlet 3", "velocity-verlet 4", "velocity-verlet 5", "hoa2 4", "hoa2 6", "gier4 3"]
QUANTITIES = {  # in the reports of run and analyze
    "D": lambda run, said: runs.number(said["parts"][0]["D_1e-9_m2_per_s"]),
    "tau": lambda run, said: runs.number(said["parts"][0]["relaxation"]["dipole"]["P2"].get("exponential_ps", runs.UNKNOWN)),
    "T": lambda run, said: run["temperature_K"],
    "T_translation": lambda run, said: run["temperature_translation_K"],
    "T_rotation": lambda run, said: fmean(run["temperature_rotation_K"]),
    "potential": lambda run, said: run["potential_kJ_per_mol"],
    "R": lambda run, said: run["R"],
}
COLUMNS = [("D", "D [1e-9 m²/s]", 2), ("tau", "τ₂ of the dipole [ps]", 2), ("T_translation", "T of translation [K]", 1),
           ("T_rotation", "T of rotation [K]", 1), ("potential", "potential energy [kJ/mol]", 3)]


def tables(o, name, place, scheme, step, seed, **more):
    return {"system": {"molecules": runs.molecules("tip4p", o.count), **place, "temperature": "298.15 K", "seed": seed},
            "forces": {"cutoff": f"{o.cutoff} nm", "precision": "mixed"}, "integrator": {"scheme": scheme, "step": f"{step:g} fs"},
            "run": more, "output": {"prefix": name, **runs.QUIET}}


def initial(o, folder, seed):
    """Prepares a liquid at 298 K: a lattice is melted with velocity rescaling, followed by 1 ps at constant energy."""
    name = f"start-{seed}"
    runs.kept(folder, name, lambda: runs.run(o, tables(o, name, {"density": "0.997 g/cm3"}, "hoa2", 2, seed, equilibrate=f"{o.equilibrate:g} ps",
                                                       length="1 ps", sample="20 fs"), folder, name=name))
    return {"initial_configuration": f"{name}-final.gro"}


def one(o, folder, scheme, step, seed):
    """{quantity: value} of one run; its frames are deleted."""
    name = f"{scheme}-{step:g}-{seed}"
    whole = lambda fs: f"{step * max(1, round(fs / step)):g} fs"  # so that all steps have the same sampling interval

    def made():
        run_tables = tables(o, name, initial(o, folder, seed), scheme, step, seed, length=f"{o.length:g} ps", sample=whole(12))
        run_tables["output"] |= {"trajectory_every": whole(120), "formats": ["trr"]}
        report = runs.run(o, run_tables, folder, name=name)
        frames = f"{name}-trajectory.trr"
        said = runs.asked(o, "analyze", frames, "--run", f"{name}.toml", "--what", "msd,rotation", "--window", f"{o.window:g} ps", "--plot", "none",
                          "--threads", 1, "--output", name, "--force", folder=folder)
        (runs.Path(folder) / frames).unlink()
        return {q: value(report, said) for q, value in QUANTITIES.items()}

    run = runs.kept(folder, f"{name}-values", made)
    return {**run, "excess": run["T_rotation"] - run["T_translation"]}


def measured(o):
    points = [(scheme, float(step)) for scheme, step in (p.split() for p in o.points)]
    with runs.scratch(o) as folder:
        for seed in range(1, o.runs + 1):
            initial(o, folder, seed)
        cases = [(seed, p) for seed in range(1, o.runs + 1) for p in points]
        found = dict(zip(cases, runs.parallel(o, lambda case: one(o, folder, *case[1], case[0]), cases)))
    of = {p: [found[seed, p] for seed in range(1, o.runs + 1)] for p in points}
    exact = of[min(points, key=lambda p: fmean(r["R"] for r in of[p]))]
    # From each run, the most accurate run from the same initial configuration is subtracted, which cancels the scatter of
    # configurations.
    return {"waters": o.count, "length_ps": o.length, "points": [
        {"scheme": p[0], "step_fs": p[1], "runs": o.runs, **{q: estimate([r[q] for r in of[p]]) for q in exact[0]},
         "differences": {q: estimate([r[q] - best[q] for r, best in zip(of[p], exact)]) for q in exact[0]}} for p in points]}


def report(result):
    """Two tables in Markdown: means, and their differences from the most accurate scheme and step."""
    parts = []
    for more, of in (("", lambda p: p), (", less that of the most accurate", lambda p: p["differences"])):
        parts.append(study.table(["scheme", "step [fs]", "R [%]", *(name + more for _, name, _ in COLUMNS)],
                                 [[p["scheme"], f"{p['step_fs']:g}", f"{100 * p['R']['value']:.3g}",
                                   *(text((of(p)[q]["value"], of(p)[q]["error"]), d) for q, _, d in COLUMNS)] for p in result["points"]]))
    return "\n".join(parts)


def draw(result):
    """Plots diffusion, relaxation time and temperatures against R."""
    from lib import figures
    looks = figures.styles(list(dict.fromkeys(p["scheme"] for p in result["points"])))
    percent = lambda q: lambda p: [100 * p["differences"][q][part] / p[q]["value"] for part in ("value", "error")]
    panels = (("diffusion coefficient, difference  (%)", percent("D")), ("relaxation time of the dipole, difference  (%)", percent("tau")),
              ("T of rotation less T of translation  (K)", lambda p: [p["excess"][part] for part in ("value", "error")]))
    figure, (axes,) = figures.panels(3, size=(10, 4.2))
    for ax, (title, of) in zip(axes, panels):
        for scheme, look in looks.items():
            rows = [(100 * p["R"]["value"], *of(p)) for p in result["points"] if p["scheme"] == scheme]
            ax.errorbar(*zip(*rows), linestyle="none", label=scheme, **look.of())
        ax.axhline(0, color=figures.INK, linewidth=0.8)
        ax.set(xscale="log", xlabel="R  (%)", title=title)
        ax.title.set_fontsize(10)
        figures.plain_ticks(ax.xaxis, (0.01, 0.1, 1, 10))
        ax.margins(x=0.1, y=0.12)
    figure.supxlabel(f"{result['waters']} TIP4P waters, runs of {result['length_ps']:g} ps. Differences from the most accurate run, from the same "
                     "configurations; bars are one standard error.", fontsize=10)
    figures.legend(figure, axes[0], 5)
    return figure


if __name__ == "__main__":
    o = study.options(__doc__, {"runs": 2, "count": 64, "cutoff": 0.55, "length": 3.0, "equilibrate": 0.5, "window": 0.5, "points": ["velocity-verlet 4", "hoa2 4"]},
                      runs=(6, "runs of each scheme and step, each from another initial configuration"), count=(512, "waters"),
                      cutoff=(0.9, "cutoff [nm]"), length=(100.0, "length of a run at constant energy [ps]"),
                      equilibrate=(20.0, "equilibration of an initial configuration [ps]"), window=(10.0, "maximum lag of correlations [ps]"),
                      points=(POINTS, "schemes with their time steps [fs]"))
    study.perform(o, measured, report, draw)
