# SPDX-License-Identifier: MIT
"""Coverage of the intervals that `polhode measure` states. Many calls with different seeds are made. The coverage is
the fraction of calls with 68 % or 95 % intervals that contain a reference. The reference is a call with a small error.

Every call decides when to stop, so a bias of the stop rule towards errors that are small by chance would be detected.
The criterion, fixed before the calls: 68 % within 9 % and 95 % within 4 % of 100 calls, two standard deviations of a binomial number."""

from lib import runs, study
from lib.statistics import share_interval

PROPERTIES = {  # error of a call, and of the reference: a sixth of it adds 1.4 % to the scatter
    "density": ("0.6 %", "0.1 %"), "potential-energy": ("1 %", "0.17 %"), "compressibility": ("12 %", "2 %"), "heat-capacity": ("8 %", "1.3 %"),
}


def values(o, words, seed, folder):
    """The properties that a call measures, by name."""
    report = runs.asked(o, "measure", "argon", *words, "--molecules", o.molecules, "--at", o.at, "--seed", seed, "--threads", 1,
                        "--output", f"seed{seed}", folder=folder)
    return {p["name"]: p for p in report["points"][0]["properties"]}


def measured(o):
    words = [[word for name, errors in PROPERTIES.items() for word in (name, errors[k])] for k in (0, 1)]
    with runs.scratch(o) as folder:
        reference = None if o.smoke else runs.kept(folder, "reference", lambda: values(o, words[1], 0, folder))
        calls = runs.parallel(o, lambda seed: runs.kept(folder, f"call{seed}", lambda: values(o, words[0], seed, folder)), range(1, o.calls + 1))
    return {"reference": reference or calls[0], "calls": calls}


def inside(p, share, truth):
    low, high = p[f"interval_{share}"]
    return low <= truth <= high


def report(result):
    rows = []
    for name in PROPERTIES:
        truth, found = result["reference"][name]["value"], [call[name] for call in result["calls"]]
        known = [p for p in found if p["reached"]]
        shares = []
        for share in (68, 95):
            count = sum(inside(p, share, truth["value"]) for p in known)
            low, high = share_interval(count, len(known)) if known else (0, 1)
            shares.append(f"{100 * count / max(1, len(known)):.0f} % ({100 * low:.0f} to {100 * high:.0f})")
        rows.append([name, f"{truth['value']:.5g} ± {truth['error']:.2g}", f"{len(known)} of {len(found)}", *shares])
    return study.table(["property", "reference", "calls that reached their error", "within 68 %", "within 95 %"], rows)


def main():
    o = study.options(__doc__, {"calls": 2}, calls=(100, "calls, with seeds from 1 on"), molecules=(64, "argon atoms"), at=("160 K, 500 bar", "state point"))
    study.perform(o, measured, report)


if __name__ == "__main__":
    main()
