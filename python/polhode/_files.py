# SPDX-License-Identifier: MIT
"""Coordinate files and trajectories of every format, as arrays."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import reals
from ._guard import Guarded
from ._types import Path
from .errors import Error


class Frame(Guarded):
    """The atoms at one time.

    Attributes:
        positions (numpy.ndarray): (n, 3) [nm]
        velocities (numpy.ndarray or None): (n, 3) [nm/ps]
        box (numpy.ndarray): edges (3) [nm]
        time (float): [ps]
        title (str)
        names, residues, elements (list of str): of each atom
        molecules (numpy.ndarray): number of the molecule of each atom (n)
    """

    __slots__ = ("positions", "velocities", "box", "time", "title", "names", "residues", "elements",
                 "molecules")

    def __init__(self, positions: np.ndarray, velocities: np.ndarray | None = None,
                 box: ArrayLike = (0, 0, 0), time: float = 0.0, names: list[str] | None = None,
                 residues: list[str] | None = None, elements: list[str] | None = None,
                 molecules: np.ndarray | None = None, title: str = "") -> None:
        self.positions, self.velocities = positions, velocities
        self.box, self.time, self.title = np.asarray(box, dtype=float), float(time), title
        n = len(positions)
        self.names, self.residues = names or ["X"] * n, residues or ["MOL"] * n
        self.elements = elements or [""] * n
        self.molecules = np.arange(1, n + 1) if molecules is None else molecules

    def __len__(self):
        return len(self.positions)

    def __repr__(self):
        return f"<Frame of {len(self)} atoms at {self.time:g} ps>"


def _frame(core):
    kinds = core.kinds
    of = {name: np.array(getattr(core, name), dtype=object)[kinds].tolist()
          for name in ("names", "residues", "elements")}
    return Frame(core.positions, core.velocities if core.has_velocities else None, core.box,
                 core.time, molecules=core.molecules, title=core.title, **of)


def read_frames(path: Path, names: Path | None = None) -> Iterator[Frame]:
    """Yields the frames of a file one after the other. A single frame is in memory at a time.

    Args:
        path: in any format of the program: gro, pdb, xyz, xtc, trr, dcd, h5md, a LAMMPS data file.
        names: coordinate file with the names of the atoms, for formats without them.

    Raises:
        Error: with file and line or offset, if the file cannot be read.
    """
    core = _core.OpenFrames(os.fspath(path), "" if names is None else os.fspath(names))
    while core.next():
        yield _frame(core)


def read(path: Path, names: Path | None = None) -> Frame:
    """The first frame of a file. Arguments and errors are as for read_frames().

    Returns:
        Frame
    """
    for frame in read_frames(path, names):
        return frame
    raise Error(f"'{path}' has no frame")


def _array(values, n, name):
    array = np.ascontiguousarray(reals(values, name))
    if array.shape != (n, 3):
        raise Error(f"{name} has the shape {array.shape}, and must have ({n}, 3)")
    if not np.isfinite(array).all():
        raise Error(f"{name} has numbers that are not finite")
    return array


def _writable(frame):
    """The library's frame with the names of this frame."""
    kinds, index = {}, np.empty(len(frame), dtype=np.int64)
    for name in ("residues", "names", "elements", "molecules"):
        if (given := len(getattr(frame, name))) != len(frame):
            raise Error(f"{name} has {given} entries, but the frame has {len(frame)} atoms; give one entry for each atom")
    for i, kind in enumerate(zip(frame.residues, frame.names, frame.elements, strict=True)):
        index[i] = kinds.setdefault(tuple(map(str, kind)), len(kinds))
    columns = [list(c) for c in zip(*kinds, strict=True)] or [[], [], []]
    molecules = np.ascontiguousarray(frame.molecules, dtype=np.int64)
    return _core.FrameToWrite(*columns, index, molecules)


def write(path: Path, frames: Frame | Iterable[Frame], force: bool = False) -> None:
    """Writes frames to a file. The extension selects the format.

    Args:
        path: file to write.
        frames: a Frame, or an iterable of frames with the same atoms.
        force (bool): overwrite the file if it exists.

    Raises:
        Error: if the format is not known, or arrays have wrong shapes.
    """
    frames = iter([frames] if isinstance(frames, Frame) else frames)
    first = next(frames, None)
    if first is None:
        raise Error("there is no frame to write")
    core = _writable(first)
    writer = _core.create_frames(os.fspath(path), force)
    for frame in (first, *frames):
        n = len(first)
        v = None if frame.velocities is None else _array(frame.velocities, n, "velocities")
        core.set(_array(frame.positions, n, "positions"), v,
                 _array([frame.box], 1, "box")[0].tolist(), frame.time)
        writer.write(core)
