# SPDX-License-Identifier: MIT
"""Built-in and user-defined schemes and molecules."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _core
from ._guard import Record
from ._html import molecule_html, scheme_html
from .errors import Error
from ._results import Report
from ._settings import toml_text
from ._types import Path


class Scheme(Record):
    """A splitting scheme: a name of the table, or stages as text such as "B(1/2) A(1) B(1/2)".

    Attributes:
        name (str): name of the scheme, or its text.
        order (int): 0 if it is unknown.
        stages (list of dict): "flow" ("drift", "kick", "bath"), "fraction", "xi", "gradient".
        cost (float): force evaluations per step; a derivative counts as two evaluations.
        force_evaluations, gradient_kicks (int): numbers per step.
        palindrome (bool): whether the scheme is time-reversible.
        source (str): key in the bibliography.
        text (str): the stages as text.
    """

    __slots__ = ()
    _remedy = "another scheme is polhode.Scheme(\"B(1/2) A(1) B(1/2)\")"

    def __init__(self, text: str) -> None:
        if not isinstance(text, str):
            raise Error(f"a scheme is a text, a name or stages, not of type {type(text).__name__}")
        self._data = json.loads(_core.scheme_json(text))

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"<Scheme {self.name}: order {self.order or 'unknown'}, {self.text}>"

    def __eq__(self, other):
        return isinstance(other, Scheme) and self.data == other.data

    def __hash__(self):
        return hash(self.text)

    _repr_html_ = scheme_html


def _scheme(data):
    scheme = Scheme.__new__(Scheme)
    scheme._data = data
    return scheme


def schemes(name: str | None = None) -> Scheme | dict[str, Scheme]:
    """The splitting schemes, as ``polhode schemes``.

    Args:
        name (str): a name, or stages as text; None: all.

    Returns:
        Scheme, or a dict of schemes by name.
    """
    if name is not None:
        return Scheme(name)
    return {data["name"]: _scheme(data) for data in json.loads(_core.schemes_json())}


def verify(scheme: Scheme | str, *, order: int = 0, lambda_: float | None = None) -> Report:
    """Measures the order of a scheme, as ``polhode verify``.

    Args:
        scheme: a Scheme, a name, or stages as text.
        order (int): expected order, from 1 to 12; default: the order in the table of schemes.
        lambda_ (float): scale of the displacement of a finite-difference gradient.

    Returns:
        Report: "measured_order", "declared_order", "holds" (None without a declared order), and
        "points": step [ps], and energy error, divided by the initial kinetic energy.
    """
    text = scheme.text if isinstance(scheme, Scheme) else scheme
    given = {"order": str(order)} if isinstance(order, bool) or order != 0 else {}
    if lambda_ is not None:
        given["lambda"] = str(lambda_)
    return Report("verify", json.loads(_core.verify(text, given)), [])


_SITE_UNITS = {"position": "nm", "mass": "u", "charge": "e", "sigma": "nm", "epsilon": "kJ/mol"}


def _site_table(site):
    """The keys of a site in a molecule file."""
    table = {"name": site["name"], "position": " ".join(repr(x) for x in site["position"]) + " nm"}
    if site["element"]:
        table["element"] = site["element"]
    for key in ("mass", "charge", "sigma", "epsilon"):
        if site[key]:
            table[key] = f"{site[key]!r} {_SITE_UNITS[key]}"
    return table


class Molecule(Record):
    """A rigid molecule, from a dict with the keys of a molecule file::

        Molecule({"name": "dumbbell", "source": "mine", "site": [
            {"name": "A", "element": "Ar", "position": "0 0 0 nm", "mass": "40 u", ...}, ...]})

    Attributes:
        name, description, source (str)
        mass (float): [u]
        top (str): "atom", "linear", "spherical", "symmetric" or "asymmetric"
        mixing (str or None): mixing rule with which the model was parametrized
        charge (float): total charge [e]
        dipole (float): dipole moment [D]
        sites (list of dict): sites in the principal frame, with positions (3) [nm], masses [u] and charges [e].
    """

    __slots__ = ("_table",)
    _remedy = "another molecule is polhode.Molecule({**molecule.as_dict(), ...})"

    def __init__(self, table: Mapping[str, Any]) -> None:
        if not isinstance(table, Mapping):
            raise Error("a molecule is a dict with the keys of a molecule file, not of type "
                        + type(table).__name__)
        self._table = dict(table)
        text = toml_text({"m": self._table}).partition("\n")[2]  # without the line "[m]"
        self._data = json.loads(_core.molecule_json(text, "dict"))

    @property
    def moments(self) -> np.ndarray:
        """numpy.ndarray: principal moments (3) [u nm²]."""
        return np.array(self.data["moments"])

    def as_dict(self) -> dict:
        """The molecule with the keys of a molecule file."""
        if self._table is not None:
            return dict(self._table)
        lennard_jones = all(s["law"] == "lennard-jones" for s in self.sites)
        if not lennard_jones:
            raise Error(f"{self.name} has laws other than Lennard-Jones; use its name instead")
        rule = {"mixing": self.mixing} if self.mixing else {}
        return {"name": self.name, "description": self.description, "source": self.source or "-", **rule,
                "site": [_site_table(site) for site in self.sites]}

    def __repr__(self):
        return f"<Molecule {self.name}: {len(self.sites)} sites, {self.top} top, {self.mass:g} u>"

    _repr_html_ = molecule_html


def _molecule(data):
    molecule = Molecule.__new__(Molecule)
    molecule._data, molecule._table = data, None
    return molecule


def kinds_of(core):
    """The molecules of a simulation in the library."""
    return [_molecule(data) for data in json.loads(core.kinds_json())]


def molecules(name: Path | None = None) -> Molecule | dict[str, Molecule]:
    """The molecule models, as ``polhode molecules``.

    Args:
        name: a model, a molecule file, a GROMACS topology or a LAMMPS data file; None: all models.

    Returns:
        dict of Molecule by name; or a single Molecule for the name of a model or a molecule file.
    """
    found = [_molecule(data)
             for data in json.loads(_core.molecules_json("" if name is None else os.fspath(name)))]
    if name is not None and len(found) == 1:
        return found[0]
    return {m.name: m for m in found}
