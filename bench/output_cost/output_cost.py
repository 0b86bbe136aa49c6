# SPDX-License-Identifier: MIT
"""The cost of writing files in a run: trajectories of 512 TIP4P waters in each format, and checkpoints of a large system.

The time for energies and output in the summary of a run is divided by the time for everything else. The same ratio of a
run without trajectory (or without checkpoints between steps) in the same round is subtracted. Other load on the machine
slows all parts of a run equally. Medians over the rounds, with the quartiles."""

import argparse
import json
import sys
import tempfile
from datetime import date
from pathlib import Path
from statistics import median, quantiles
from subprocess import DEVNULL, PIPE, run

sys.path.append(str(Path(__file__).resolve().parents[1]))
import water  # noqa: E402
from lib import study  # noqa: E402

NEVER = 1e6  # [s]


def seconds(o, waters, length, form="xtc", every=0.0, checkpoint=NEVER):
    """The parts of the time of a run, and the number of bytes in files with a word in their names."""
    with tempfile.TemporaryDirectory(dir=o.folder) as folder:
        on_lattice = waters != 512
        Path(folder, "run.toml").write_text(water.run_file(
            waters, None if on_lattice else "w512", system={"density": "0.997 g/cm3"} if on_lattice else {},
            forces={"precision": "mixed"}, integrator={"step": "4 fs"}, run={"equilibrate": "0 ps", "length": f"{length:g} ps"},
            output={"trajectory_every": f"{every:g} ps", "formats": [form], "checkpoint_every": f"{checkpoint:g} s"}))
        done = run([o.program, "run", "run.toml", "--threads", "1", "--json"], cwd=folder, check=True,
                   stdout=PIPE, stderr=DEVNULL, text=True)
        summary = json.loads(done.stdout)
        size = lambda word: sum(path.stat().st_size for path in Path(folder).glob(f"*-{word}*"))
        return {"steps": summary["steps"], "trajectory": size("trajectory"), "checkpoint": size("checkpoint.bin"),
                **summary["seconds"]}


def share(times):
    return times["energies_and_output"] / (times["all"] - times["energies_and_output"])


def spread(values):
    low, _, high = quantiles(values, n=4) if len(values) > 1 else (values[0],) * 3
    return {"median": median(values), "quartiles": [low, high]}


def trajectories(o):
    """For each format and interval, the share of output minus the share in a run without trajectory."""
    found = {(form, every): [] for form in o.formats for every in o.every}
    size = {}
    for _ in range(o.rounds):
        without = share(seconds(o, 512, o.length))
        for form, every in found:
            times = seconds(o, 512, o.length, form, every)
            found[form, every].append(share(times) - without)
            size[form] = times["trajectory"] / (1 + round(o.length / every))
    return [{"format": form, "every_ps": every, "share": spread(shares), "bytes_a_frame": size[form]}
            for (form, every), shares in found.items()]


def checkpoints(o):
    """Seconds and bytes of a checkpoint, and its share of a run at the default interval of 300 s."""
    taken, length = [], 0.004 * o.steps
    for _ in range(o.rounds):
        without, often = seconds(o, o.waters, length), seconds(o, o.waters, length, checkpoint=1e-6)
        rest = lambda times: times["all"] - times["energies_and_output"]
        # Output time of a run with a checkpoint at every step, minus the output time without checkpoints.
        extra = often["energies_and_output"] - share(without) * rest(often)
        taken.append(extra / (often["steps"] - 1))
    cost = spread(taken)
    return {"waters": o.waters, "bytes": often["checkpoint"], "seconds": cost, "share_at_300_s": cost["median"] / 300}


def tables(result):
    rows = ["| every | format | share of the run [%] | quartiles [%] | bytes a frame |", "| --- | --- | --- | --- | --- |"]
    for t in sorted(result["trajectories"], key=lambda t: t["every_ps"]):
        low, high = t["share"]["quartiles"]
        rows.append(f"| {t['every_ps']:g} ps | {t['format']} | {100 * t['share']['median']:.2f} "
                    f"| {100 * low:.2f} to {100 * high:.2f} | {t['bytes_a_frame']:.0f} |")
    c = result["checkpoints"]
    low, high = c["seconds"]["quartiles"]
    rows += ["", f"A checkpoint of {c['waters']} waters: {c['bytes'] / 1e6:.1f} MB in {c['seconds']['median']:.3f} s "
                 f"({low:.3f} to {high:.3f}), {100 * c['share_at_300_s']:.3f} % of a run with one every 5 min."]
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode", help="path of polhode")
    parser.add_argument("--formats", nargs="+", default=["xtc", "trr", "dcd", "gro", "pdb", "xyz", "h5md"])
    parser.add_argument("--every", nargs="+", type=float, default=[0.1, 1], help="time between frames [ps]")
    parser.add_argument("--length", type=float, default=5, help="length of each run [ps]")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--waters", type=int, default=100000, help="waters in the system of the checkpoints")
    parser.add_argument("--steps", type=int, default=20, help="steps between checkpoints")
    parser.add_argument("--folder", type=Path, default=Path(tempfile.gettempdir()), help="a folder on the disk to be tested")
    parser.add_argument("--output", type=Path, default=Path(f"{date.today()}-writing"))
    o = parser.parse_args()
    o.program = study.program(o.program)
    result = {"machine": study.processor(), "date": str(date.today()), "length_ps": o.length, "rounds": o.rounds,
              "trajectories": trajectories(o), "checkpoints": checkpoints(o)}
    o.output.with_suffix(".json").write_text(json.dumps(result, indent=1) + "\n")
    o.output.with_suffix(".md").write_text(
        f"# {date.today()}, {study.processor()}: what writing costs\n\n`bench/output_cost/output_cost.py --length {o.length:g} "
        f"--rounds {o.rounds} --waters {o.waters} --steps {o.steps}`\n\n{tables(result)}")
    print(tables(result))


if __name__ == "__main__":
    main()
