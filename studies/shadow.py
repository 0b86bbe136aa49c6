# SPDX-License-Identifier: MIT
"""Energy drift, from the energy and from the shadow energy of the same runs of water."""

from lib import runs, study

CASES = [("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4), ("hoa2", 6)]  # scheme, step [fs]
KEPT = ("R", "rms_total_kJ_per_mol", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value", "shadow")


def sample(step):
    """The intervals between energies and between shadow energies: 4 fs, rounded to whole steps [fs]."""
    return step * max(1, round(4 / step))


def measured(o):
    def one(case):
        scheme, step = case
        place = ({"molecules": runs.molecules("tip4p", 8), "density": "0.1 g/cm3"} if o.smoke
                 else {"molecules": [{"model": "tip4p"}], "initial_configuration": "w512"})  # which has velocities: no seed matters
        between = f"{sample(step)} fs"
        tables = {"system": place, "forces": {"precision": "mixed", **({"cutoff": "0.6 nm", "switch": "0.5 nm"} if o.smoke else {})},
                  "integrator": {"scheme": scheme, "step": f"{step} fs"},
                  "run": {"equilibrate": f"{o.equilibrate:g} ps", "length": f"{o.length:g} ps", "sample": between, "shadow_sample": between},
                  "output": runs.QUIET}
        with runs.scratch() as folder:
            report = runs.run(o, tables, folder)
        return {"scheme": scheme, "step_fs": step, "sample_fs": sample(step), **{key: report[key] for key in KEPT}}

    return {"runs": runs.parallel(o, one, CASES)}


def report(result):
    drift = lambda of: f"{of['drift_kJ_per_mol_ps']:.2g} ± {of['drift_error']:.1g} ({of['drift_p_value']:.1g})"
    return study.table(
        ["scheme", "step [fs]", "R [%]", "rms of E", "rms of H̃", "drift of E (p-value)", "drift of H̃ (p-value)", "sooner"],
        [[r["scheme"], f"{r['step_fs']:g}", f"{100 * r['R']:.2f}", f"{r['rms_total_kJ_per_mol']:.2g}", f"{r['shadow']['rms_kJ_per_mol']:.2g}", drift(r),
          drift(r["shadow"]), f"{r['shadow']['time_gain']:.2g} times"] for r in result["runs"]])


if __name__ == "__main__":
    o = study.options(__doc__, {"length": 0.3, "equilibrate": 0.05}, length=(12.0, "length of each run [ps]"),
                      equilibrate=(2.0, "length of the equilibration [ps]"))
    study.perform(o, measured, report)
