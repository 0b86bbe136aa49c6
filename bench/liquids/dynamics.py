# SPDX-License-Identifier: MIT
"""Diffusion, reorientation and dielectric constant of SPC/E and TIP4P/2005 at 298 K, by `polhode analyze` of runs at
constant energy with PME; values are means over independent runs, errors from their scatter."""

import argparse
import sys
from math import sqrt
from pathlib import Path
from statistics import fmean, stdev

import waters

sys.path.append(str(Path(__file__).resolve().parents[1]))
import machine  # noqa: E402

MODELS = [w for w in waters.WATERS if w.model in ("spce", "tip4p-2005")]


def analyzed(program, folder, water, o, seed):
    """The results of `polhode analyze` for one run; the frames are deleted once they are stored."""
    prefix = f"{water.model}-{seed}"
    if not (folder / f"{prefix}-analysis.json").exists():
        waters.made(program, folder, water, o.count, seed, waters.TEMPERATURE, o.equilibrate, o.length, o.every)
    result = waters.analyzed(program, folder, prefix, o.every, "--window", f"{o.window:g} ps", "--fit",
                             f"{o.window / 10:g} ps, {o.window:g} ps", "--what", "rdf,msd,rotation,dielectric,density")
    if not o.keep:
        (folder / f"{prefix}-trajectory.trr").unlink(missing_ok=True)
    return result


def number(found):
    """The value, or the estimate of a run that is too short for one: the mean over many runs may determine it."""
    return found["value"] if found["value"] is not None else found.get("unconverged_estimate")


def quantities(run):
    """{name: value} of one run."""
    part, found = run["parts"][0], {"T [K]": run["temperature_K"]["value"]}
    found["D in the box [1e-9 m2/s]"] = number(part["D_1e-9_m2_per_s"])
    if "D_without_images_1e-9_m2_per_s" in part:
        found["D without images [1e-9 m2/s]"] = number(part["D_without_images_1e-9_m2_per_s"])
    for axis, ranks in part["relaxation"].items():
        for rank, times in ranks.items():
            if "integral_ps" in times:
                found[f"tau {rank} {axis}, integral [ps]"] = number(times["integral_ps"])
                found[f"tau {rank} {axis}, exponential [ps]"] = number(times["exponential_ps"])
    found["dielectric constant"] = number(run["dielectric"]["constant"])
    return found


def table(results):
    """Means over the runs with their standard errors, in Markdown."""
    rows = ["| | runs | quantity | value |", "| --- | --- | --- | --- |"]
    for water, runs in results:
        numbers = [quantities(r) for r in runs]
        for name in numbers[0]:
            values = [n[name] for n in numbers if name in n]
            error = f" ± {stdev(values) / sqrt(len(values)):.3f}" if len(values) > 1 else ""
            rows.append(f"| {water.name} | {len(values)} | {name} | {fmean(values):.3f}{error} |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--runs", type=int, default=4, help="runs of each water model, each from another initial configuration")
    parser.add_argument("--count", type=int, default=512, help="waters in a run")
    parser.add_argument("--length", type=float, default=200, help="length of a run at constant energy [ps]")
    parser.add_argument("--equilibrate", type=float, default=20, help="length of the equilibration with velocity rescaling [ps]")
    parser.add_argument("--every", type=float, default=0.1, help="time between frames [ps]")
    parser.add_argument("--window", type=float, default=20, help="maximum lag of correlations [ps]")
    parser.add_argument("--folder", type=Path, default=Path("dynamics"), help="where results of runs are stored; finished "
                        "runs there are not made again")
    parser.add_argument("--keep", action="store_true", help="store the frames as well")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder.mkdir(parents=True, exist_ok=True)
    results = [(water, []) for water in MODELS]
    for seed in range(1, o.runs + 1):
        for water, runs in results:
            runs.append(analyzed(o.polhode, o.folder, water, o, seed))
            (o.folder / "table.md").write_text(table([r for r in results if r[1]]) + "\n", encoding="utf-8")
            print(f"{water.name}, run {seed} done", file=sys.stderr, flush=True)
    print(table(results))


if __name__ == "__main__":
    main()
