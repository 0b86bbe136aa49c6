# SPDX-License-Identifier: MIT
"""All built-in schemes compared at equal R: cost and wall-clock time, for water and another liquid."""

from math import sqrt

from lib import curves, runs, study

W512 = {"molecules": runs.molecules("tip4p", 512), "initial_configuration": "w512"}
CO2 = {"molecules": runs.molecules("co2", 216), "density": "0.9 g/cm3", "temperature": "280 K"}
SYSTEMS = {
    "reaction-field": (W512, {"cutoff": "0.9 nm", "electrostatics": "reaction-field"}),
    "pme": (W512, {"cutoff": "0.9 nm", "electrostatics": "pme", "pme_accuracy": 1e-4}),
    "co2": (CO2, {"truncation": "site-switch", "cutoff": "1.0 nm"}),
}
COSTS = {"reaction-field": (2000, 8), "pme": (2000, 8), "co2": (1000, 9)}  # maximum of force evaluations per ps; steps
FACTOR = sqrt(2)  # between costs of neighbouring steps
RATIOS = (0.015, 0.01, 0.004, 0.001, 0.0001)
TIMED = 3  # schemes at each R whose time is measured
PAPER = ("velocity-verlet", "hoa2", "gier4")
PALE = "#c8c8c8"
CAVEAT = ("A derivative of the forces counts as two evaluations. Crosses: energy not conserved, R above 10 %, or a run blew up.\n"
          "R levels off at its round-off limit in mixed precision.")


def steps(system, cost, smoke=False):
    """Steps [fs] at equal costs for every scheme."""
    max_cost, points = COSTS[system]
    return [float(f"{1000 * cost / (max_cost / FACTOR**k):.3g}") for k in ((3, 4) if smoke else range(points))]


def cost_at(own, ratio, order):
    """(cost, step [fs], how): measured; or extrapolated by the order below the smallest R; or of the longest usable step."""
    good = curves.usable(own)
    if found := curves.at_ratio(own, ratio):
        return *found, "" if good[-1]["R"] > ratio else "+"
    if not good:
        return None
    shorter = (ratio / good[0]["R"]) ** (1 / order)
    return good[0][curves.COST] / shorter, good[0]["step_fs"] * shorter, "*"


def ranking(points, orders):
    """The schemes at each R, sorted by cost."""
    rows = []
    for ratio in RATIOS:
        found = [(cost_at(own, ratio, orders[scheme]), scheme) for scheme, own in curves.by_scheme(points).items()]
        rows.append({"R": ratio, "schemes": [{"scheme": scheme, "cost": c[0], "step_fs": c[1], "how": c[2]}
                                             for c, scheme in sorted((f for f in found if f[0]), key=lambda f: f[0][0])]})
    return rows


def add_times(o, tables, rows):
    """The times of the cheapest schemes at each R, and of the schemes of the paper."""
    for row in rows:
        timed = [r for k, r in enumerate(row["schemes"]) if k < TIMED or r["scheme"] in PAPER]
        times = curves.seconds_per_ps(o, tables, [(r["scheme"], r["step_fs"]) for r in timed])
        for r in timed:
            if (r["scheme"], r["step_fs"]) in times:
                r["seconds_per_ps"] = times[r["scheme"], r["step_fs"]]


def measured(o):
    schemes = [s for s in runs.asked(o, "schemes", folder=".") if o.schemes == ["all"] or s["name"] in o.schemes]
    result = {"systems": {}}
    for system in o.systems:
        place, forces = SYSTEMS[system]
        tables = {"system": place, "forces": {"precision": o.precision, **forces}}
        points = curves.points(o, tables, system, [(s["name"], steps(system, s["cost"], o.smoke)) for s in schemes])
        rows = ranking(points, {s["name"]: s["order"] for s in schemes})
        add_times(o, tables, rows)
        result["systems"][system] = {"points": points, "ranking": rows}
    return result


def report(result):
    """A table for each system: rows are schemes, columns R, cells force evaluations per ps and seconds per ns where timed."""
    text = []
    for system, of in result["systems"].items():
        cells = {}
        for column, row in enumerate(of["ranking"]):
            for rank, s in enumerate(row["schemes"]):
                cell = f"{s['cost']:.0f}{s['how']}" + (f" ({1000 * s['seconds_per_ps']:.0f} s)" if "seconds_per_ps" in s else "")
                cells.setdefault(s["scheme"], {})[column] = f"**{cell}**" if rank == 0 else cell
        rank_sum = lambda name: sum(next((k for k, s in enumerate(r["schemes"]) if s["scheme"] == name), 99) for r in of["ranking"])
        text += [f"### {system}\n", study.table(["scheme", *(f"{100 * r['R']:g} %" for r in of["ranking"])], [
            [name, *(cells[name].get(k, "") for k in range(len(of["ranking"])))] for name in sorted(cells, key=rank_sum)])]
    return "\n".join(text)


def draw(result):
    """Draws a panel for each system. Schemes of the paper and schemes that are cheapest at some R are coloured, and all others are pale."""
    from lib import figures
    systems = result["systems"]
    best = [row["schemes"][0]["scheme"] for of in systems.values() for row in of["ranking"] if row["schemes"]]
    measured = list(dict.fromkeys(p["scheme"] for of in systems.values() for p in of["points"]))
    told = figures.styles([s for s in dict.fromkeys([*PAPER, "gier4-fd", *best]) if s in measured])
    figure, (axes,) = figures.panels(len(systems), size=(3.4 * len(systems) + 0.2, 5.6))
    for ax, (system, of) in zip(axes, systems.items()):
        own = curves.by_scheme(of["points"])
        for scheme in sorted(own, key=lambda s: s in told):  # pale ones below
            if scheme in told:
                curves.plot(ax, own[scheme], curves.COST, told[scheme].of(markersize=4.5), label=scheme)
            else:
                ax.plot(*zip(*[(p[curves.COST], 100 * p["R"]) for p in curves.usable(own[scheme])] or [((), ())]), color=PALE, linewidth=0.9)
        ax.plot([], [], color=PALE, label=f"{len(measured) - len(told)} others")
        costs = [p[curves.COST] for p in of["points"]]
        ax.set(xscale="log", yscale="log", title=system, xlim=(0.9 * min(costs), 1.1 * max(costs)), ylim=(0.001, 20))
        figures.plain_ticks(ax.xaxis, [t for t in (60, 100, 200, 500, 1000, 2000) if min(costs) <= t <= max(costs)])
        figures.plain_ticks(ax.yaxis, (0.001, 0.01, 0.1, 1, 10))
    axes[0].set_ylabel("R  (%)")
    figure.supxlabel("cost: force evaluations per ps\n\n" + CAVEAT, fontsize=10)
    figures.legend(figure, axes[0], 6)
    return figure


if __name__ == "__main__":
    o = curves.options(__doc__, {"systems": ["co2"], "schemes": ["velocity-verlet", "hoa2"]}, 4, 8, 5,
                       systems=(list(SYSTEMS), "liquids"), schemes=(["all"], "schemes, or all"))
    study.perform(o, measured, report, draw)
