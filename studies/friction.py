# SPDX-License-Identifier: MIT
"""The time-step bias of the potential energy with Langevin thermostats of different friction: velocity Verlet at 4 fs, with the thermostat at both ends of a step.

Theory: friction that is slow against all exchange of energy leads to the bias of a rescaling thermostat. The reference is velocity rescaling at 0.5 fs. Each
seed equilibrates its own liquid, from which all runs continue. The criterion was fixed before the runs. The bias at the smallest friction agrees with the bias of
rescaling at 4 fs within three standard errors of their difference. All other rows are reported as they are."""

from pathlib import Path

from corrected_averages import tables
from lib import runs, study
from lib.statistics import mean

FRICTIONS = (0.05, 0.2, 1, 5, 20)  # [1/ps]
REFERENCE, RESCALED = "rescaling, 0.5 fs", "rescaling, 4 fs"


def thermostats():
    """(step [fs], thermostat) of each row."""
    rescaling = {"type": "rescaling", "time_constant": "0.2 ps"}
    return {REFERENCE: (0.5, rescaling), RESCALED: (4, rescaling)} | {
        f"Langevin, {friction:g}/ps": (4, {"type": "langevin", "friction": f"{friction:g} 1/ps"}) for friction in FRICTIONS}


def energies(o, folder, seed):
    """The mean potential energy of a molecule with each thermostat, and the bias that the rescaled run predicts [kJ/mol]."""
    start = f"start{seed}"
    runs.run(o, tables(o, seed, 1, o.equilibrate, start, {"density": "0.995 g/cm3"}, True), folder, name=start)
    found = {}
    for name, (step, thermostat) in thermostats().items():
        file = f"seed{seed}"
        place = {"initial_configuration": f"{start}-final.gro", "velocities": "new"}
        table = tables(o, 1000 + seed, step, o.length, file, place)
        slow = 0.25 / float(thermostat.get("friction", "1").split()[0])  # so that five relaxation times are left out
        table["run"]["equilibrate"] = f"{o.equilibrate * max(1, slow):g} ps"
        said = runs.run(o, table | {"thermostat": thermostat}, folder, name=file)
        found[name] = float(runs.columns(folder / f"{file}-energies.csv")["potential"].mean()) / o.molecules
        if name == RESCALED:
            found["predicted"] = runs.number(said["step_bias"]["potential_kJ_per_mol"])
    return found


def measured(o):
    with runs.scratch(o) as folder:
        seeds = range(o.first, o.first + o.seeds)
        return {"seeds": runs.parallel(o, lambda seed: runs.kept(folder, f"friction{seed}", lambda: energies(o, Path(folder), seed)), seeds)}


def report(result):
    bias = lambda name: mean([seed[name] - seed[REFERENCE] for seed in result["seeds"]])
    text = "{:.3f} ± {:.3f}".format
    rows = [[name, text(*bias(name)), text(*mean([seed[name] - seed[RESCALED] for seed in result["seeds"]]))]
            for name in thermostats() if name != REFERENCE]
    return (study.table(["thermostat at 4 fs", "bias of the potential energy per molecule [kJ/mol]", "difference from rescaling"], rows)
            + f"\npredicted for rescaling: {text(*mean([seed['predicted'] for seed in result['seeds']]))} kJ/mol, from {len(result['seeds'])} seeds\n")


if __name__ == "__main__":
    o = study.options(__doc__, {"molecules": 27, "cutoff": 0.44, "seeds": 2, "length": 1.0, "equilibrate": 0.2}, molecules=(64, "number of waters"),
                      cutoff=(0.6, "cutoff [nm]"), seeds=(100, "number of seeds"), first=(1, "first seed"), length=(200.0, "length of each run [ps]"),
                      equilibrate=(20.0, "equilibration [ps]"))
    study.perform(o, measured, report)
