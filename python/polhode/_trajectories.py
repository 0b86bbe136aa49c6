# SPDX-License-Identifier: MIT
"""Trajectories for MDAnalysis and mdtraj that need no file."""

import numpy as np

from .errors import Error

ANGSTROM_PER_NM = 10


def sites_of(simulation):
    """(molecule name, index of the molecule, site) of each site."""
    row, index = [], 0
    for kind, (_, count) in zip(simulation.kinds, simulation.molecules, strict=True):
        for _ in range(count):
            row += [(kind.name, index, site) for site in kind.sites]
            index += 1
    if not row:
        raise Error("there are no molecules")
    return row


def check_frames(simulation, frames):
    if simulation is None:
        raise Error("a run that was pickled has no molecules; convert it before it is pickled")
    if not frames:
        raise Error("the run kept no frames; call run(..., frames=\"0.1 ps\")")


def universe(simulation, frames):
    """MDAnalysis.Universe of the frames; lengths are in Å."""
    check_frames(simulation, frames)
    try:
        import MDAnalysis
        from MDAnalysis.coordinates.memory import MemoryReader
    except ImportError:
        raise Error("this needs MDAnalysis, which is not installed; pip install MDAnalysis") \
            from None
    sites = sites_of(simulation)
    residue_of = np.array([index for _, index, _ in sites])
    u = MDAnalysis.Universe.empty(len(sites), n_residues=residue_of[-1] + 1,
                                  atom_resindex=residue_of, trajectory=False)
    residues = {index: name for name, index, _ in sites}
    u.add_TopologyAttr("names", [s["name"] for _, _, s in sites])
    u.add_TopologyAttr("types", [s["element"] or "X" for _, _, s in sites])
    u.add_TopologyAttr("elements", [s["element"] for _, _, s in sites])
    u.add_TopologyAttr("masses", [s["mass"] for _, _, s in sites])
    u.add_TopologyAttr("charges", [s["charge"] for _, _, s in sites])
    u.add_TopologyAttr("resnames", [residues[i] for i in range(len(residues))])
    u.add_TopologyAttr("resids", np.arange(1, len(residues) + 1))
    positions = np.array([r for _, _, r in frames]) * ANGSTROM_PER_NM
    boxes = np.array([[*(box * ANGSTROM_PER_NM), 90, 90, 90] for _, box, _ in frames])
    dt = frames[1][0] - frames[0][0] if len(frames) > 1 else 1.0
    u.load_new(positions.astype(np.float32), format=MemoryReader, order="fac", dimensions=boxes,
               dt=dt)
    return u


def mdtraj_trajectory(simulation, frames):
    """mdtraj.Trajectory of the frames; lengths are in nm."""
    check_frames(simulation, frames)
    try:
        import mdtraj
    except ImportError:
        raise Error("this needs mdtraj, which is not installed; pip install mdtraj") from None
    top = mdtraj.Topology()
    chain, residue, last = top.add_chain(), None, -1
    for name, index, site in sites_of(simulation):
        if index != last:
            residue, last = top.add_residue(name, chain), index
        element = mdtraj.element.get_by_symbol(site["element"]) if site["element"] else \
            mdtraj.element.virtual
        top.add_atom(site["name"], element, residue)
    return mdtraj.Trajectory(np.array([r for _, _, r in frames]), top,
                             time=np.array([t for t, _, _ in frames]),
                             unitcell_lengths=np.array([box for _, box, _ in frames]),
                             unitcell_angles=np.full((len(frames), 3), 90.0))
