# SPDX-License-Identifier: MIT
"""The stored tables are those that the current program makes from the stored runs, and the documents agree with them."""

import csv
import json
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIGURE = ROOT / "docs/figure1"
sys.path.insert(0, str(ROOT / "tests/bench"))

import built_program


def rows(path):
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


class PaperFigure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run([built_program.PROGRAM, "study", "--from-record", FIGURE / "figure1-runs.csv", "--output", "figure1", "--json"],
                                  cwd=folder, text=True, capture_output=True, check=False)
            if made.returncode != 0:
                raise AssertionError(made.stderr)
            cls.report = json.loads(made.stdout)
            cls.points = rows(Path(folder) / "figure1.csv")
        cls.page = (ROOT / "docs/evidence/efficiency.md").read_text(encoding="utf-8")

    def close(self, a, b, what):
        """Equal to the digits that do not depend on the order of summation."""
        if isinstance(a, float) and isinstance(b, (int, float)):
            self.assertLessEqual(abs(a - b), 1e-9 * max(abs(a), abs(b)), what)
        else:
            self.assertEqual(a, b, what)

    def test_the_stored_table(self):
        stored = rows(FIGURE / "figure1.csv")
        self.assertEqual(len(stored), len(self.points))
        for old, new in zip(stored, self.points):
            for column, value in old.items():
                if column == "scheme" or value == "":
                    self.assertEqual(value, new[column])
                else:
                    self.close(float(value), float(new[column]), column)

    def test_the_stored_claims(self):
        stored = json.loads((FIGURE / "figure1.json").read_text(encoding="utf-8"))
        self.assertEqual(len(stored["claims"]), len(self.report["claims"]))
        for old, new in zip(stored["claims"], self.report["claims"]):
            self.assertEqual(old["verdict"], new["verdict"], old["claim"])
            self.assertEqual(old["claim"], new["claim"])

    def test_every_point_has_the_same_number_of_runs(self):
        self.assertEqual(Counter(p["runs [1]"] for p in self.points), {"10": len(self.points)})

    def test_the_page_has_these_points(self):
        for p in self.points:
            row = (f"| {p['scheme']} | {float(p['step [fs]']):g} | {float(p['cost [1/ps]']):.0f} | {p['runs [1]']} "
                   f"| {100 * float(p['R [1]']):.4g} ± {100 * float(p['R_error [1]']):.2g} "
                   f"| {float(p['drift [kJ/mol/ps]']):.3g} ± {float(p['drift_error [kJ/mol/ps]']):.2g} |")
            self.assertTrue(row in self.page, row)

    def test_the_page_has_these_verdicts(self):
        """In the order of the claims: three ratios, the crossing, the ends."""
        table = self.page[self.page.index("## The paper's claims"):]
        said = re.findall(r"\b(not reproduced|reproduced|not decided)\b", "\n".join(
            line for line in table.splitlines() if line.startswith("| ") and "---" not in line))
        self.assertEqual(said, [re.match("not reproduced|reproduced|not decided", c["verdict"])[0] for c in self.report["claims"]])


class Processed(unittest.TestCase):
    """The study of states that are read through postprocessors."""

    def test_the_page_has_the_stored_values(self):
        folder = ROOT / "docs/processed"
        page = (ROOT / "docs/evidence/processed-states.md").read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as made:
            (Path(made) / "processed.toml").write_text(re.search(r"```toml\n(.*?)```", page, re.S)[1], encoding="utf-8")
            subprocess.run([built_program.PROGRAM, "study", "processed.toml", "--from-record", folder / "processed-runs.csv", "--output", "processed"],
                           cwd=made, capture_output=True, check=True)
            points = rows(Path(made) / "processed.csv")
        self.assertEqual(len(points), 15)
        for stored, p in zip(rows(folder / "processed.csv"), points):
            self.assertAlmostEqual(float(stored["R [1]"]) / float(p["R [1]"]), 1, places=9)
            found = re.search(rf"^\| {p['scheme']} \| {float(p['step [fs]']):g} \| {float(p['cost [1/ps]']):.0f} \| ([0-9.]+) ± ([0-9.]+) \|", page, re.M)
            self.assertIsNotNone(found, p["scheme"] + p["step [fs]"])
            for text, value in zip(found.groups(), (p["R [1]"], p["R_error [1]"])):
                digit = 10.0 ** -len(text.partition(".")[2])
                self.assertLess(abs(float(text) - 100 * float(value)), 0.51 * digit)


class Figures(unittest.TestCase):
    """The stored scripts of gnuplot."""

    def curves(self):
        """(script, title, colour) of the curves of all figures."""
        for path in sorted((ROOT / "docs").rglob("*.gp")):
            text = path.read_text(encoding="utf-8")
            for colour, title in re.findall(r'(?<=linecolor )"(#\w{6})"[^,\n]*? title "([^"]*)"', text):
                yield path.name, title, colour
            names, colours = (dict(re.findall(rf"^{array}\[(\d+)\] = '(.*)'$", text, re.M)) for array in ("name", "colour"))
            for k in names:
                yield path.name, names[k], colours[k]

    def test_a_scheme_has_its_colour_in_all_figures(self):
        styles = tomllib.loads((ROOT / "data/plots/schemes.toml").read_text(encoding="utf-8"))["schemes"]
        found = Counter()
        for path, title, colour in self.curves():
            scheme = re.split(r"[,: ]", title.removeprefix("polhode "))[0]
            if scheme in styles and " / " not in title and "rounding" not in title:
                found[path] += 1
                self.assertEqual(colour, styles[scheme]["colour"], f"{path}: {title}")
        self.assertEqual(set(found), {"figure1.gp", "canonical.gp", "processed.gp"})

    def test_no_two_canonical_methods_share_a_colour(self):
        methods = {title: colour for path, title, colour in self.curves() if path == "canonical.gp"}
        self.assertEqual(len(methods), 10)
        self.assertEqual(len(set(methods.values())), 10)


if __name__ == "__main__":
    built_program.main()
