# SPDX-License-Identifier: MIT
"""R against cost: studies of many schemes by the program, and the evaluation of their curves."""

import json
import subprocess
import sys
from math import exp, log


def study(o, run_file, prefix, scheme, steps):
    """Points of a scheme at steps [fs]; an interrupted study is resumed."""
    command = [o.polhode, "study", str(run_file), "--schemes", scheme, "--steps", *(f"{h:g} fs" for h in steps),
               "--runs", str(o.runs), "--length", f"{o.length:g} ps", "--decorrelate", f"{o.decorrelate:g} ps",
               "--threads", str(o.threads), "--output", str(prefix), "--json"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    print(f"{run_file.stem}: {scheme} done", file=sys.stderr, flush=True)
    return json.loads(done.stdout)["points"]


def by_scheme(points):
    """Points of each scheme, by increasing step."""
    result = {}
    for p in points:
        result.setdefault(p["scheme"], []).append(p)
    for own in result.values():
        own.sort(key=lambda p: p["step_fs"])
    return result


# A curve ends above this R, whatever its energy drift: ten times the R that such a study is for, and above every point at
# which longer runs detected no energy drift (docs/efficiency.md: velocity Verlet, 8.9 %).
LOST = 0.1


def usable(own):
    """The points of a curve before the first one with a blow-up or with R above LOST. An energy drift does not end a curve here: with
    two to four runs, that is one to three degrees of freedom, the test has almost no power. With two runs, an energy drift of twenty
    times its error has a p-value of 3 %; and at a level of 1 %, two of 200 points without energy drift would end their curves."""
    good = []
    for p in own:
        if not p["stable"] or p["R"] > LOST:
            break
        good.append(p)
    return good


def at_ratio(own, ratio):
    """(cost, step [fs]) of a curve at R, by interpolation in logarithms between neighbouring points that are usable;
    no extrapolation, but the longest usable step if its R is below the required one."""
    good = usable(own)
    if not good or good[0]["R"] > ratio:
        return None
    for a, b in zip(good, good[1:]):
        if a["R"] <= ratio < b["R"]:
            part = log(ratio / a["R"]) / log(b["R"] / a["R"])
            mix = lambda key: exp(log(a[key]) + part * log(b[key] / a[key]))
            return mix("force_evaluations_per_ps"), mix("step_fs")
    return good[-1]["force_evaluations_per_ps"], good[-1]["step_fs"]


def seconds_per_ps(o, run_file, chosen):
    """Wall-clock time of (scheme, step) pairs that run, energies not sampled: the minimum of interleaved repeats."""
    timed = run_file.with_name(f"{run_file.stem}-clock.toml")
    timed.write_text(run_file.read_text(encoding="utf-8") + f'[run]\nsample = "{o.clock:g} ps"\n'
                     '[output]\ntrajectory_every = "0 ps"\nplot = "none"\n', encoding="utf-8")
    best = {}
    for _ in range(o.repeats):
        for scheme, step in chosen:
            command = [o.polhode, "run", str(timed), "--scheme", scheme, "--step", f"{step:.3f} fs", "--length",
                       f"{o.clock:g} ps", "--threads", "1", "--force", "--json", "--output", str(o.folder / "clock")]
            run = subprocess.run(command, capture_output=True, text=True)
            if run.returncode != 0:  # near the stability limit another initial configuration may blow up
                print(f"{run_file.stem}: {scheme} at {step:.3g} fs is not timed: {run.stderr}", file=sys.stderr)
                continue
            done = json.loads(run.stdout)
            time = (done["seconds"]["all"] - done["seconds"]["energies_and_output"]) / done["length_ps"]
            best[scheme, step] = min(time, best.get((scheme, step), time))
    return best


def add_arguments(parser, runs, length, decorrelate, folder):
    """The options of every such study."""
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--precision", default="mixed", choices=("mixed", "double"))
    parser.add_argument("--runs", type=int, default=runs, help="runs at each point")
    parser.add_argument("--length", type=float, default=length, help="length of each run [ps]")
    parser.add_argument("--decorrelate", type=float, default=decorrelate, help="equilibration of each initial configuration [ps]")
    parser.add_argument("--threads", type=int, default=1, help="number of simultaneous runs; wall-clock times are those of a single one")
    parser.add_argument("--clock", type=float, default=2, help="length of a run whose time counts [ps]")
    parser.add_argument("--repeats", type=int, default=5, help="number of these timed runs, interleaved")
    parser.add_argument("--folder", default=folder, help="where the studies are stored, and resumed from")
    parser.add_argument("--output", default=f"{folder}.json")
    parser.add_argument("--figure", help="SVG or PNG")
