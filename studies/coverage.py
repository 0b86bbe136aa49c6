# SPDX-License-Identifier: MIT
"""Coverage of the intervals that `polhode measure` states: over many calls with seeds of their own, how often the 68 % and
95 % intervals contain the true value. The true value is the mean of all other calls, whose error is a tenth of the error of a call
if there are 100 calls. A longer measurement with another seed checks this mean.

Every call decides by itself when to stop, so a bias of the stop rule towards errors that are small by chance would show.
The criterion, fixed before the calls: 68 % within 9 % and 95 % within 4 % of 100 calls, two standard deviations of a binomial number."""

from lib import runs, study
from lib.statistics import mean, rms, share_interval

SYSTEMS = {  # model, state point, and errors requested of a call
    "argon": ("argon", "160 K, 500 bar", {"density": "0.6 %", "potential-energy": "1 %", "compressibility": "12 %", "heat-capacity": "8 %"}),
    "argon-dynamics": ("argon", "160 K, 500 bar", {"diffusion": "5 %", "viscosity": "15 %"}),
    "argon-coupling": ("argon", "160 K, 500 bar", {"chemical-potential": "0.2 kJ/mol"}),
    "argon-slab": ("argon", "90 K, 1 bar", {"surface-tension": "10 %"}),
    "argon-conduction": ("argon", "160 K, 500 bar", {"thermal-conductivity": "20 %"}),
    "argon-hybrid": ("argon", "160 K, 500 bar", {"density": "0.6 %", "potential-energy": "1 %", "compressibility": "12 %", "heat-capacity": "8 %"}),
    "water": ("spce", "300 K, 1 bar", {"density": "0.4 %", "potential-energy": "0.3 %", "compressibility": "25 %", "heat-capacity": "15 %"}),
}
KEPT = ("value", "interval_68", "interval_95", "reached")
SEGMENTS = 24  # segments of averages of a replica before the first decision


def values(o, words, seed, folder):
    """The properties that a call measures, by name."""
    model, at, _ = SYSTEMS[o.system]
    report = runs.asked(o, "measure", model, *words, "--molecules", o.molecules, "--at", at, "--seed", seed, "--threads", 1, *(("--sampling", "hybrid-monte-carlo") if o.system == "argon-hybrid" else ()),
                        "--output", f"seed{seed}", folder=folder)
    point = report["points"][0]
    length = sum(value for key, value in point.items() if key.endswith("length_ps"))
    steps = round(1000 * length / point["step_fs"])
    return {p["name"]: {**{key: p[key] for key in KEPT}, "steps": steps} for p in point["properties"]}


def measured(o):
    words = [word for pair in SYSTEMS[o.system][2].items() for word in pair]
    with runs.scratch(o) as folder:
        calls = runs.parallel(o, lambda seed: runs.kept(folder, f"call{seed}", lambda: values(o, words, seed, folder)), range(o.first, o.first + o.calls))
    return {"system": o.system, "segments": SEGMENTS, "calls": calls}


def covered(calls, share):
    """How many of the calls, pairs of property and true value, have the true value in their interval: as text."""
    count = sum(low <= truth <= high for p, truth in calls for low, high in [p[f"interval_{share}"]])
    low, high = share_interval(count, len(calls)) if calls else (0, 1)
    return f"{100 * count / max(1, len(calls)):.0f} % ({100 * low:.0f} to {100 * high:.0f})"


def report(result):
    rows = []
    for name in result["calls"][0]:
        found = [call[name] for call in result["calls"]]
        known = [p for p in found if p["reached"]]
        total = sum(p["value"]["value"] for p in known)
        others = [(total - p["value"]["value"]) / max(1, len(known) - 1) for p in known]
        calls = list(zip(known, others))
        shares = [covered(calls, share) for share in (68, 95)]
        if all("steps" in p for p in known):  # the first decision: fewer steps only where equilibration is discarded
            first = [call for call in calls if call[0]["steps"] <= 4 * 1250 * result.get("segments", 24)]
            shares += [f"{len(first)}", *(covered(first, share) for share in (68, 95))]
        centre, error = mean([p["value"]["value"] for p in known])
        stated = rms([p["value"]["error"] for p in known])
        rows.append([name, f"{centre:.5g} ± {error:.2g}", f"{len(known)} of {len(found)}", f"{stated / (error * len(known) ** 0.5):.2f}", *shares])
    names = ["property", "mean of all calls", "calls that reached their error", "stated error over scatter", "within 68 %", "within 95 %",
             "stopped at the first decision", "of these within 68 %", "of these within 95 %"]
    return study.table(names[:len(rows[0])], rows)


if __name__ == "__main__":
    o = study.options(__doc__, {"calls": 2}, calls=(100, "calls, each with another seed"), first=(1, "seed of the first call"), molecules=(64, "molecules"), system=("argon", ", ".join(SYSTEMS)))
    if o.system not in SYSTEMS:
        raise SystemExit(f"there is no system '{o.system}'; there are: {', '.join(SYSTEMS)}")
    study.perform(o, measured, report)
