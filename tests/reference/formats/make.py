# SPDX-License-Identifier: MIT
"""Writes two frames of eight SPC/E waters with GROMACS, MDAnalysis, mdtraj and h5py, to this folder.

The positions are those of the first frames of ../analysis/spce24.gro; velocities are made up. expected.json holds all numbers
as they were given to the programs. Needs Debian's gromacs, python3-mdanalysis, python3-mdtraj and python3-h5py.
"""

import json
import subprocess
import tempfile
import warnings
from pathlib import Path

import h5py
import MDAnalysis
import mdtraj
import numpy

warnings.filterwarnings("ignore")
HERE = Path(__file__).resolve().parent
WATERS, FRAMES, TIMES = 8, 2, [0.0, 0.5]  # [ps]
BOX = [0.9, 1.0, 1.1]  # nm
NAMES = ["OW", "HW1", "HW2"]


def places():
    """The first atoms of the first frames [nm]."""
    lines = (HERE.parent / "analysis" / "spce24.gro").read_text(encoding="utf-8").splitlines()
    count = int(lines[1])
    frames = [lines[f * (count + 3) + 2:][:3 * WATERS] for f in range(FRAMES)]
    return numpy.array([[[float(x) for x in line[20:].split()[:3]] for line in frame] for frame in frames])


def gro(r, v):
    """Both frames as GROMACS reads them, with six decimals."""
    out = []
    for f, time in enumerate(TIMES):
        out += [f"water t= {time:.3f}", f"{3 * WATERS:5d}"]
        for i in range(3 * WATERS):
            numbers = "".join(f"{x:11.6f}" for x in r[f, i]) + "".join(f"{x:11.7f}" for x in v[f, i])
            out.append(f"{i // 3 + 1:5d}{'SOL':5s}{NAMES[i % 3]:>5s}{i + 1:5d}{numbers}")
        out.append("".join(f"{x:10.5f}" for x in BOX))
    return "\n".join(out) + "\n"


def gromacs(text):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "in.gro").write_text(text, encoding="utf-8")
        for program, name in (("gmx", "gromacs.xtc"), ("gmx", "gromacs.trr"), ("gmx_d", "gromacs_double.trr")):
            subprocess.run([program, "trjconv", "-f", "in.gro", "-s", "in.gro", "-o", HERE / name], cwd=folder, input="0\n",
                           text=True, check=True, capture_output=True)
    for rest in HERE.glob("#*"):
        rest.unlink()


def universe(r, v):
    u = MDAnalysis.Universe.empty(3 * WATERS, n_residues=WATERS, atom_resindex=numpy.arange(3 * WATERS) // 3, trajectory=True,
                                  velocities=True)
    u.add_TopologyAttr("name", NAMES * WATERS)
    u.add_TopologyAttr("resname", ["SOL"] * WATERS)
    u.add_TopologyAttr("element", ["O", "H", "H"] * WATERS)
    for ending in ("pdb", "trr", "xtc", "dcd", "h5md"):
        options = {"multiframe": True} if ending == "pdb" else {"n_atoms": 3 * WATERS}
        if ending == "dcd":
            options["dt"] = TIMES[1] - TIMES[0]
        if ending == "h5md":
            options.update(positions=True, velocities=True, forces=False, lengthunit="Angstrom", velocityunit="Angstrom/ps",
                           timeunit="ps", compression="gzip", compression_opts=9)
        with MDAnalysis.Writer(str(HERE / f"mdanalysis.{ending}"), **options) as writer:
            for f, time in enumerate(TIMES):
                u.atoms.positions, u.atoms.velocities = 10 * r[f], 10 * v[f]
                u.dimensions = [10 * x for x in BOX] + [90, 90, 90]
                u.trajectory.ts.time, u.trajectory.ts.frame = time, f
                u.trajectory.ts.data.update(step=f)
                writer.write(u.atoms)


def big_endian():
    """MDAnalysis's DCD file as a machine with the opposite byte order writes it: the bytes of every number are swapped."""
    data = bytearray((HERE / "mdanalysis.dcd").read_bytes())
    at, record = 0, 0
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "little")
        # Head: letters, then words; titles: a word, then letters; cell: doubles; the rest: words.
        letters, width = {0: (4, 4), 1: (length, 4)}.get(record, (0, 8 if length == 48 else 4))
        begin, end = at + 4, at + 4 + length
        if record == 1:
            data[begin:begin + 4] = data[begin:begin + 4][::-1]
        for k in range(begin + letters, end, width):
            data[k:k + width] = data[k:k + width][::-1]
        for mark in (at, end):
            data[mark:mark + 4] = data[mark:mark + 4][::-1]
        at, record = end + 4, record + 1
    (HERE / "big_endian.dcd").write_bytes(data)


def of_mdtraj(r):
    topology = mdtraj.Topology()
    chain = topology.add_chain()
    for _ in range(WATERS):
        residue = topology.add_residue("HOH", chain)
        for name in ("O", "H1", "H2"):
            topology.add_atom(name, mdtraj.element.Element.getBySymbol(name[0]), residue)
    frames = mdtraj.Trajectory(r, topology, time=TIMES, unitcell_lengths=[BOX] * FRAMES, unitcell_angles=[[90] * 3] * FRAMES)
    for ending in ("pdb", "xtc", "trr", "dcd"):
        getattr(frames, f"save_{ending}")(str(HERE / f"mdtraj.{ending}"))


def of_h5py(r, v):
    """The layout of H5MD 1.1 in its plainest form: strings of fixed length, a fixed box, pm, the time between frames."""
    with h5py.File(HERE / "h5py.h5md", "w") as file:
        file.create_group("h5md").attrs["version"] = [1, 1]
        group = file.create_group("particles/water")
        box = group.create_group("box")
        box.attrs["dimension"], box.attrs["boundary"] = 3, numpy.array(["periodic"] * 3, dtype="S8")
        box["edges"] = 1000 * numpy.array(BOX)
        box["edges"].attrs["unit"] = numpy.bytes_("pm")
        for name, values, unit in (("position", 1000 * r, "pm"), ("velocity", 1000 * v, "pm ps-1")):
            element = group.create_group(name)
            element["step"], element["time"] = 1, TIMES[1]
            element["time"].attrs["unit"] = numpy.bytes_("ps")
            element["value"] = values
            element["value"].attrs["unit"] = numpy.bytes_(unit)


def main():
    r = places()
    v = numpy.random.default_rng(1).normal(0, 1, r.shape).round(6)
    (HERE / "expected.json").write_text(json.dumps({"times": TIMES, "box": BOX, "positions": r.tolist(), "velocities": v.tolist()})
                                        + "\n", encoding="utf-8")
    gromacs(gro(r, v))
    universe(r, v)
    big_endian()
    of_mdtraj(r)
    of_h5py(r, v)


if __name__ == "__main__":
    main()
