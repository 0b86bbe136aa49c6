# SPDX-License-Identifier: MIT
"""Are the errors that `polhode analyze` states those that values have? Long runs at constant energy are cut into pieces
of equal length, each is analysed alone, and the errors stated are compared with the scatter of the pieces about the mean
of their own run: runs differ in energy, and so in temperature, which no piece can know."""

import argparse
import json
import struct
import subprocess
import sys
from math import sqrt
from pathlib import Path
from statistics import fmean
from typing import NamedTuple

sys.path.append(str(Path(__file__).resolve().parents[1]))
import machine  # noqa: E402

RUN_FILE = """[system]
molecules = [{{ model = "{model}", count = {count} }}]
density = "{density}"
temperature = "{temperature} K"
seed = {seed}
[forces]
{electrostatics}cutoff = "{cutoff} nm"
precision = "mixed"
[integrator]
scheme = "hoa2"
step = "{step} fs"
[run]
equilibrate = "20 ps"
length = "{length:g} ps"
sample = "{sample} fs"
[output]
prefix = "{name}"
trajectory_every = "{every:g} ps"
formats = ["trr"]
plot = "none"
"""


class System(NamedTuple):
    name: str
    model: str
    count: int
    density: str
    temperature: float  # [K]
    electrostatics: str
    cutoff: float  # [nm]
    step: int  # [fs]
    sample: int  # [fs]
    every: float  # between frames [ps]


FIELD = 'electrostatics = "reaction-field"\n'
SYSTEMS = (System("64 TIP4P", "tip4p", 64, "0.997 g/cm3", 300, FIELD, 0.6, 4, 100, 0.2),
           System("108 argon", "argon", 108, "1.4 g/cm3", 90, "", 0.8, 10, 100, 0.2))


def made(o, system, seed):
    """The trajectory of one run, made or from the folder."""
    name = f"{system.model}-{system.count}-{seed}"
    path = o.folder / f"{name}-trajectory.trr"
    if not path.exists():
        text = RUN_FILE.format(**system._asdict() | {"name": name}, seed=seed, length=o.length)
        (o.folder / f"{name}.toml").write_text(text, encoding="utf-8")
        subprocess.run([o.polhode, "run", f"{name}.toml", "--threads", "1", "--force"], cwd=o.folder, check=True,
                       stdout=subprocess.DEVNULL)
    return path


