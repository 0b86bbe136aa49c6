# SPDX-License-Identifier: MIT
"""The state of a simulation: views of the numbers, and methods that change them."""

from __future__ import annotations

import numpy as np

from ._arrays import reals
from ._guard import Guarded
from .errors import Error


class State(Guarded):
    """The state of a simulation, as views of its numbers without a copy.

    A view always shows the present state, also after further steps. Views are read-only, and stay valid as long as they
    exist. To change the state, use change()::

        with simulation.state.change() as state:
            state.positions[0] += [0.1, 0, 0]

    Rows are molecules, in the order of the topology.
    """

    __slots__ = ("_core", "_settings")
    _remedy = "write 'with simulation.state.change() as state:', and there state.positions = ..."
    _instead = {"box": "it is that of the settings or of the initial configuration, and a barostat changes it",
                "time": "it is that of the trajectory"}
    _renamed = {"attitudes": "orientations"}

    def __init__(self, core, settings):
        self._core = core
        self._settings = settings  # which have the forces of one's own

    @property
    def positions(self) -> np.ndarray:
        """Centres of mass (n, 3) [nm], lab frame, not wrapped into the box."""
        return self._core.positions

    @property
    def momenta(self) -> np.ndarray:
        """Momenta (n, 3) [u nm/ps], lab frame."""
        return self._core.momenta

    @property
    def orientations(self) -> np.ndarray:
        """Orientations (n, 4), unit quaternions (w, x, y, z) that rotate from the body to the lab frame."""
        return self._core.orientations

    @property
    def angular_momenta(self) -> np.ndarray:
        """Angular momenta (n, 3) about the centres of mass [u nm²/ps], lab frame."""
        return self._core.angular_momenta

    @property
    def box(self) -> np.ndarray:
        """Edges of the periodic box (3) [nm]; a copy."""
        return self._core.box

    @property
    def time(self) -> float:
        """Time [ps]."""
        return self._core.time

    def __len__(self):
        return self._core.molecules

    def __repr__(self):
        return f"<state of {len(self)} molecules at {self.time:g} ps>"

    def change(self) -> _Change:
        """A context in which the state can be changed. Its target has the writable arrays
        `positions`, `momenta`, `orientations` and `angular_momenta`, to be changed in place or assigned.

        At the end of the context orientations are normalized, and a new segment of the trajectory begins,
        with new forces and statistics. The step count continues. If an exception leaves the block, or a number
        is invalid, the state is restored. The arrays must not be kept, because later writes have no defined effect.

        Raises:
            Error: at the end, if a number is not finite or an angular momentum has a component along an
                axis with no moment of inertia; the message names the molecule.
        """
        return _Change(self._core, self._settings)


def _column(index, name, doc):
    """A writable array of a change, into which an assignment copies."""

    def get(change):
        return change._arrays[index]

    def put(change, values):
        array = change._arrays[index]
        if values is array:  # of an operation in place
            return
        values = reals(values, name)
        if values.shape != array.shape:
            raise Error(f"{name} has the shape {values.shape}, and must have {array.shape}; for one value "
                        f"in all places write state.{name}[...] = value")
        array[...] = values

    return property(get, put, doc=doc)


class _Change(Guarded):
    """The target of State.change()."""

    __slots__ = ("_core", "_settings", "_arrays")
    _instead = State._instead
    _renamed = State._renamed

    positions = _column(0, "positions", "Centres of mass (n, 3) [nm].")
    momenta = _column(1, "momenta", "Momenta (n, 3) [u nm/ps].")
    orientations = _column(2, "orientations", "Orientations (n, 4), quaternions (w, x, y, z).")
    angular_momenta = _column(3, "angular_momenta", "Angular momenta (n, 3) [u nm²/ps].")

    def __init__(self, core, settings):
        self._core, self._settings, self._arrays = core, settings, ()

    def __enter__(self):
        self._arrays = self._core.begin_change()
        return self

    def __exit__(self, kind, *_):
        for array in self._arrays:
            array.flags.writeable = False
        self._core.end_change(kind is None)
        return False
