# SPDX-License-Identifier: MIT
"""External forces that a Python function computes. They are added to the force field.

A function ``f(q, orientation)``, or ``f(q, orientation, box)``, is called with

- ``q`` (n, 3): centres of mass [nm], unwrapped;
- ``orientation`` (n, 4): unit quaternions (w, x, y, z) that rotate from the body to the lab frame;
- ``box`` (3): edges [nm];

and returns ``force, torque, energy`` or ``force, torque, energy, virial``:

- ``force`` (n, 3) [kJ/mol/nm];
- ``torque`` (n, 3) about the centres of mass, lab frame [kJ/mol], or None for none;
- ``energy`` [kJ/mol];
- ``virial`` (3, 3), the sum of R ⊗ f over pairs [kJ/mol]; without it the pressure does not include these forces.

The arrays belong to the function. Forces must depend only on these arguments, and must be minus the
gradient of the energy.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np

from ._arrays import reals
from ._guard import Guarded
from .errors import Error, RunError

__all__ = ["ExternalForces"]


class ExternalForces(Guarded):
    """A function that computes forces, with a name.

    Args:
        function: as described in polhode.forces.
        name (str): name in checkpoints; default: name of the function.
        virial (bool): whether the function also returns a virial.
    """

    __slots__ = ("_function", "_name", "_virial", "_takes_box", "__weakref__")
    _remedy = "other forces are polhode.ExternalForces(function, name=..., virial=...)"

    def __init__(self, function: Callable[..., Any], name: str | None = None,
                 virial: bool = False) -> None:
        if not callable(function):
            raise Error(f"forces must be a function, not of type {type(function).__name__}")
        self._function = function
        self._name = name or getattr(function, "__name__", type(function).__name__)
        self._virial = bool(virial)
        self._takes_box = _takes_box(function)

    @property
    def function(self) -> Callable[..., Any]:
        """The function."""
        return self._function

    @property
    def name(self) -> str:
        """str: name in checkpoints."""
        return self._name

    @property
    def virial(self) -> bool:
        """bool: whether the function also returns a virial."""
        return self._virial

    def __call__(self, q, orientation, box):
        """The checked result of the function: force, torque, energy, virial."""
        arguments = (q, orientation, np.array(box)) if self._takes_box else (q, orientation)
        result = self.function(*arguments)
        wanted = 4 if self.virial else 3
        if not isinstance(result, (tuple, list)) or len(result) != wanted:
            raise Error(f"the forces '{self.name}' returned {_what(result)}, and must return "
                        f"force, torque, energy{', virial' if self.virial else ''}")
        force = self._rows(result[0], "force", q.shape)
        torque = np.zeros(q.shape) if result[1] is None else self._rows(result[1], "torque", q.shape)
        energy = self._rows(result[2], "energy", ())
        virial = self._rows(result[3], "virial", (3, 3)) if self.virial else None
        return force, torque, float(energy), virial

    def _rows(self, values, what, shape):
        """An array of doubles of this shape, all finite."""
        array = np.array(reals(values, f"the {what} of the forces '{self.name}'"), order="C")
        if array.shape != shape:
            raise Error(f"the {what} of the forces '{self.name}' has the shape {array.shape}, and "
                        f"must have {shape}")
        if not np.isfinite(array).all():
            raise RunError(f"the {what} of the forces '{self.name}' has numbers that are not finite")
        return array


def _takes_box(function):
    """Whether a function has a third positional parameter."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return False
    positional = [p for p in parameters
                  if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    return len(positional) >= 3 and (positional[2].default is inspect.Parameter.empty
                                     or positional[2].name == "box")


def _what(result):
    if isinstance(result, (tuple, list)):
        return f"{len(result)} values"
    return f"a value of type {type(result).__name__}"


def add_forces(config, function):
    """Adds a function, or ExternalForces, to the settings of the library."""
    external = function if isinstance(function, ExternalForces) else ExternalForces(function)
    config.set_forces(external, external.name, external.virial)
    config.own_forces = external  # the reference of the library is weak
