# SPDX-License-Identifier: MIT
"""Diffusion, reorientation and dielectric constant of SPC/E and TIP4P/2005 at 298 K, by `polhode analyze` of runs at
constant energy with PME; values are means over independent runs, errors from their scatter."""

from pathlib import Path

from lib import runs, study, waters
from lib.statistics import mean, text


def quantities(run):
    """{name: value} of one run."""
    part = run["parts"][0]
    found = {"T [K]": run["temperature_K"]["value"], "D in the box [1e-9 m2/s]": runs.number(part["D_1e-9_m2_per_s"])}
    if "D_without_images_1e-9_m2_per_s" in part:
        found["D without images [1e-9 m2/s]"] = runs.number(part["D_without_images_1e-9_m2_per_s"])
    for axis, ranks in part["relaxation"].items():
        for rank, times in ranks.items():
            if "integral_ps" in times:
                found |= {f"tau {rank} {axis}, {kind} [ps]": runs.number(times[f"{kind}_ps"]) for kind in ("integral", "exponential")}
    return found | {"dielectric constant": runs.number(run["dielectric"]["constant"])}


def measured(o):
    def one(case):
        prefix, _ = waters.made(o, folder, *case, waters.TEMPERATURE)
        said = waters.analyzed(o, folder, prefix, "--window", f"{o.window:g} ps", "--fit", f"{o.window / 10:g} ps, {o.window:g} ps",
                               "--what", "rdf,msd,rotation,dielectric,density")
        Path(folder, f"{prefix}-trajectory.trr").unlink(missing_ok=True)  # large
        return {"water": case[0].name, "seed": case[1], "values": quantities(said)}

    with runs.scratch(o) as folder:
        return {"runs": runs.parallel(o, one, [(w, seed) for seed in range(1, o.runs + 1) for w in waters.WATERS if w.model != "tip4p"])}


def report(result):
    """Means over the runs with their standard errors."""
    of = {}
    for run in result["runs"]:
        for name, value in run["values"].items():
            if value is not None:
                of.setdefault((run["water"], name), []).append(value)
    return study.table(["", "runs", "quantity", "value"], [[water, len(values), name, text(mean(values), 3)] for (water, name), values in sorted(of.items())])


if __name__ == "__main__":
    o = study.options(__doc__, {"runs": 1, "count": 64, "cutoff": 0.55, "length": 4.0, "equilibrate": 0.5, "window": 1.0},
                      runs=(4, "runs of each water model, each from another initial configuration"), count=(512, "waters in a run"),
                      cutoff=(0.9, "cutoff [nm]"), length=(200.0, "length of a run at constant energy [ps]"),
                      equilibrate=(20.0, "length of the equilibration with velocity rescaling [ps]"), every=(0.1, "time between frames [ps]"),
                      window=(20.0, "maximum lag of correlations [ps]"))
    study.perform(o, measured, report)
