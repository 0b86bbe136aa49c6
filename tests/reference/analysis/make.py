# SPDX-License-Identifier: MIT
"""Analyses spce24.gro with MDAnalysis and mdtraj and writes the results to expected.json in this folder.

The frames are those of `polhode run spce24.toml`, positions only and with six decimals. Given that trajectory as
the argument, the script writes spce24.gro first. Needs Debian's python3-mdanalysis and python3-mdtraj.
"""

import json
import sys
import warnings
from pathlib import Path

import MDAnalysis
import mdtraj
import numpy
from MDAnalysis.analysis.dielectric import DielectricConstant
from MDAnalysis.analysis.msd import EinsteinMSD
from MDAnalysis.analysis.rdf import InterRDF
from MDAnalysis.analysis.waterdynamics import WaterOrientationalRelaxation

warnings.filterwarnings("ignore")
HERE = Path(__file__).resolve().parent
FRAMES, TEMPERATURE, LAGS = HERE / "spce24.gro", 298.0, 8
BINS, REACH = 20, 0.4  # of g(r); [nm]
CHARGES, MASSES = (-0.8476, 0.4238, 0.4238), (15.9994, 1.008, 1.008)


def thin(source, target):
    """A GRO trajectory without velocities and with six decimals."""
    lines, out = Path(source).read_text(encoding="utf-8").splitlines(), []
    at = 0
    while at < len(lines):
        count = int(lines[at + 1])
        out += lines[at : at + 2]
        for line in lines[at + 2 : at + 2 + count]:
            width = line.index(".", line.index(".") + 1) - line.index(".")
            x = (float(line[20 + k * width : 20 + (k + 1) * width]) for k in range(3))
            out.append(line[:20] + "".join(f"{v:11.6f}" for v in x))
        out.append(lines[at + 2 + count])
        at += 3 + count
    target.write_text("\n".join(out) + "\n", encoding="utf-8")


def frames():
    """Edges (3) and positions (frame, atom, 3) [nm] of the file, of which MDAnalysis would read one frame only."""
    lines = FRAMES.read_text(encoding="utf-8").splitlines()
    size = int(lines[1]) + 3
    places = [[[float(x) for x in line[20:].split()] for line in lines[at + 2 : at + size - 1]]
              for at in range(0, len(lines), size)]
    return numpy.array([float(x) for x in lines[size - 1].split()]), numpy.array(places)


def centres(edges, places):
    """Centres of mass (frame, molecule, 3) [nm], unwrapped."""
    path, found = None, []
    for r in places:
        q = numpy.average(r.reshape(-1, 3, 3), axis=1, weights=MASSES)  # molecules are whole in the file
        path = q if path is None else path + (q - last) - edges * numpy.round((q - last) / edges)
        last = q
        found.append(path)
    return numpy.array(found)


def main():
    if len(sys.argv) > 1:
        thin(sys.argv[1], FRAMES)
    edges, places = frames()
    universe = MDAnalysis.Universe(str(FRAMES))
    universe.load_new(10 * places, order="fac", dimensions=[*(10 * edges), 90, 90, 90])
    universe.add_TopologyAttr("charges", numpy.tile(CHARGES, 24))
    universe.add_TopologyAttr("masses", numpy.tile(MASSES, 24))
    universe.add_TopologyAttr("bonds", [(3 * i, 3 * i + k) for i in range(24) for k in (1, 2)])
    expected = {"versions": {"MDAnalysis": MDAnalysis.__version__, "mdtraj": mdtraj.version.version}}

    names = {"O": universe.select_atoms("name OW"), "H": universe.select_atoms("name HW1 HW2")}
    expected["rdf"] = {}
    for pair, block in (("OO", (1, 1)), ("OH", (1, 2)), ("HH", (2, 2))):
        rdf = InterRDF(names[pair[0]], names[pair[1]], nbins=BINS, range=(0, 10 * REACH), exclusion_block=block)
        rdf.run()
        expected["rdf"][pair] = [float(g) for g in rdf.results.rdf]

    q = centres(edges, places)
    moving = MDAnalysis.Universe.empty(q.shape[1], trajectory=True)
    moving.load_new(10 * q, order="fac")
    msd = EinsteinMSD(moving, select="all", msd_type="xyz", fft=False)
    msd.run()
    expected["msd"] = [float(x) / 100 for x in msd.results.timeseries[:LAGS]]

    # Second rank at the first lag; at longer lags MDAnalysis omits most time origins.
    lags = WaterOrientationalRelaxation(universe, "name OW HW1 HW2", 0, len(places), 2)
    lags.run()
    expected["P2"] = {"HH": float(lags.timeseries[0][1]), "dipole": float(lags.timeseries[0][2])}

    expected["dielectric"] = {"MDAnalysis": float(DielectricConstant(
        universe.atoms, temperature=TEMPERATURE, make_whole=False).run().results.eps_mean)}
    trajectory = mdtraj.load(str(FRAMES))
    assert trajectory.n_frames == len(places)
    expected["dielectric"]["mdtraj"] = float(mdtraj.geometry.static_dielectric(
        trajectory, numpy.tile(CHARGES, 24), TEMPERATURE))
    expected["density"] = float(mdtraj.density(trajectory, masses=numpy.tile(MASSES, 24)).mean())
    oxygens = range(0, 72, 3)
    _, g = mdtraj.compute_rdf(trajectory, [(i, j) for i in oxygens for j in oxygens if i < j], r_range=(0, REACH),
                              n_bins=BINS)
    expected["rdf_mdtraj_OO"] = [float(x) for x in g]
    (HERE / "expected.json").write_text(json.dumps(expected, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
