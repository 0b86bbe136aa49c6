# SPDX-License-Identifier: MIT
"""The time-step bias of averages from the energies of any program."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from . import _core
from ._quantities import text_of
from ._results import EnergySeries, Report
from ._types import Path, Quantity
from .errors import Error


def bias(log: Path | Mapping[str, Any], temperature: Quantity | None = None, *, total: str | None = None,
         potential: str | None = None, energy_unit: str | None = None, start: float | None = None,
         stop: float | None = None) -> Report:
    """Computes the time-step bias of averages from the energies of a run, as ``polhode bias``.

    Args:
        log: a file (log of LAMMPS, .xvg, CSV; .edr if pyedr is installed), the energies of a Run, or columns
            by name, such as a dict of arrays or a DataFrame. A name may contain its unit, as in
            "Total Energy (kJ/mol)".
        temperature: temperature; default: the mean of the temperature in the log
        total: column of the total energy; default: the column with a usual name
        potential: column of the potential energy; default: the column with a usual name
        energy_unit: unit of energies: kJ/mol, kcal/mol, eV or lj; default: the unit in the log
        start: earliest time that is used, in the time unit of the log; default: the first row
        stop: latest time that is used, in the time unit of the log; default: the last row

    Returns:
        Report: with the keys of ``polhode bias --json``.

    Raises:
        Error: if columns are missing or are not numbers, or the energy was not constant or has too few digits.
    """
    given = {"temperature": text_of(temperature), "total": total, "potential": potential, "energy_unit": energy_unit,
             "start": start, "stop": stop}
    texts = {name: str(value) for name, value in given.items() if value is not None}
    if isinstance(log, (str, os.PathLike)):
        name, columns = os.fspath(log), {}
        if name.lower().endswith(".edr"):
            columns = _edr(name)
    else:
        name, columns = "columns", _columns(log)
    values = [_numbers(title, column) for title, column in columns.items()]
    return Report("bias", json.loads(_core.bias(name, list(map(str, columns)), values, texts)), [])


time_step_bias = bias


def _columns(log):
    """The columns of a table by name."""
    if isinstance(log, EnergySeries):
        units = log.units()
        return {f"{name} [{units[name]}]" if units[name] else name: log[name] for name in log.names()}
    try:
        titles = list(log)
        columns = {title: log[title] for title in titles}
    except (TypeError, KeyError, IndexError, ValueError):
        titles, columns = [], {}
    if not columns:
        raise Error("the log must be a file, the energies of a Run, or columns by name, such as a DataFrame or a dict of arrays")
    if len(columns) < len(titles):
        raise Error("two columns have the same name; give them different names")
    return columns


def _numbers(title, column):
    try:
        return [float(x) for x in column]
    except (TypeError, ValueError):
        raise Error(f"the column {title!r} must be a sequence of numbers") from None


def _edr(path):
    """The columns of a binary file of GROMACS, with their units."""
    try:
        import pyedr
    except ImportError:
        raise Error(f"{path}: an .edr file is read by pyedr, which is not installed; install it, or write "
                    f"the energies as text by 'gmx energy'") from None
    units = pyedr.get_unit_dictionary(path)
    return {f"{name} ({units[name]})" if units.get(name) else name: column
            for name, column in pyedr.edr_to_dict(path).items()}