def frame_bytes(data):
    """Bytes of a TRR frame; all are alike in a file of one run."""
    length = struct.unpack(">3i", data[:12])[2]
    at = 12 + (length + 3) // 4 * 4
    sizes = struct.unpack(">13i", data[at : at + 52])  # ten sizes of blocks, atoms, step, nre; then two reals
    return at + 52 + 2 * (sizes[2] // 9) + sum(sizes[:10])


def pieces(o, path, system, length):
    """{quantity: (value, error or None)} of each piece of a run, stored in the same folder."""
    kept = path.with_name(f"{path.stem}-{length:g}-{o.window:g}.json")
    if not kept.exists():
        data, found = path.read_bytes(), []
        size = frame_bytes(data) * round(length / system.every)
        piece = o.folder / "piece.trr"
        for k in range(len(data) // size):
            piece.write_bytes(data[k * size : (k + 1) * size])
            done = subprocess.run(
                [o.polhode, "analyze", piece.name, "--run", f"{path.stem.removesuffix('-trajectory')}.toml", "--window",
                 f"{o.window:g} ps", "--plot", "none", "--threads", "1", "--force", "--json",
                 "--output", "piece"], cwd=o.folder, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                text=True)
            found.append(quantities(json.loads(done.stdout)))
        kept.write_text(json.dumps(found), encoding="utf-8")
    return json.loads(kept.read_text(encoding="utf-8"))


def quantities(said):
    """Every value that has an error, by name."""
    found = {}

    def take(name, pair):
        if pair and pair["value"] is not None:
            found[name] = (pair["value"], pair["error"])

    take("T [K]", said.get("temperature_K"))
    for g in said.get("rdf", []):
        name = "-".join(g["pair"])
        take(f"peak of g {name}: position [nm]", g["peak_nm"])
        take(f"peak of g {name}: height", g["peak_height"])
        take(f"peak of g {name}: coordination", g["coordination"])
    part = said["parts"][0]
    take("D, displacements [1e-9 m2/s]", part.get("D_1e-9_m2_per_s"))
    take("D, velocities [1e-9 m2/s]", part.get("D_green_kubo_1e-9_m2_per_s"))
    for axis, ranks in part.get("relaxation", {}).items():
        for rank, times in ranks.items():
            for kind in ("integral", "exponential"):
                take(f"{rank} {axis}, {kind} [ps]", times.get(f"{kind}_ps"))
    take("dielectric constant", said.get("dielectric", {}).get("constant"))
    take("Kirkwood factor", said.get("dielectric", {}).get("kirkwood"))
    return found


def compared(runs, name):
    """(pieces, fraction with an error, scatter, rms and mean stated error over the scatter) of a quantity; only pieces
    with an error count for the last three."""
    squares = freedom = told = every = 0
    stated = []
    for run in runs:
        every += len(run)
        values = [p[name] for p in run if name in p and p[name][1] is not None]
        told += len(values)
        if len(values) > 1:
            centre = fmean(v for v, _ in values)
            squares += sum((v - centre) ** 2 for v, _ in values)
            freedom += len(values) - 1
            stated += [error for _, error in values]
    if freedom < 2 or squares == 0:
        return every, told / every, None, None, None
    scatter = sqrt(squares / freedom)
    return every, told / every, scatter, sqrt(fmean(e * e for e in stated)) / scatter, fmean(stated) / scatter


def table(results):
    rows = ["| | length [ps] | quantity | pieces | with an error | scatter | stated error, rms, over scatter | its mean |",
            "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for r in results:
        numbers = [f"{r[k]:.3g}" if r[k] is not None else "" for k in ("scatter", "rms", "mean")]
        rows.append(f"| {r['system']} | {r['length_ps']:g} | {r['quantity']} | {r['pieces']} | {r['told']:.2f} | "
                    + " | ".join(numbers) + " |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--runs", type=int, default=4, help="runs of each system")
    parser.add_argument("--length", type=float, default=2000, help="length of a run [ps]")
    parser.add_argument("--pieces", type=float, nargs="+", default=[25, 50, 100, 200], help="lengths of the parts [ps]")
    parser.add_argument("--window", type=float, default=5, help="maximum lag of correlations [ps]")
    parser.add_argument("--systems", nargs="+", default=[s.model for s in SYSTEMS], help="models")
    parser.add_argument("--folder", type=Path, default=Path("calibration"), help="where runs and results are stored")
    parser.add_argument("--output", type=Path, help="prefix of the files: a table (.md) and all results (.json)")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder.mkdir(parents=True, exist_ok=True)
    results = []
    for system in (s for s in SYSTEMS if s.model in o.systems):
        paths = [made(o, system, seed) for seed in range(1, o.runs + 1)]
        for length in o.pieces:
            runs = [pieces(o, path, system, length) for path in paths]
            for name in dict.fromkeys(n for run in runs for p in run for n in p):
                keys = ("pieces", "told", "scatter", "rms", "mean")
                results.append({"system": system.name, "length_ps": length, "quantity": name}
                               | dict(zip(keys, compared(runs, name))))
            print(f"{system.name}, {length:g} ps done", file=sys.stderr, flush=True)
    print(table(results))
    if o.output:
        o.output.with_suffix(".json").write_text(json.dumps({"processor": machine.processor(), "results": results},
                                                            indent=1) + "\n", encoding="utf-8")
        o.output.with_suffix(".md").write_text(table(results) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
