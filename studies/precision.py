# SPDX-License-Identifier: MIT
"""R in mixed and in double precision: against the step from the same initial configurations, and against the length of
a run.

What mixed precision adds to the fluctuation of the energy is var E = a² + c² h t Σw²/6, with the squared weights w of the force
evaluations of a step: errors of reading energies, and a random walk."""

from math import sqrt
from statistics import fmean

import numpy as np
from lib import runs, study

ETA = 0.1931833275037836
# The sum of the squared weights of the force evaluations in a step of each scheme; GIER4 has lambda = 1.
WEIGHTS = {"velocity-verlet": 1.0, "hoa2": (2 * ETA) ** 2 + (1 - 2 * ETA) ** 2, "gier4-fd": 5 / 9}
PRECISIONS = ("mixed", "double")
LONG = (("gier4-fd", 1), ("hoa2", 3))  # the truncation error of the first is far below round-off


def ladders(o):
    """(scheme, precision, lambda, electrostatics, steps [fs], initial configurations) of all curves."""
    steps = lambda scheme: (1, 2, 4) if o.smoke else (0.5, 1, 2, 3, 4) + (5,) * (scheme == "gier4-fd")
    some = (1, 4) if o.smoke else (1, 2, 3, 4, 5)
    yield from ((scheme, precision, None, "coulomb", steps(scheme), o.starts) for scheme in ("gier4-fd", "hoa2", "velocity-verlet")
                for precision in PRECISIONS)
    yield from (("gier4-fd", "mixed", 0.1, "coulomb", some, 1), ("gier4-fd", "double", 1, "coulomb", some, 1))
    yield from (("gier4-fd", precision, None, "reaction-field", (1, 3), 1) for precision in PRECISIONS)


def run(o, start, scheme, precision, step, length, lam=None, electrostatics="coulomb", final=None):
    """The report of a run, and the total energies of the samples."""
    with runs.scratch() as folder:
        tables = {"system": {"molecules": [{"model": "tip4p"}], "initial_configuration": start},
                  "forces": {"electrostatics": electrostatics, "precision": precision},
                  "integrator": {"scheme": scheme, "step": f"{step:g} fs", "lambda": lam},
                  "run": {"length": f"{length:g} ps", "sample": f"{max(2, step):g} fs"}, "output": {"prefix": "run", **runs.QUIET}}
        report = runs.run(o, tables, folder)
        if final:
            (runs.Path(folder) / "run-final.gro").rename(final)
        samples = runs.columns(runs.Path(folder) / "run-energies.csv")
        return report, samples["time"].to_numpy(), samples["total"].to_numpy()


def row(kind, scheme, precision, lam, electrostatics, step, length, start, report):
    return {"kind": kind, "electrostatics": electrostatics, "scheme": scheme, "lambda": lam or "", "precision": precision, "step_fs": step,
            "length_ps": length, "start": start, "R": report["R"], "rms_total": report["rms_total_kJ_per_mol"],
            "rms_potential": report["rms_potential_kJ_per_mol"], "drift": report["drift_kJ_per_mol_ps"], "R_rounding": report.get("R_rounding", "")}


def parts(times, energies, length):
    """The energies in consecutive windows of a length [ps]."""
    count = max(1, int(times[-1] / length + 1e-6))
    return [energies[(times >= k * length) & (times < (k + 1) * length)] for k in range(count)]


def change(times, energies, length):
    """Mean square change of the mean of E between successive windows."""
    return float(np.mean(np.diff([p.mean() for p in parts(times, energies, length)]) ** 2))


def reading_errors(rows):
    """a of every scheme and step where round-off dominates: what mixed precision adds to double, at λ = 1."""
    found = []
    for scheme, step in sorted({(r["scheme"], r["step_fs"]) for r in rows}):
        mixed, double = (fmean([r["rms_total"] ** 2 for r in rows if (r["scheme"], r["step_fs"], r["lambda"], r["electrostatics"], r["kind"])
                                == (scheme, step, "", "coulomb", "short") and r["precision"] == p] or [0]) for p in PRECISIONS)
        if mixed > 4 * double:
            found.append({"scheme": scheme, "step_fs": step, "a": sqrt(mixed - double)})
    return found


def walk(mixed, double, step, weights, reading, block):
    """c [kJ/mol/ps] from the means of E over blocks of a long run: a random walk of variance D t changes them by 2 D block/3
    from one to the next, sampling of n energies by 2 a²/n."""
    n = len(parts(*mixed, block)[0])
    left = change(*mixed, block) - change(*double, block) - 2 * reading**2 / n
    return sqrt(max(0.0, left) * 1.5 / block / (step * 1e-3 * weights))


