# SPDX-License-Identifier: MIT
"""Properties of rigid models by `polhode measure`, compared with published values.

The systems, state points and requested errors are in `properties.toml`, the published values with their sources in
`published.csv`. A deviation is the difference over the combined standard error of both values; a published value without an
error counts as known to one unit of its last digit. The criterion, fixed before the runs: deviations above 3 are explained or
listed as open."""

import csv
import tomllib
from math import floor, log10
from pathlib import Path

from lib import runs, study

HERE = Path(__file__).parent
MARKS = {"yes": "", "no": "*", "experiment": "†"}  # of published values
CENTRE = ":centre of mass"  # of pairs of molecular centres
SHORT = {"density": "density", "enthalpy-of-vaporization": "ΔH", "diffusion": "D₀", "viscosity": "η", "dielectric-constant": "ε"}


def label(name):
    """The name of a property in tables."""
    return name.replace("-", " ") + (" time" if name == "rotational-relaxation" else "")


def cases():
    with open(HERE / "properties.toml", "rb") as file:
        table = tomllib.load(file)
    return [case | {"properties": table["errors"][case["errors"]]} for case in table["case"]]


def system(case, folder):
    """The words of a system. If its sigma is mixed geometrically, it is a run file."""
    if "mixing" not in case:
        return [case["system"], *(["--molecules", case["molecules"]] if "molecules" in case else [])]
    tables = {"system": {"molecules": runs.molecules(case["system"], case["molecules"]), "density": case["density"], "temperature": "300 K"},
              "forces": {"cutoff": case.get("cutoff", "0.9 nm"), "electrostatics": "pme", "dispersion_correction": True, "mixing": case["mixing"], "precision": "mixed"}}
    Path(folder, f"{case['system']}.toml").write_text(runs.run_file(**tables), encoding="utf-8")
    return [f"{case['system']}.toml"]


