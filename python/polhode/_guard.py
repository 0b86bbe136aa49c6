# SPDX-License-Identifier: MIT
"""Base classes that reject assignments to attributes that cannot be set."""

from __future__ import annotations

from . import _core


def missing(name, names) -> str:
    """A message such as "there is no 'totl'; did you mean 'total'?", or the list of existing names."""
    near = _core.did_you_mean(str(name), [str(n) for n in names])
    return f"there is no '{name}'{near or '; there are: ' + ', '.join(map(str, names))}"


class Guarded:
    """A base of classes with slots. An assignment to an attribute that cannot be set raises an error with advice.

    Class attributes:
        _instead (dict): advice by the name of the attribute.
        _remedy (str): advice for all other existing attributes.
        _renamed (dict): new names of attributes by their old names.
    """

    __slots__ = ()
    _instead: dict[str, str] = {}
    _renamed: dict[str, str] = {}
    _remedy = "it is a result, or follows from other things"

    def __setattr__(self, name, value):
        there = getattr(type(self), name, None)
        if hasattr(type(there), "__set__") and getattr(there, "fset", there) is not None:
            object.__setattr__(self, name, value)
            return
        kind = type(self).__name__.lstrip("_")
        if name in self._instead:
            raise AttributeError(f"{kind}.{name} cannot be set: {self._instead[name]}")
        if name in dir(self):
            raise AttributeError(f"{kind}.{name} cannot be set: {self._remedy}")
        if name in self._renamed:
            raise AttributeError(f"{kind}.{name} is called {self._renamed[name]}")
        names = [n for n in dir(self) if not n.startswith("_")]
        raise AttributeError(f"a {kind} has no attribute '{name}'{_core.did_you_mean(name, names)}")

    def __getattr__(self, name):
        kind = type(self).__name__.lstrip("_")
        if name in self._renamed:
            raise AttributeError(f"{kind}.{name} is called {self._renamed[name]}")
        raise AttributeError(f"a {kind} has no attribute '{name}'")


class Record(Guarded):
    """A base class of objects that have the keys of a dict as attributes."""

    __slots__ = ("_data",)

    @property
    def data(self) -> dict:
        """dict: all attributes by name."""
        return self._data

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._data[name]
        except KeyError:
            kind = type(self).__name__
            near = _core.did_you_mean(name, list(self._data))
            raise AttributeError(f"the {kind.lower()} has no '{name}'{near}") from None

    def __dir__(self):
        return [*super().__dir__(), *self._data]


class Energies(dict):
    """Energies by name."""

    def __missing__(self, name):
        raise KeyError(missing(name, self))
