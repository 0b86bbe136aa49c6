# SPDX-License-Identifier: MIT
"""Liquid densities of the stored record against published Monte Carlo simulations, which have no time step.

The published table may not be copied into the project: it is read from POLHODE_PUBLISHED, or next to the project. Without it the
test is skipped (exit code 77)."""

import csv
import json
import os
import sys
import unittest
from pathlib import Path

import study_path
import built_program

RECORD = study_path.ROOT / "studies/records/2026-11-27-properties.json"
TABLE = Path(os.environ.get("POLHODE_PUBLISHED", study_path.ROOT.parent / "shared/data/published")) / "nist_sat_tmmc.csv"
MODELS = {"SPC/E": "spce", "TIP3P": "tip3p"}
# The Monte Carlo liquids are at their vapour pressure, up to 3 bar from the 1 bar of the record; the compressibility of water,
# 5e-5/bar, makes 0.15 kg/m3 of it. Their cutoff is 1.0 nm with a tail correction, ours 0.9 nm.
PRESSURE = 0.15
# Of 7 normal deviations one exceeds 3.2 with a probability of 1 %.
BOUND = 3.2


def measured():
    result = json.loads(RECORD.read_text(encoding="utf-8"))
    return {(case["system"], round(point["temperature_K"])): p["value"] for case in result["cases"] for point in case["points"]
            for p in point["properties"] if p["name"] == "density"}


class Densities(unittest.TestCase):
    def test_liquids_at_coexistence(self):
        densities, compared = measured(), 0
        with open(TABLE, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                value = densities.get((MODELS[row["model"]], int(row["T_K"])))
                if value is None:
                    continue
                compared += 1
                published, error = float(row["rho_liq_kg_m3"]), float(row["rho_liq_uncertainty"])
                deviation = (value["value"] - published) / (value["error"] ** 2 + error**2 + PRESSURE**2) ** 0.5
                print(f"{row['model']} {row['T_K']} K: {value['value']:.1f} ± {value['error']:.1f} kg/m3, deviation {deviation:+.1f}")
                self.assertLess(abs(deviation), BOUND, row["model"] + " " + row["T_K"])
        self.assertGreaterEqual(compared, 5)


if __name__ == "__main__":
    if not TABLE.exists():
        print(f"skipped: there is no {TABLE}; set POLHODE_PUBLISHED to its folder")
        sys.exit(77)
    built_program.main()
