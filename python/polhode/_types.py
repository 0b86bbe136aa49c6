# SPDX-License-Identifier: MIT
"""Types of arguments: paths, quantities with units, settings, progress."""

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

if TYPE_CHECKING:
    from ._settings import Settings


class PintQuantity(Protocol):
    """A quantity of pint."""
    units: Any


class OpenMMQuantity(Protocol):
    """A quantity of openmm.unit."""
    unit: Any


Path: TypeAlias = str | os.PathLike[str]
Text: TypeAlias = str | os.PathLike[str]  # of a setting; a path if the text is the name of a file
Quantity: TypeAlias = str | PintQuantity | OpenMMQuantity
Texts: TypeAlias = str | list[str] | tuple[str, ...]
Source: TypeAlias = "Settings | Mapping[str, Any] | str | os.PathLike[str] | None"
Progress: TypeAlias = bool | Callable[[str, float | None, str], object] | None
Messages: TypeAlias = Callable[[str], object] | None
