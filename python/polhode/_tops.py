# SPDX-License-Identifier: MIT
"""Free rotation of arrays of tops, and the trajectory of a single top."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import reals
from .errors import Error
from ._jobs import _Job
from ._types import Messages, Path

METHODS = ("series", "closed", "theta", "recursive", "no-squish", "symmetric-product")


def _vectors(values, name):
    """An array of doubles with 3 components along the last axis."""
    array = reals(values, name)
    if array.ndim < 1 or array.shape[-1] != 3:
        raise Error(f"{name} has the shape {array.shape}, and its last axis must have 3 components")
    return array


def free_rotation(J: ArrayLike, L: ArrayLike, t: ArrayLike,
                  method: str = "series") -> tuple[np.ndarray, np.ndarray]:
    """The exact rotation of free rigid bodies over a time. All arguments are broadcast.

    Args:
        J: principal moments (..., 3), any order, one of them may be 0; any consistent units, such
            as u nm².
        L: angular momenta in the body frame (..., 3), such as u nm²/ps.
        t: times (...), such as ps; any sign.
        method (str): an exact method ("series" as in molecular dynamics, "closed", "theta" or "recursive"),
            or a method of second order ("no-squish" or "symmetric-product").

    Returns:
        (rotation, L): quaternions (..., 4), (w, x, y, z), with orientation(t) = orientation(0) *
        rotation, body to lab; and angular momenta in the body frame (..., 3).

    Raises:
        Error: if moments do not belong to a rigid body, or a number is not finite.
    """
    J, L = _vectors(J, "J"), _vectors(L, "L")
    t = reals(t, "t")
    try:
        shape = np.broadcast_shapes(J.shape[:-1], L.shape[:-1], t.shape)
    except ValueError:
        raise Error(f"J, L and t with the shapes {J.shape}, {L.shape} and {t.shape} cannot be "
                    "broadcast together") from None
    rows = [np.ascontiguousarray(np.broadcast_to(a, shape + (3,))).reshape(-1, 3) for a in (J, L)]
    times = np.ascontiguousarray(np.broadcast_to(t, shape)).reshape(-1)
    rotation, after = _core.rotations(*rows, times, method)
    return rotation.reshape(shape + (4,)), after.reshape(shape + (3,))


def rotation_matrix(q: ArrayLike) -> np.ndarray:
    """The matrices (..., 3, 3) of quaternions (..., 4), (w, x, y, z). They rotate from the body to the lab
    frame: r_lab = matrix @ r_body."""
    w, x, y, z = np.moveaxis(np.asarray(q, dtype=np.float64), -1, 0)
    rows = ((w*w + x*x - y*y - z*z, 2*(x*y - w*z), 2*(x*z + w*y)),
            (2*(x*y + w*z), w*w - x*x + y*y - z*z, 2*(y*z - w*x)),
            (2*(x*z - w*y), 2*(y*z + w*x), w*w - x*x - y*y + z*z))
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def _triple(values, name):
    array = _vectors(values, name)
    if array.shape != (3,):
        raise Error(f"{name} has the shape {array.shape}, and must have (3,)")
    return array.tolist()


def top(J: ArrayLike, L: ArrayLike, step: float | None = None, length: float | None = None, *,
        output: Path | None = None, force: bool = False, messages: Messages = None) -> np.ndarray:
    """The trajectory of a free top, computed exactly and by two integrators, as ``polhode top``.

    Args:
        J: principal moments of inertia in any consistent units: "1, 2, 3".
        L: body-frame angular momentum: "0.1, 0.2, 1".
        step (float): time step; default: a rotation by 0.2 rad per step.
        length (float): length of the trajectory; default: 200 steps.
        output: prefix of a figure of the polhode on the inertia ellipsoid: PREFIX.svg, .png, .dat, .gp.
        force (bool): overwrite output files that exist.
        messages: see Progress.

    Returns:
        numpy.ndarray: structured, one row per sample: "t"; for each of "exact", "series" and
        "no_squish" a "_rotation" (4) and an "_L" (3); for the last two an "_energy_error" and a
        "_momentum_error", relative, and an "_angle" to the exact orientation [rad].
    """
    J, L = _triple(J, "J"), _triple(L, "L")
    job = _Job(top, {**locals(), "progress": False})
    rows = job.call(_core.top, job.texts)
    fields = [("t", float), ("exact_rotation", float, 4), ("exact_L", float, 3)]
    for name in ("series", "no_squish"):
        fields += [(f"{name}_rotation", float, 4), (f"{name}_L", float, 3),
                   (f"{name}_energy_error", float), (f"{name}_momentum_error", float),
                   (f"{name}_angle", float)]
    return rows.view(fields).reshape(len(rows))


def rotate_table(path: Path, method: str = "series") -> str:
    """Rotates the tops of a CSV file, as ``polhode top --table``, and returns CSV text."""
    return _core.rotate_table({"table": os.fspath(path), "method": method})