def measured(o):
    rows, growth, kept = [], [], {}
    with runs.scratch(o) as folder:
        starts = [runs.Path(folder).resolve() / f"start{k}.gro" for k in range(o.starts)]
        for last, start in zip(["w512", *starts], starts):  # 1 ps apart
            run(o, last, "hoa2", "double", 2, 0.1 if o.smoke else 1, final=start)
        cases = [(*case, step, k) for *case, steps, count in ladders(o) for step in steps for k in range(count)]

        def short(case):
            scheme, precision, lam, electrostatics, step, k = case
            return row("short", scheme, precision, lam, electrostatics, step, o.length, k,
                       run(o, starts[k], scheme, precision, step, o.length, lam, electrostatics)[0])

        def long(case):
            scheme, step, precision = case
            report, *samples = run(o, starts[0], scheme, precision, step, o.long)
            return report, samples

        rows += runs.parallel(o, short, cases)
        cases = [(scheme, step, precision) for scheme, step in LONG for precision in PRECISIONS]
        for (scheme, step, precision), (report, samples) in zip(cases, runs.parallel(o, long, cases)):
            kept[scheme, step, precision] = samples
            rows.append(row("long", scheme, precision, None, "coulomb", step, o.long, 0, report))
            growth += [{"scheme": scheme, "precision": precision, "step_fs": step, "window_ps": t,
                        "rms_total": sqrt(fmean(p.var() for p in parts(*samples, t))), "rms_potential": report["rms_potential_kJ_per_mol"]}
                       for t in 0.25 * 2.0 ** np.arange(12) if t <= o.long]
    found = reading_errors(rows)
    reading = sqrt(fmean(f["a"] ** 2 for f in found)) if found else 0.0
    scheme, step = LONG[0]
    c = walk(kept[scheme, step, "mixed"], kept[scheme, step, "double"], step, WEIGHTS[scheme], reading, 1 if o.long > 4 else 0.25)
    return {"runs": rows, "growth": growth, "a_kJ_per_mol": reading, "a_of": found, "c_kJ_per_mol_ps": c}


def ladder(result, scheme, precision):
    """[(step [fs], R [%])] of a scheme at its own lambda, means over initial configurations."""
    own = [r for r in result["runs"] if (r["kind"], r["electrostatics"], r["lambda"], r["scheme"], r["precision"])
           == ("short", "coulomb", "", scheme, precision)]
    return [(step, 100 * fmean(r["R"] for r in own if r["step_fs"] == step)) for step in sorted({r["step_fs"] for r in own})]


def report(result):
    rows = [[scheme, precision, f"{step:g}", f"{R:.3g}"] for scheme in WEIGHTS for precision in PRECISIONS for step, R in ladder(result, scheme, precision)]
    c = result["c_kJ_per_mol_ps"]
    return (study.table(["scheme", "precision", "step [fs]", "R [%]"], rows) + f"\na {result['a_kJ_per_mol']:.3g} kJ/mol, "
            + (f"c {c:.3g} kJ/mol/ps" if c > 0 else "the long runs are too short to show the random walk"))


def draw(result):
    """R against the step in both precisions, and how the fluctuation grows."""
    from lib import figures
    looks = figures.styles(WEIGHTS)
    figure, (axes,) = figures.panels(2, size=(10, 5))
    style = lambda s, precision: {**looks[s].of(open=precision == "double"), "linestyle": "-" if precision == "mixed" else "--"}
    for precision in PRECISIONS:
        for scheme in WEIGHTS:
            axes[0].plot(*zip(*ladder(result, scheme, precision)), label=f"{scheme}, {precision}", **style(scheme, precision))
        for scheme, _ in LONG:
            own = [g for g in result["growth"] if (g["scheme"], g["precision"]) == (scheme, precision)]
            axes[1].plot([g["window_ps"] for g in own], [g["rms_total"] for g in own], **style(scheme, precision))
    a = result["a_kJ_per_mol"]
    t = np.array([g["window_ps"] for g in result["growth"]])
    t = np.linspace(t.min(), t.max(), 100)
    d = result["c_kJ_per_mol_ps"] ** 2 * 1e-3 * WEIGHTS["gier4-fd"] / 6  # at 1 fs
    short, long = (next(r["length_ps"] for r in result["runs"] if r["kind"] == kind) for kind in ("short", "long"))
    axes[0].axhline(100 * a / fmean(r["rms_potential"] for r in result["runs"] if r["kind"] == "short"), color=figures.INK, linestyle=":", linewidth=1.2,
                    label="round-off of gier4-fd, mixed")
    axes[1].plot(t, np.sqrt(a**2 + d * t), color=figures.INK, linestyle=":", linewidth=1.2)
    if d > 0:  # a short run does not show it
        axes[0].plot([], [], color=figures.INK, linestyle="-.", linewidth=1.2, label="its random walk")
        axes[1].plot(t, np.sqrt(d * t), color=figures.INK, linestyle="-.", linewidth=1.2)
    axes[0].set(xscale="log", yscale="log", xlabel="time step  (fs)", ylabel="R  (%)", title=f"runs of {short:g} ps")
    axes[1].set(xscale="log", yscale="log", xlabel="length of a window  (ps)", ylabel="rms of E about its mean  (kJ/mol)",
                title=f"one run of {long:g} ps: " + ", ".join(f"{s} at {h:g} fs" for s, h in LONG))
    figures.plain_ticks(axes[0].xaxis, (0.5, 1, 2, 3, 4, 5))
    figures.plain_ticks(axes[1].xaxis, [x for x in (0.25, 0.5, 1, 2, 4, 8, 16, 32) if x <= long])
    figures.legend(figure, axes[0], 4)
    return figure


if __name__ == "__main__":
    o = study.options(__doc__, {"starts": 1, "length": 0.1, "long": 0.5}, starts=(2, "initial configurations"),
                      length=(2.0, "length of the short runs [ps]"), long=(16.0, "length of the long runs [ps]"))
    study.perform(o, measured, report, draw)
