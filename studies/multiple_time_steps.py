# SPDX-License-Identifier: MIT
"""Multiple time steps compared with single schemes for 512 TIP4P waters: cost at equal R, wall-clock time, resonance."""

from lib import curves, study

LAWS = {"cutoff": {"cutoff": "1.0 nm"}, "reaction-field": {"cutoff": "1.0 nm", "electrostatics": "reaction-field"},
        "pme": {"cutoff": "0.9 nm", "electrostatics": "pme", "pme_accuracy": 1e-4}}
SINGLE = {"velocity-verlet": (1, 1.5, 2, 2.5, 3), "hoa2": (2, 3, 4, 5, 6), "bcss3": (8, 9, 10, 12), "gier4-fd": (4, 5, 6)}
# Each entry has an outer scheme, an inner scheme, and the outer steps [fs] for each number of inner steps in a drift.
NESTED = [("velocity-verlet", "hoa2", {2: (3, 4), 4: (8, 10, 12, 14, 16)}), ("hoa2", "hoa2", {1: (6, 8, 10), 2: (8, 10)}),
          ("hoa2", "bcss3", {1: (8, 10)}), ("hoa2", "gier4-fd", {1: (8, 9, 10, 12)}), ("bcss3", "hoa2", {1: (12, 14)}),
          ("gier4-fd", "gier4-fd", {1: (6, 8, 10)})]
RATIOS = (0.01, 0.005, 0.001)
DRAWN = (*SINGLE, "gier4")
CAVEAT = ("cost: evaluations of all forces, and of near forces times their share of the time.\n"
          "outer / inner x n within r: n inner steps an outer drift, near forces up to r.  Crosses: R above 10 %")


def ladder(o):
    """(scheme, steps [fs]) of all curves."""
    if o.smoke:
        return [("hoa2", (4, 6)), ("hoa2 / hoa2 x 1 within 0.35 to 0.5 nm", (6, 8))]
    return [*SINGLE.items(), *((f"{outer} / {inner} x {n} within {0.7 * reach:g} to {reach:g} nm", steps) for outer, inner, counts in NESTED
                               for n, steps in counts.items() for reach in o.reaches)]


def guideline(o, tables, found):
    """Single and nested schemes at each R: cost, and the time of the best of each."""
    rows = []
    for ratio in RATIOS:
        row = {"R": ratio}
        for kind in ("single", "nested"):
            costs = [(curves.at_ratio(own, ratio), scheme) for scheme, own in curves.by_scheme(found).items()
                     if ("/" in scheme) == (kind == "nested")]
            if costs := sorted((c[0], c[1], scheme) for c, scheme in costs if c):
                row[kind] = {"scheme": costs[0][2], "step_fs": costs[0][1], "cost": costs[0][0]}
        if len(row) == 3:
            pair = [(row[k]["scheme"], row[k]["step_fs"]) for k in ("single", "nested")]
            times = curves.seconds_per_ps(o, tables, pair)
            if not all(key in times for key in pair):
                continue
            for kind, key in zip(("single", "nested"), pair):
                row[kind]["seconds_per_ps"] = times[key]
        rows.append(row)
    return rows


def measured(o):
    result = {"laws": {}}
    for law in o.laws:
        tables = {"system": {"molecules": [{"model": "tip4p"}], "initial_configuration": "w512"}, "forces": {"precision": o.precision, **LAWS[law]}}
        found = curves.points(o, tables, law, ladder(o))
        result["laws"][law] = {"points": found, "guideline": guideline(o, tables, found)}
    return result


def report(result):
    rows = [(law, row["R"], row["single"], row["nested"]) for law, of in result["laws"].items() for row in of["guideline"] if len(row) == 3]
    time = lambda one: f"{1000 * one['seconds_per_ps']:.0f}" if "seconds_per_ps" in one else ""
    shown = lambda one: (f"{one['scheme']}, {one['step_fs']:.1f} fs", f"{one['cost']:.0f}", time(one))
    gain = lambda s, n, key: f"{s[key] / n[key]:.2f}" if key in s else ""
    return study.table(["forces", "R [%]", "best single scheme", "cost [1/ps]", "time [s/ns]", "best nested scheme", "cost [1/ps]", "time [s/ns]",
                        "gain in cost", "in time"],
                       [[law, f"{100 * R:g}", *shown(s), *shown(n), gain(s, n, "cost"), gain(s, n, "seconds_per_ps")]
                        for law, R, s, n in rows])


def drawn(points, max_nested=6):
    """Curves by scheme: the single schemes, and of each pair of nested schemes the one with the largest gain over an h² law."""
    own, best = curves.by_scheme(p for p in points if p["stable"]), {}
    for scheme, curve in own.items():
        worth = min(p[curves.COST] * p["R"] ** 0.5 for p in curve)
        pair = scheme.split(" x ")[0]
        if "/" in scheme and (pair not in best or worth < best[pair][0]):
            best[pair] = (worth, scheme)
    nested = [scheme for _, scheme in sorted(best.values())][:max_nested]
    return {s: own[s] for s in (*(s for s in DRAWN if s in own), *nested)}


def draw(result):
    """R against cost and against the outer step, for each electrostatic interaction."""
    from lib import figures
    laws = {law: drawn(of["points"]) for law, of in result["laws"].items()}
    looks = figures.styles(list(dict.fromkeys(s for of in laws.values() for s in of)))
    figure, rows = figures.panels(2, len(laws), size=(10, 1.6 + 4.6 * len(laws)))
    for (by_cost, by_step), (law, of) in zip(rows, laws.items()):
        for ax, x in ((by_cost, curves.COST), (by_step, "step_fs")):
            for scheme, own in of.items():
                curves.plot(ax, own, x, looks[scheme].of(), label=scheme)
            ax.set(yscale="log", ylabel="R  (%)", title=law)
            figures.plain_ticks(ax.yaxis, (0.01, 0.1, 1, 10))
        by_cost.set(xscale="log", xlabel="cost: force evaluations per ps")
        figures.plain_ticks(by_cost.xaxis, (100, 200, 300, 500, 1000))
        by_step.set(xlabel="outer step  (fs)", xlim=(0, None))
    figure.supxlabel(CAVEAT, fontsize=10)
    figures.legend(figure, rows[0][0], 2)
    return figure


if __name__ == "__main__":
    o = curves.options(__doc__, {"laws": ["pme"]}, 6, 10, 5, laws=(["cutoff", "pme"], "forces"),
                       reaches=([0.4, 0.5, 0.6, 0.7], "cutoffs of the near forces [nm]"))
    study.perform(o, measured, report, draw)
