# SPDX-License-Identifier: MIT
"""Three-dimensional views of molecules in notebooks, with py3Dmol."""

import itertools

import numpy as np

from ._trajectories import ANGSTROM_PER_NM, check_frames, sites_of
from .errors import Error

# A page with more atoms is slow to load and to rotate.
MAX_ATOMS = 200_000
STYLE = {"stick": {"radius": 0.12}, "sphere": {"scale": 0.28}}


def _xyz(elements, positions):
    """A frame in XYZ format; the argument has positions in nm."""
    rows = [f"{e} {x:.3f} {y:.3f} {z:.3f}" for e, (x, y, z) in
            zip(elements, positions * ANGSTROM_PER_NM, strict=True)]
    return "\n".join([str(len(rows)), "", *rows, ""])


def _add_box(view, box):
    """The edges of a box [nm] with a corner at the origin."""
    edges = box * ANGSTROM_PER_NM
    corners = list(itertools.product((0, 1), repeat=3))
    for a, b in itertools.combinations(corners, 2):
        if sum(x != y for x, y in zip(a, b)) == 1:
            ends = [dict(zip("xyz", (edges * corner).tolist())) for corner in (a, b)]
            view.addLine({"start": ends[0], "end": ends[1], "color": "gray"})


def view_3d(simulation, frames, width, height, js):
    """A py3Dmol.view of frames (time, box, positions of all sites); several frames form an animation."""
    check_frames(simulation, frames)
    try:
        import py3Dmol
    except ImportError:
        raise Error("this needs py3Dmol, which is not installed; pip install py3Dmol") from None
    sites = [site for _, _, site in sites_of(simulation)]
    atoms = np.flatnonzero([site["mass"] > 0 for site in sites])
    if len(atoms) * len(frames) > MAX_ATOMS:
        what = f"{len(frames)} frames of {len(atoms)} atoms" if len(frames) > 1 else f"{len(atoms)} atoms"
        raise Error(f"{what} are too many for a view in a browser, which shows {MAX_ATOMS}; "
                    "write() a file for a program such as VMD or OVITO")
    elements = [sites[k]["element"] if sites[k]["element"].isalpha() else "X" for k in atoms]
    text = "".join(_xyz(elements, positions[atoms]) for _, _, positions in frames)
    view = py3Dmol.view(width=width, height=height, **({} if js is None else {"js": js}))
    if len(frames) == 1:
        view.addModel(text, "xyz")
    else:
        view.addModelsAsFrames(text, "xyz")
        view.animate({"loop": "forward", "interval": 80})
    view.setStyle(STYLE)
    _add_box(view, frames[0][1])
    view.rotate(20, "y")
    view.rotate(12, "x")
    view.zoomTo()
    view.zoom(1.5)
    return view
