#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The density maximum of TIP4P/2005 at 1 bar, and its shift by the time step: density, compressibility and dielectric constant of velocity
Verlet at 2 fs, with their predicted biases.

Biases of second-order schemes are proportional to the square of the step. Runs at 2 fs thus give the limit of short steps and velocity
Verlet at every step. Every run adds a line to the record; an interrupted study, or one with more runs, continues where the record ends."""

import json
from pathlib import Path

import density_maximum_tables as tables
from lib import runs, study

STEP = 2  # [fs]
# By temperature [K]: initial density [g/cm³], the density of the model at 1 bar [abascal2005], and the share of the runs. The shares were
# chosen before the first run from the scatter of earlier runs, so that each density but the first has an error of 0.02 % with --runs 10.
TEMPERATURES = {257: (0.995, 6), 267: (0.999, 8), 277: (1.000, 5), 287: (0.9995, 2), 298: (0.997, 2), 308: (0.994, 2), 318: (0.990, 1)}
FRAME = 0.2  # time between frames for the dielectric constant [ps]


def run_tables(o, temperature, seed):
    return {"system": {"molecules": runs.molecules("tip4p-2005", 216), "density": f"{TEMPERATURES[temperature][0]} g/cm3",
                       "temperature": f"{temperature} K", "seed": 1000 * temperature + seed},
            "forces": {"precision": "mixed", "cutoff": "0.85 nm", "electrostatics": "pme", "dispersion_correction": True},
            "integrator": {"scheme": "velocity-verlet", "step": f"{STEP} fs"},
            "run": {"equilibrate": f"{o.equilibrate:g} ps", "length": f"{o.length:g} ps", "sample": "20 fs", "shadow_sample": "40 fs"},
            "output": {"prefix": "run", "trajectory_every": f"{FRAME} ps", "formats": ["trr"], "plot": "none"},
            "thermostat": {"type": "rescaling", "time_constant": "1 ps"},
            "barostat": {"type": "cell-rescaling", "pressure": "1 bar", "compressibility": "4.5e-5 1/bar", "time_constant": "1 ps"}}


def line(o, temperature, seed):
    """The data that a run adds to the record."""
    with runs.scratch() as folder:
        report = runs.run(o, run_tables(o, temperature, seed), folder)
        said = runs.asked(o, "analyze", "run-trajectory.trr", "--run", "run.toml", "--names", "run-final.gro", "--energies", "run-energies.csv",
                          "--what", "dielectric", "--plot", "none", "--threads", 1, folder=folder)
    return {"temperature": temperature, "seed": seed, **{name: report[name] for name in ("pressure_bar", "step_bias")},
            **{name: report["ensemble"]["barostat"][name] for name in ("density_kg_per_m3", "volume_nm3", "compressibility_per_bar")},
            "dielectric": said["dielectric"], "seconds": report["seconds"]["all"]}


def known(record):
    """The lines of a record."""
    return list(map(json.loads, record.read_text(encoding="utf-8").splitlines())) if record.exists() else []


def complete(o):
    """Performs the runs that the record lacks, round by round, so that all temperatures advance together."""
    share = lambda temperature: 1 if o.smoke else TEMPERATURES[temperature][1]
    planned = [(T, share(T) * turn + k + 1) for turn in range(o.runs) for T in TEMPERATURES for k in range(share(T))]
    finished = {(one["temperature"], one["seed"]) for one in known(o.record)}
    with o.record.open("a", encoding="utf-8") as record:
        def one(case):
            record.write(json.dumps({**study.head(o), **line(o, *case)}) + "\n")
            record.flush()
        runs.parallel(o, one, [case for case in planned if case not in finished])


def main():
    o = study.options(__doc__, {"runs": 2, "length": 1.0, "equilibrate": 0.5}, runs=(10, "rounds; a round has 26 runs"),
                      length=(500.0, "length of each run [ps]"), equilibrate=(30.0, "length of the equilibration [ps]"))
    o.record = o.record.with_suffix(".jsonl") if o.record.suffix == ".json" else o.record
    if not o.report:
        complete(o)
    print(tables.report(known(o.record)))
    if o.figure:
        import density_maximum_figure as figure  # only here: tables need no matplotlib
        figure.draw(known(o.record), Path(o.figure))


if __name__ == "__main__":
    main()