def published():
    with open(HERE / "published.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def measured(o):
    chosen = [c for c in cases() if not o.only or c["name"] in o.only]
    with runs.scratch(o) as folder:
        def one(case):
            words = [word for pair in case["properties"].items() for word in pair]
            limit = ["--time-limit", o.time_limit] if o.time_limit else []
            limit += ["--seed", case["seed"]] if "seed" in case else []
            asked = runs.asked(o, "measure", *system(case, folder), *words, "--at", case["at"], "--threads", o.threads, *limit, "--output", case["name"], folder=folder)
            return {"system": case["system"], "points": [without_curves(point) for point in asked["points"]]}

        return {"cases": runs.parallel(o, one, chosen)}


def without_curves(point):
    """A state point with the first shells of its radial distribution functions, but without the functions."""
    kept = [{key: x for key, x in g.items() if key not in ("r_nm", "g", "g_error")} for g in point["radial_distributions"]]
    return point | {"radial_distributions": kept}


def uncertainty(text, error):
    """The error of a published value; without one, a unit of its last digit."""
    if error:
        return float(error)
    return 10.0 ** -len(text.split(".")[1]) if "." in text else 1.0


def matching(entries, system, point, name):
    """The published values of a property at a state point; those without a pressure are of a density or of a gas."""
    at = point["pressure_bar"]
    return [e for e in entries if e["model"] == system and e["property"] == name and abs(float(e["temperature_K"]) - point["temperature_K"]) < 0.5
            and (not e["pressure_bar"] or (at is not None and abs(float(e["pressure_bar"]) - at) < 1))]


def deviation(value, entry):
    error = uncertainty(entry["value"], entry["error"])
    return (value["value"] - float(entry["value"])) / (value["error"] ** 2 + error ** 2) ** 0.5


def text(value, error):
    """A value with its standard error in units of the last two digits: 997.77(80)."""
    if not error or float(error) < 1e-6 * abs(float(value)):
        return f"{float(value):.6g}"
    digits = max(0, 1 - floor(log10(float(error))))
    scaled = round(float(error) * 10**digits)
    return f"{float(value):.{digits}f}({scaled})" if digits else f"{float(value):.0f}({float(error):.0f})"


SUMMARY = ("density", "enthalpy-of-vaporization", "diffusion", "viscosity", "dielectric-constant")


def summary(result):
    """One row for each liquid with the properties that users compare first."""
    rows, units = [], {}
    for case in result["cases"]:
        for point in case["points"]:
            of = {p["name"]: p for p in point["properties"]}
            if "density" not in of or "viscosity" not in of:
                continue
            units |= {name: of[name]["unit"] for name in SUMMARY if name in of}
            rows.append([case["system"], f"{point['temperature_K']:g} K", *(shown(of.get(name)) for name in SUMMARY)])
    heads = [f"{SHORT[name]} [{units[name]}]" if units.get(name) else SHORT[name] for name in SUMMARY]
    return study.table(["model", "temperature", *heads], rows)


def shown(p):
    if p is None:
        return ""
    value, error = p["value"]["value"], p["value"].get("error")
    if not is_converged(p):
        return "not converged"
    return text(value, error) if error else f"{value:.3g}, error not known"


def is_converged(p):
    return p["value"]["value"] is not None and not p.get("not_converged")


def shells(case, point):
    """A table of the first shells of molecular centres, around the kind with fewer molecules. Shells with an error above a tenth
    of the number of neighbours are left out."""
    counts = {name: int(count) for name, count in map(str.split, case["system"].split(","))} if "," in case["system"] else {case["system"]: 1}
    rows = []
    for g in point.get("radial_distributions", []):
        neighbours = g["coordination"] or {"value": 0, "error": None}  # of the second kind around the first
        is_precise = neighbours["error"] is not None and neighbours["error"] < 0.1 * neighbours["value"]
        if not is_precise or not all(site.endswith(CENTRE) for site in g["pair"]):
            continue
        first, second = (site.removesuffix(CENTRE) for site in g["pair"])
        factor = 1.0
        if counts[first] > counts[second]:
            factor, first, second = counts[first] / counts[second], second, first
        rows.append([f"{second} around {first}", *(shown({"value": g[key]}) for key in ("peak_nm", "peak_height", "minimum_nm")),
                     text(factor * neighbours["value"], factor * neighbours["error"])])
    return "\n" + study.table(["first shell", "peak of g(r) [nm]", "height", "minimum [nm]", "neighbours"], rows) if rows else ""


def tables(result):
    """A table for each case, with the published values."""
    entries, parts = published(), []
    for case in result["cases"]:
        for point in case["points"]:
            rows = []
            for p in point["properties"]:
                found = matching(entries, case["system"], point, p["name"]) if is_converged(p) else []
                for k, entry in enumerate(found or [None]):
                    own = [label(p["name"]), p["unit"], shown(p)] if k == 0 else ["", "", ""]
                    other = ["", "", ""] if entry is None else [text(entry["value"], entry["error"]) + MARKS[entry["read"]],
                                                               "" if entry["read"] == "experiment" else f"{deviation(p['value'], entry):+.1f}",
                                                               f"[[{entry['source']}]]"]
                    rows.append([*own, *other])
            of = f", {point['molecules']} molecules" if "second-virial-coefficient" not in [p["name"] for p in point["properties"]] else ""
            state = f"{point['density_kg_per_m3']:g} kg/m3" if point["pressure_bar"] is None else f"{point['pressure_bar']:g} bar"
            parts.append(f"**{case['system']}** at {point['temperature_K']:g} K and {state}{of}:\n\n"
                         + study.table(["property", "unit", "polhode", "published", "deviation", "source"], rows) + shells(case, point))
    return "\n".join(parts)


def large_deviations(result):
    """(system, property) of each deviation above 3."""
    entries = published()
    return {(case["system"], p["name"]) for case in result["cases"] for point in case["points"] for p in point["properties"]
            if is_converged(p) for entry in matching(entries, case["system"], point, p["name"])
            if entry["read"] != "experiment" and abs(deviation(p["value"], entry)) > 3}


def report(result):
    return summary(result) + "\n" + tables(result)


if __name__ == "__main__":
    o = study.options(__doc__, {"only": ["argon-eos1"], "time_limit": "2 s"}, only=([""], "names of cases; all if empty"),
                      threads=(1, "simultaneous replicas of a case"), time_limit=("", "time limit of a case; empty: none"))
    o.only = [name for name in o.only if name]
    study.perform(o, measured, report)
