# SPDX-License-Identifier: MIT
"""The three water models, and their runs at constant energy."""

from typing import NamedTuple

from . import runs

TEMPERATURE = 298.15  # [K]


class Water(NamedTuple):
    model: str
    name: str
    density: float  # of published values of its energy or pressure [g/cm3]


# Sources of the densities: jorgensen1983 at 298 K and 1 atm; hummer1998 at 298 K; abascal2005 at 298 K and 1 bar.
WATERS = (Water("tip4p", "TIP4P", 0.999), Water("spce", "SPC/E", 0.997), Water("tip4p-2005", "TIP4P/2005", 0.9979))


def made(o, folder, water, seed, temperature):
    """(prefix, report) of one run from a lattice, which is performed unless the folder has it."""
    prefix = f"{water.model}-{seed}"
    tables = {"system": {"molecules": runs.molecules(water.model, o.count), "density": f"{water.density} g/cm3",
                         "temperature": f"{temperature:g} K", "seed": seed},
              "forces": {"electrostatics": "pme", "pme_accuracy": 1e-4, "cutoff": f"{o.cutoff} nm", "dispersion_correction": True, "precision": "mixed"},
              "integrator": {"scheme": "gier4-fd", "step": "4 fs"},
              "run": {"equilibrate": f"{o.equilibrate:g} ps", "length": f"{o.length:g} ps", "sample": "20 fs"},
              "output": {"prefix": prefix, "trajectory_every": f"{o.every:g} ps", "formats": ["trr"], "plot": "none"}}
    return prefix, runs.kept(folder, prefix, lambda: runs.run(o, tables, folder, name=prefix))


def analyzed(o, folder, prefix, *words):
    """The report of `polhode analyze` on a run, without its first frame."""
    return runs.kept(folder, f"{prefix}-analysis", lambda: runs.asked(
        o, "analyze", f"{prefix}-trajectory.trr", "--run", f"{prefix}.toml", "--from", f"{o.every:g} ps", "--pairs", "OW-OW", "--plot", "none",
        "--threads", 1, "--force", "--output", prefix, *words, folder=folder))
