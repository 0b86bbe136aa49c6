# SPDX-License-Identifier: MIT
"""A test of the errors that `polhode analyze` states. Long runs at constant energy are divided into segments of equal
length, which are analysed separately. The stated errors are compared with the scatter of the segments about the mean of
their run. Runs differ in energy and temperature, and a segment cannot show this difference."""

import struct
from pathlib import Path
from statistics import fmean

import numpy as np
from lib import runs, study
from lib.statistics import rms

SYSTEMS = {  # [system], [forces], step [fs]
    "64 TIP4P": (("tip4p", 64), {"density": "0.997 g/cm3", "temperature": "300 K"}, {"electrostatics": "reaction-field", "cutoff": "0.6 nm"}, 4),
    "108 argon": (("argon", 108), {"density": "1.4 g/cm3", "temperature": "90 K"}, {"cutoff": "0.8 nm"}, 10),
}
EVERY = 0.2  # between frames [ps]


def quantities(said):
    """Every value that has an error, by name."""
    part, found = said["parts"][0], {"T [K]": said.get("temperature_K")}
    for g in said.get("rdf", []):
        name = "peak of g " + "-".join(g["pair"])
        found |= {f"{name}: position [nm]": g["peak_nm"], f"{name}: height": g["peak_height"], f"{name}: coordination": g["coordination"]}
    found |= {"D, displacements [1e-9 m2/s]": part.get("D_1e-9_m2_per_s"), "D, velocities [1e-9 m2/s]": part.get("D_green_kubo_1e-9_m2_per_s")}
    for axis, ranks in part.get("relaxation", {}).items():
        found |= {f"{rank} {axis}, {kind} [ps]": times.get(f"{kind}_ps") for rank, times in ranks.items() for kind in ("integral", "exponential")}
    found |= {"dielectric constant": said.get("dielectric", {}).get("constant"), "Kirkwood factor": said.get("dielectric", {}).get("kirkwood")}
    return {name: (pair["value"], pair["error"]) for name, pair in found.items() if pair and pair["value"] is not None}


def frame_bytes(data):
    """Size of a TRR frame in bytes, which is the same for all frames of a run."""
    at = 12 + (struct.unpack(">3i", data[:12])[2] + 3) // 4 * 4
    sizes = struct.unpack(">13i", data[at:at + 52])  # ten sizes of blocks, atoms, step, nre; then two reals
    return at + 52 + 2 * (sizes[2] // 9) + sum(sizes[:10])


def segments(o, system, seed, folder):
    """{length [ps]: the quantities of each segment} of one run."""
    molecules, place, forces, step = SYSTEMS[system]
    name = f"{molecules[0]}-{seed}"
    tables = {"system": {"molecules": runs.molecules(*molecules), **place, "seed": seed}, "forces": {**forces, "precision": "mixed"},
              "integrator": {"scheme": "hoa2", "step": f"{step} fs"},
              "run": {"equilibrate": f"{min(20, o.length / 4):g} ps", "length": f"{o.length:g} ps", "sample": "100 fs"},
              "output": {"prefix": name, "trajectory_every": f"{EVERY:g} ps", "formats": ["trr"], "plot": "none"}}
    runs.kept(folder, name, lambda: runs.run(o, tables, folder, name=name))

    frames = Path(folder, f"{name}-trajectory.trr").read_bytes()
    frame = frame_bytes(frames)

    def one(length, k):
        size = frame * round(length / EVERY)
        Path(folder, f"{name}-segment.trr").write_bytes(frames[k * size:(k + 1) * size])
        return quantities(runs.asked(o, "analyze", f"{name}-segment.trr", "--run", f"{name}.toml", "--window", f"{o.window:g} ps", "--plot", "none",
                                     "--threads", 1, "--force", "--output", f"{name}-segment", folder=folder))

    return {length: [one(length, k) for k in range(int(len(frames) / frame * EVERY / length + 1e-6))] for length in o.pieces}


def compared(of_runs, name):
    """(segments, fraction with an error, scatter, rms and mean stated error over the scatter) of a quantity. The last three
    include only segments with an error."""
    every = sum(map(len, of_runs))
    own = [[p[name] for p in run if name in p and p[name][1] is not None] for run in of_runs]
    told = sum(map(len, own)) / every
    own = [np.array(values, dtype=float) for values in own if len(values) > 1]
    freedom = sum(len(values) - 1 for values in own)
    squares = sum(((values[:, 0] - values[:, 0].mean()) ** 2).sum() for values in own)
    if freedom < 2 or squares == 0:
        return every, told, None, None, None
    scatter, stated = float(np.sqrt(squares / freedom)), np.concatenate([values[:, 1] for values in own])
    return every, told, scatter, rms(stated) / scatter, fmean(stated) / scatter


def measured(o):
    results = []
    with runs.scratch(o) as folder:
        for system in o.systems:
            found = runs.parallel(o, lambda seed: segments(o, system, seed, folder), range(1, o.runs + 1))
            for length in o.pieces:
                of_runs = [f[length] for f in found]
                for name in dict.fromkeys(n for run in of_runs for p in run for n in p):
                    results.append({"system": system, "length_ps": length, "quantity": name}
                                   | dict(zip(("pieces", "told", "scatter", "rms", "mean"), compared(of_runs, name))))
    return {"results": results}


def report(result):
    number = lambda x: "" if x is None else f"{x:.3g}"
    return study.table(["", "length [ps]", "quantity", "segments", "with an error", "scatter", "stated error, rms, over scatter", "its mean"],
                       [[r["system"], f"{r['length_ps']:g}", r["quantity"], r["pieces"], f"{r['told']:.2f}", *(number(r[k]) for k in ("scatter", "rms", "mean"))]
                        for r in result["results"]])


if __name__ == "__main__":
    o = study.options(__doc__, {"systems": ["108 argon"], "runs": 1, "length": 6.0, "pieces": [2.0], "window": 0.4}, systems=(list(SYSTEMS), "systems"),
                      runs=(4, "runs of each system"), length=(2000.0, "length of a run [ps]"), pieces=([25.0, 50.0, 100.0, 200.0], "lengths of the segments [ps]"),
                      window=(5.0, "maximum lag of correlations [ps]"))
    study.perform(o, measured, report)
