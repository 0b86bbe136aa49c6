# SPDX-License-Identifier: MIT
"""Whether averages without their time-step bias are those of short steps: velocity Verlet at 4 fs against 0.5 fs, over many seeds.

Each seed equilibrates its own liquid and continues from there with both steps, with new velocities that are the same for both. The criterion, fixed before the
runs: of 100 differences of each corrected average, 59 to 77 lie within one stated error and 91 to 99 within 1.96 stated errors
(two standard deviations of a binomial number), and the mean difference is within three of its standard errors of zero.
The same criterion applies to averages that `polhode bias` corrects, from the energies that the same runs printed."""

import numpy as np
from lib import runs, study
from lib.statistics import mean, share_interval

RESCALING = {"thermostat": {"type": "rescaling", "time_constant": "0.2 ps"}}
STEPS = (4, 0.5)  # [fs]
QUANTITIES = {"potential_kJ_per_mol": "potential energy [kJ/mol]", "pressure_bar": "pressure [bar]",
              "temperature_translation_K": "T of translation [K]", "temperature_rotation_all_K": "T of rotation [K]"}
COLUMNS = {"potential": "bias: potential energy [kJ/mol]", "pressure": "bias: pressure [bar]",
           "kinetic_translation": "bias: translational energy [kJ/mol]", "kinetic_rotation": "bias: rotational energy [kJ/mol]"}  # of printed energies


def tables(o, seed, step, length, name, place, minimise=None):
    return {"system": {"molecules": runs.molecules("tip4p", o.molecules), **place, "temperature": "298 K", "seed": seed},
            "forces": {"precision": "mixed", "electrostatics": "reaction-field", "cutoff": f"{o.cutoff:g} nm", "switch": f"{0.85 * o.cutoff:g} nm"},
            "integrator": {"scheme": "velocity-verlet", "step": f"{step:g} fs"},
            "run": {"length": f"{length:g} ps", "sample": "8 fs", "minimise": minimise}, "output": {"prefix": name, **runs.QUIET}, **RESCALING}


def averages(o, folder, seed):
    """The corrected averages with their errors, and the biases, at both steps."""
    start = f"start{seed}"
    runs.run(o, tables(o, seed, 1, o.equilibrate, start, {"density": "0.995 g/cm3"}, True), folder, name=start)
    found = {}
    for step in STEPS:
        name = f"seed{seed}-{step:g}"
        place = {"initial_configuration": f"{start}-final.gro", "velocities": "new"}
        said = runs.run(o, tables(o, 1000 + seed, step, o.length, name, place), folder, name=name)
        found[f"{step:g}"] = {key: {part: [said[part][key]["value"], said[part][key].get("error")] for part in ("corrected", "step_bias")}
                              for key in QUANTITIES} | from_printed(o, folder, name)
    return found


def from_printed(o, folder, name):
    """The corrected averages of a molecule, and the biases, by `polhode bias` from the energies that a run printed."""
    found = {}
    for column in runs.asked(o, "bias", f"{name}-energies.csv", folder=folder)["columns"]:
        if column["name"] in COLUMNS:
            bodies = 1 if column["name"] == "pressure" else o.molecules
            parts = {"corrected": column["corrected"], "step_bias": column["bias"]}
            found[column["name"]] = {part: [x and x / bodies for x in (of["value"], of.get("error"))] for part, of in parts.items()}
    return found


def measured(o):
    with runs.scratch(o) as folder:
        seeds = range(o.first, o.first + o.seeds)
        return {"seeds": runs.parallel(o, lambda seed: runs.kept(folder, f"averages{seed}", lambda: averages(o, folder, seed)), seeds)}


def share(z, interval):
    count = int(np.sum(np.abs(z) < interval))
    low, high = share_interval(count, len(z))
    return f"{100 * count / len(z):.0f} % ({100 * low:.0f} to {100 * high:.0f})"


def report(result):
    rows = []
    for key, title in (QUANTITIES | COLUMNS).items():
        pairs = [[seed[f"{step:g}"].get(key) for step in STEPS] for seed in result["seeds"]]
        pairs = [p for p in pairs if all(x and x["corrected"][1] for x in p)]
        if not pairs:
            rows.append([title, "the runs are too short", "", 0, "", ""])
            continue
        long, short = (np.array([p[k]["corrected"] for p in pairs], float) for k in (0, 1))
        difference, error = long[:, 0] - short[:, 0], np.hypot(long[:, 1], short[:, 1])
        bias = mean([p[0]["step_bias"][0] for p in pairs])
        rows.append([title, *("{:.3g} ± {:.2g}".format(*x) for x in (bias, mean(list(difference)))), len(pairs),
                     share(difference / error, 1), share(difference / error, 1.96)])
    return study.table(["average", "bias at 4 fs", "corrected, 4 fs minus 0.5 fs", "seeds", "within 68 %", "within 95 %"], rows)


if __name__ == "__main__":
    o = study.options(__doc__, {"molecules": 32, "cutoff": 0.45, "length": 4.0, "equilibrate": 1.0, "seeds": 2}, molecules=(64, "waters"), cutoff=(0.6, "cutoff [nm]"),
                      seeds=(100, "seeds"), first=(1, "first seed"), length=(100.0, "length of each run [ps]"), equilibrate=(20.0, "equilibration [ps]"))
    study.perform(o, measured, report)
