# SPDX-License-Identifier: MIT
"""R against cost: studies of many schemes by the program, and the evaluation of their curves."""

import itertools
import sys

import numpy as np

from . import runs, study

# A curve ends above this R, whatever its energy drift. This R is ten times the R at which the studies compare schemes, and
# above every R at which longer runs detected no energy drift (docs/evidence/efficiency.md: velocity Verlet, 8.9 %).
LOST = 0.1
COST = "force_evaluations_per_ps"


def options(doc, smoke, replicas, length, decorrelate, **own):
    """The options of every such study."""
    o = study.options(doc, {"runs": 2, "length": 0.2, "decorrelate": 0.02, "clock": 0.05, "repeats": 1, **smoke}, runs=(replicas, "runs at each point"),
                      length=(float(length), "length of each run [ps]"),
                      decorrelate=(float(decorrelate), "equilibration of each initial configuration [ps]"),
                      precision=("mixed", "of the forces"), clock=(2.0, "length of a run whose time counts [ps]"),
                      repeats=(5, "number of these timed runs, interleaved"), **own)
    if not o.folder and not o.report:
        o.folder = o.record.resolve().with_suffix("")
        o.folder.mkdir(parents=True, exist_ok=True)
    return o


def points(o, tables, name, curves):
    """Points of (scheme, steps [fs]); an interrupted study is resumed."""
    (o.folder / f"{name}.toml").write_text(runs.run_file(**tables), encoding="utf-8")
    found = []
    for number, (scheme, steps) in enumerate(curves):
        found += runs.asked(o, "study", f"{name}.toml", "--schemes", scheme, "--steps", *(f"{h:g} fs" for h in steps), "--runs", o.runs,
                            "--length", f"{o.length:g} ps", "--decorrelate", f"{o.decorrelate:g} ps", "--threads", o.jobs,
                            "--output", f"{name}-{number}", folder=o.folder)["points"]
    return found


def by_scheme(points):
    """Points of each scheme, by increasing step."""
    order = sorted(points, key=lambda p: p["step_fs"])
    return {scheme: [p for p in order if p["scheme"] == scheme] for scheme in sorted({p["scheme"] for p in order})}


def usable(own):
    """The points of a curve before the first point with a blow-up or with R above LOST. An energy drift does not end a
    curve here: with two to four runs, that is one to three degrees of freedom, the test has almost no power. With two
    runs, an energy drift of twenty times its error has a p-value of 3 %; and at a level of 1 %, two of 200 points
    without energy drift would end their curves."""
    return list(itertools.takewhile(lambda p: p["stable"] and p["R"] <= LOST, own))


def at_ratio(own, ratio):
    """(cost, step [fs]) of a curve at R, by interpolation in logarithms between neighbouring points that are usable;
    no extrapolation, but the longest usable step if its R is below the required one."""
    good = usable(own)
    if not good or good[0]["R"] > ratio:
        return None
    for a, b in zip(good, good[1:]):
        if a["R"] <= ratio < b["R"]:
            part = np.log(ratio / a["R"]) / np.log(b["R"] / a["R"])
            return tuple(float(a[key] * (b[key] / a[key]) ** part) for key in (COST, "step_fs"))
    return good[-1][COST], good[-1]["step_fs"]


def seconds_per_ps(o, tables, chosen):
    """Wall-clock time of runs at (scheme, step) pairs without energy samples: the minimum of interleaved repeats."""
    timed = {**tables, "run": {"sample": f"{o.clock:g} ps"}, "output": {"prefix": "clock", **runs.QUIET}}
    (o.folder / "clock.toml").write_text(runs.run_file(**timed), encoding="utf-8")
    best = {}
    for _, (scheme, step) in itertools.product(range(o.repeats), chosen):
        try:
            done = runs.asked(o, "run", "clock.toml", "--scheme", scheme, "--step", f"{step:.3f} fs", "--length", f"{o.clock:g} ps",
                              "--threads", 1, "--force", folder=o.folder)
        except SystemExit as error:  # near the stability limit another initial configuration may blow up
            print(f"{scheme} at {step:.3g} fs is not timed: {error}", file=sys.stderr)
            continue
        time = (done["seconds"]["all"] - done["seconds"]["energies_and_output"]) / done["length_ps"]
        best[scheme, step] = min(time, best.get((scheme, step), time))
    return best


def plot(ax, own, x, look, **more):
    """Draws R of a curve up to its end, and crosses beyond the end."""
    good = len(usable(own))
    percent = lambda points: ([p[x] for p in points], [100 * p["R"] for p in points])
    ax.plot(*percent(own[:good]), **look, **more)
    ax.plot(*percent([p for p in own[good:] if p["stable"]]), linestyle="none", marker="x", color=look["color"])
