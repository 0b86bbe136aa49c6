# SPDX-License-Identifier: MIT
"""The stored figures are those that the studies draw from the stored records, and the documents agree with the records."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import study_path  # first: it says where the others are
import built_program
import all_schemes
import other_programs
import properties
from lib import figures

ROOT = study_path.ROOT
RECORDS = ROOT / "studies/records"
FIGURES = {  # study: record, option of --figure, images in docs/
    "half_femtosecond": ("2026-11-23-half-femtosecond.jsonl", ".", ("half-femtosecond/bias.svg",)),
    "density_maximum": ("2026-11-28-density-maximum.jsonl", "density-maximum.svg", ("density-maximum/density-maximum.svg",)),
    "all_schemes": ("2026-11-21-all-schemes.json", "all-schemes.svg", ("all-schemes/all-schemes.svg",)),
    "multiple_time_steps": ("2026-11-21-nested.json", "nested.svg", ("nested/nested.svg",)),
    "accuracy": ("2026-11-21-accuracy.json", "accuracy.svg", ("accuracy/accuracy.svg",)),
    "precision": ("2026-11-21-precision.json", "precision.svg", ("precision/precision.svg",)),
    "liquids": ("2026-11-21-liquids.json", "radial.svg", ("liquids/radial.svg",)),
    "other_programs": ("2026-11-28-other-programs.json", "other-programs.svg", ("other-programs/other-programs.svg",)),
}
BENCH = {  # kind of bench/figures.py: record in bench/results, argument, images in docs/
    "peers": ("2026-11-21-peers.json", "peers.svg", ("performance/peers.svg",)),
    "steps": ("2026-11-23-engine-xeon.json", "figure", ("performance/sizes.svg", "performance/threads.svg")),
    "lammps": ("2026-11-27-lammps-equal-accuracy.json", "equal-accuracy.svg", ("lammps/equal-accuracy.svg",)),
}
NUMBER = re.compile(r"-?\d+\.\d+")
NAME = re.compile(r'(?<=[#"])[a-zA-Z][0-9a-f]{10}\b')  # of a clip path or marker: a hash of its coordinates, to the last bit


class Figures(unittest.TestCase):
    def test_redrawn(self):
        commands = [([f"studies/{study}.py", "--report", "--record", RECORDS / record, "--figure", option], images)
                    for study, (record, option, images) in FIGURES.items()]
        commands += [(["bench/figures.py", kind, ROOT / "bench/results" / record, image], images) for kind, (record, image, images) in BENCH.items()]
        for (script, *words), images in commands:
            with self.subTest(script, images=images), tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([sys.executable, "-B", ROOT / script, *words], cwd=folder, text=True, capture_output=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                for image in images:
                    drawn = next(Path(folder).glob(f"*{Path(image).name}"))
                    new, stored = (NAME.sub("", path.read_text(encoding="utf-8")) for path in (drawn, ROOT / "docs" / image))
                    self.assertTrue(NUMBER.sub("", new) == NUMBER.sub("", stored), f"docs/{image} is another figure")
                    for a, b in zip(NUMBER.findall(new), NUMBER.findall(stored)):
                        self.assertAlmostEqual(float(a), float(b), delta=0.01, msg=image)  # points of 1/72 inch

    def test_a_scheme_has_its_colour_in_all_figures(self):
        for _, _, images in (*FIGURES.values(), BENCH["peers"], BENCH["lammps"]):
            for image in images:
                text = (ROOT / "docs" / image).read_text(encoding="utf-8")
                named = [name.split(",")[0] for name in re.findall(r"<text[^>]*>(?:polhode )?([a-z0-9-]+(?:, [^<]*)?)</text>", text)]
                schemes = [name for name in named if name in ("velocity-verlet", "hoa2", "gier4", "gier4-fd", "bcss3", "4mn5fv")]
                for scheme, style in figures.styles(schemes).items():
                    self.assertIn(style.color.lower(), text, f"{image}: {scheme}")
                if not any(name in image for name in ("radial", "other-programs", "density-maximum")):  # figures of few schemes
                    self.assertGreater(len(schemes), 2, image)


class AllSchemes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stored = json.loads((RECORDS / FIGURES["all_schemes"][0]).read_text(encoding="utf-8"))
        cls.page = (ROOT / "docs/evidence/all-schemes.md").read_text(encoding="utf-8")

    def test_the_page_names_the_number_of_runs_that_the_points_have(self):
        for system, of in self.stored["systems"].items():
            runs, = re.findall(rf"--systems {system} --runs (\d+)", self.page)
            self.assertEqual({p["runs"] for p in of["points"]}, {int(runs)}, system)

    def test_the_ranking_and_the_page_are_what_the_points_say(self):
        listed = subprocess.run([built_program.PROGRAM, "schemes", "--json"], text=True, capture_output=True, check=True).stdout
        orders = {s["name"]: s["order"] for s in json.loads(listed)}
        again = {system: {"ranking": all_schemes.ranking(of["points"], orders)} for system, of in self.stored["systems"].items()}
        for row in all_schemes.report({"systems": again}).splitlines():
            self.assertIn(row, self.page)


class HalfFemtosecond(unittest.TestCase):
    def test_the_page_has_the_tables_of_the_records(self):
        page = (ROOT / "docs/evidence/half-femtosecond.md").read_text(encoding="utf-8")
        for record in ("2026-11-23-half-femtosecond.jsonl", "2026-11-26-half-femtosecond.jsonl"):
            printed = subprocess.run([sys.executable, "-B", ROOT / "studies/half_femtosecond.py", "--report", "--record", RECORDS / record], text=True,
                                     capture_output=True, check=True).stdout
            rows = [line for line in printed.splitlines() if line.startswith("| ")]
            self.assertGreater(len(rows), 10)
            for row in rows:
                self.assertIn(row, page, record)


class Properties(unittest.TestCase):
    def test_the_pages_have_the_tables_of_the_record(self):
        result = json.loads((RECORDS / "2026-11-27-properties.json").read_text(encoding="utf-8"))
        for page, made in (("docs/properties.md", properties.summary), ("docs/evidence/properties.md", properties.tables)):
            text = (ROOT / page).read_text(encoding="utf-8")
            for line in made(result).splitlines():
                self.assertIn(line, text, page)

    def test_each_deviation_above_3_is_discussed(self):
        """The page names model and property of each deviation above 3."""
        result = json.loads((RECORDS / "2026-11-27-properties.json").read_text(encoding="utf-8"))
        discussed = (ROOT / "docs/evidence/properties.md").read_text(encoding="utf-8").split("## Deviations above 3")[1]
        for model, name in properties.large_deviations(result):
            self.assertIn(f"**{model}, {properties.label(name)}**", discussed)

    def test_a_deviation_is_in_units_of_the_combined_error(self):
        value, entry = {"value": 13.0, "error": 3.0}, {"value": "8", "error": "4"}
        self.assertAlmostEqual(properties.deviation(value, entry), 1)
        self.assertAlmostEqual(properties.deviation(value, {"value": "62.3", "error": ""}), (13 - 62.3) / (9 + 0.01) ** 0.5)


class OtherPrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = json.loads((RECORDS / FIGURES["other_programs"][0]).read_text(encoding="utf-8"))
        cls.page = (ROOT / "docs/evidence/other-programs.md").read_text(encoding="utf-8")

    def test_the_page_has_the_tables_of_the_record(self):
        for line in other_programs.report(self.result).splitlines():
            self.assertIn(line, self.page)

    def test_each_deviation_above_the_bound_is_discussed(self):
        discussed = self.page.split("## Agreement")[1]
        for point, _, quantity, deviation in other_programs.comparisons(self.result):
            if abs(deviation) > other_programs.BOUND:
                self.assertIn(f"**{other_programs.name_of(point)}, {point['thermostat'] or 'constant energy'}, {point['step']:g} fs, {quantity}**", discussed)

    def test_all_programs_have_the_same_forces(self):
        energies = self.result["energies"]
        self.assertGreaterEqual(len(energies), 4)
        for program, energy in energies.items():
            constant = self.result["excluded_pairs_GROMACS"] if program == "GROMACS" else 0
            self.assertLess(abs(energy - constant - energies["polhode"]), other_programs.ENERGIES_AGREE, program)

    def test_the_published_differences_are_those_of_the_table(self):
        if not other_programs.PUBLISHED.exists():
            self.skipTest(f"there is no {other_programs.PUBLISHED}")
        self.assertEqual(other_programs.published(), self.result["published"])


if __name__ == "__main__":
    built_program.main()
