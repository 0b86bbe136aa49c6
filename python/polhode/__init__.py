# SPDX-License-Identifier: MIT
"""Molecular dynamics of rigid molecules, with exact free rotation and splitting schemes.

    import polhode

    simulation = polhode.Simulation(molecules="tip4p", count=512, initial_configuration="w512",
                                    scheme="hoa2", step="4 fs")
    run = simulation.run("1 ps")
    print(run.ratio)                        # R
    simulation.state.positions              # a view (n, 3) [nm]

The verbs of the command line are functions of the same names. Quantities are texts with
units such as "2 fs", or quantities of pint or openmm.unit. Invalid input raises polhode.Error.
"""

from . import _core, _jobs
from ._bias import bias, time_step_bias
from ._files import Frame, read, read_frames, write
from ._jobs import *
from ._lookup import Molecule, Scheme, molecules, schemes, verify
from ._measure import measure, merge
from ._progress import hooks as Progress
from ._quantities import quantity
from ._results import EnergySeries, Report, Run
from ._settings import Settings, settings
from ._simulation import Simulation
from ._state import State
from ._tops import free_rotation, rotate_table, rotation_matrix, top
from .errors import Error, OutputError, RunError
from .forces import ExternalForces

__version__ = _core.version

__all__ = ["EnergySeries", "Error", "ExternalForces", "Frame", "Molecule", "OutputError",
           "Progress", "Report", "Run", "RunError", "Scheme", "Settings", "Simulation", "State", "bias",
           "free_rotation", "instruction_set", "measure", "merge", "molecules", "quantity", "read", "read_frames",
           "rotate_table", "rotation_matrix", "schemes", "settings", "time_step_bias", "top", "verify", "write"]
__all__ += _jobs.__all__


def instruction_set():
    """str: the SIMD instruction set in use: "scalar", "sse4", "avx2", "avx512" or "neon"."""
    return _core.instruction_set()
