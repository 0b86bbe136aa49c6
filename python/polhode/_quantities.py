# SPDX-License-Identifier: MIT
"""Conversion of quantities (texts such as "2 fs", or pint and openmm.unit objects) to texts for the library."""

from __future__ import annotations

import numbers
import os

from . import _core
from ._guard import Record
from ._types import Quantity
from .errors import Error

# Units, one for each dimension, as pairs of the names that pint and run files use.
_UNITS = (
    ("ps", "ps"), ("nm", "nm"), ("K", "K"), ("kJ/mol", "kJ/mol"), ("g/cm**3", "g/cm3"),
    ("bar", "bar"), ("u", "u"), ("elementary_charge", "e"), ("1/ps", "1/ps"),
    ("1/bar", "1/bar"), ("kJ/mol/nm", "kJ/mol/nm"), ("mPa*s", "mPa s"), ("kJ/mol/ns", "kJ/mol/ns"),
    ("1/nm", "1/nm"),
)


def _from_pint(value):
    """A pint quantity, converted to the first compatible unit of a list."""
    if value.dimensionless:
        return f"{100 * float(value.to('').magnitude)!r} %"
    for pint_unit, ours in _UNITS:
        if value.is_compatible_with(pint_unit):
            return f"{float(value.to(pint_unit).magnitude)!r} {ours}"
    return str(value)  # refused by the library, which names the unit


def _from_openmm(value):
    """An openmm.unit quantity, converted to the first compatible unit of a list."""
    from openmm import unit as u

    units = (
        (u.picosecond, "ps"), (u.nanometer, "nm"), (u.kelvin, "K"),
        (u.kilojoule_per_mole, "kJ/mol"), (u.gram / u.centimeter**3, "g/cm3"), (u.bar, "bar"),
        (u.dalton, "u"), (u.elementary_charge, "e"), (u.picosecond**-1, "1/ps"),
        (u.kilojoule_per_mole / u.nanometer, "kJ/mol/nm"), (u.nanometer**-1, "1/nm"),
        (u.bar**-1, "1/bar"), (u.kilojoule_per_mole / u.nanosecond, "kJ/mol/ns"),
    )
    for unit, ours in units:
        if value.unit.is_compatible(unit):
            return f"{float(value.value_in_unit(unit))!r} {ours}"
    return str(value)


def text_of(value) -> object:
    """A quantity as text, in the form used in run files; other values are unchanged.

    Args:
        value: a text ("2 fs"), a ``pint.Quantity``, an ``openmm.unit.Quantity``, or anything else.

    Returns:
        For a quantity, "NUMBER UNIT" with all digits, in one of the units of run files. For a Scheme, its
        stages.
    """
    if isinstance(value, Record) and "stages" in value.data:
        return value.text
    if hasattr(value, "is_compatible_with") and hasattr(value, "magnitude"):
        return _from_pint(value)
    if hasattr(value, "value_in_unit") and hasattr(value, "unit"):
        return _from_openmm(value)
    return value


def plain(value) -> object:
    """A value of plain Python types: texts for quantities and paths, lists for arrays."""
    value = text_of(value)
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    return os.fspath(value) if isinstance(value, os.PathLike) else value


def quantity_text(value, dimension, name):
    """The text of an argument that must be a quantity.

    Raises:
        Error: if it is a number without a unit, with the same message as for run files.
    """
    value = text_of(value)
    if isinstance(value, numbers.Number) and not isinstance(value, bool):
        written = repr(value.item() if hasattr(value, "item") else value)
        raise Error(_core.no_unit(name, written, dimension))
    if not isinstance(value, str):
        raise Error(f"{name} = {value!r} must be a quantity; write for example "
                    + _core.no_unit(name, "2", dimension).rpartition("write for example ")[2])
    return value


def quantity(value: Quantity, dimension: str, name: str = "quantity") -> float:
    """The number of a quantity in the units of the library: nm, ps, u, e, K, kJ/mol.

    Args:
        value: a text ("2 fs") or a quantity of pint or openmm.unit.
        dimension (str): "length", "time", "mass", "charge", "temperature", "force", "energy",
            "density" [u/nm³], "pressure" [kJ/mol/nm³], "power", "viscosity", "fraction" or "rate".
        name (str): name of the value, for error messages.

    Returns:
        float: the number.

    Raises:
        Error: if the unit is missing, unknown or of another dimension.
    """
    return _core.quantity(quantity_text(value, dimension, name), dimension, name)


def positive(value, dimension, name) -> float:
    """The number of a quantity that must be above 0, in the units of the library.

    Raises:
        Error: if the number is not above 0, with the same message as on the command line.
    """
    number = quantity(value, dimension, name)
    if not number > 0:
        raise Error(f"{name} = \"{text_of(value)}\" must be longer than 0; write for example \"2 fs\"")
    return number
