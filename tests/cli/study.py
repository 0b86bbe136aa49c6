# SPDX-License-Identifier: MIT
"""Which runs the tables of a study include, and tables from an existing record."""

import json
import re
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

RECORD = "study-runs.csv"


class Study(Sandbox):
    def points(self, *options):
        process = self.polhode("study", "run.toml", "--json", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return json.loads(process.out)["points"], process.err

    def test_every_point_counts_the_same_starts(self):
        """Runs in a record beyond the requested ones would give some points more runs than others."""
        self.write("run.toml", edited(SMALL, ('["2 fs"]', '["2 fs", "4 fs"]')))
        both, _ = self.points()
        self.assertEqual([p["runs"] for p in both], [2, 2])
        more, _ = self.points("--steps", "4 fs", "--runs", "5")
        self.assertEqual([p["runs"] for p in more], [5])
        again, log = self.points()
        self.assertEqual(again, both)
        self.assertIn("3 runs from later configurations are left out", log)

    def test_tables_of_a_record(self):
        self.write("run.toml", SMALL)
        of_study, _ = self.points()
        record = (self.folder / RECORD).read_text()
        # A record of another version of the program, according to its first line.
        self.write("old.csv", edited(record, (record.splitlines()[0], "# study 0123456789abcdef")))
        before = (self.folder / "old.csv").read_bytes()
        of_record, _ = self.points("--from-record", "old.csv", "--output", "new")
        self.assertEqual(of_record, of_study)
        self.assertEqual((self.folder / "old.csv").read_bytes(), before)
        self.assertFalse((self.folder / "new-runs.csv").exists())
        # The same file is refused if runs would be added to it.
        self.write(RECORD, before)
        self.refused(("study", "run.toml"), ["another study", "tables from this record", "--force"])
        # Tables are not overwritten without --force.
        self.refused(("study", "run.toml", "--from-record", "old.csv", "--output", "new"), ["'new.csv'", "--force"])

    def test_table_figure_and_advice_have_the_same_curves(self):
        """With real runs up to a step that blows up: points before the end, and no others, are drawn and count."""
        self.write("run.toml", edited(SMALL, ('["2 fs"]', '["5 fs", "10 fs", "20 fs", "400 fs"]'), ("runs = 2", "runs = 3"),
                                      ('length = "0.1 ps"', 'length = "4 ps"'), ('["velocity-verlet"]', '["velocity-verlet", "hoa2"]')))
        points, _ = self.points()
        script, figure = (self.folder / "study.gp").read_text(encoding="utf-8"), self.folder / "study.svg"
        report = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        self.assertIn("data = './study.csv'\n", script)
        for k, scheme in enumerate(("velocity-verlet", "hoa2"), 1):
            own = [p for p in points if p["scheme"] == scheme]
            self.assertEqual([p["step_fs"] for p in own if p["usable"]], [5, 10, 20])
            if figure.exists():  # three markers on logarithmic axes, the last one open, those of them in the linear panel, and one in the key
                colour, filled, opened = (re.search(rf"^{name}\[{k}\] = '?([^'\n]+)", script, re.M)[1] for name in ("colour", "filled", "open"))
                markers = re.findall(r"<use xlink:href='#gpPt(\d+)'[^>]* color='([^']+)'", figure.read_text(encoding="utf-8"))
                rgb = "rgb({}, {}, {})".format(*(f"{int(colour[i:i + 2], 16):>3}" for i in (1, 3, 5)))
                self.assertIn(markers.count((str(int(filled) - 1), rgb)), range(2 + 1, 2 * 2 + 1 + 1))
                self.assertIn(markers.count((str(int(opened) - 1), rgb)), (1, 2))
            self.assertTrue(all(row["costs"][scheme]["step_fs"] <= 20 for row in report["guidelines"] if scheme in row["costs"]))

    def test_schemes_of_ones_own(self):
        """A name is the label in table, figure and record; the stages decide which runs are done."""
        mine = "mine: x = 1/6; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x)"
        self.write("run.toml", edited(SMALL, ("velocity-verlet", mine)))
        (point,), _ = self.points()
        self.assertEqual(point["scheme"], "mine")
        self.assertTrue(all(line.startswith("mine,") for line in self.rows("study.csv")[1:]))
        self.assertIn("name[1] = 'mine'\n", (self.folder / "study.gp").read_text())
        self.assertIn("mine: B(0.16666666666666666) A(0.5) ", (self.folder / RECORD).read_text())
        (again,), log = self.points()
        self.assertEqual(again, point)
        self.assertIn("2 runs were read", log)
        # The stages alone give the same numbers, and other stages under the same name other ones.
        (stages,), _ = self.points("--output", "stages", "--schemes", mine[6:])
        self.assertEqual({**stages, "scheme": "mine"}, point)
        self.assertTrue(stages["scheme"].startswith("B(0.16666"), stages["scheme"])
        (other,), _ = self.points("--schemes", mine.replace("1/6", "1/5"))
        self.assertEqual((other["scheme"], other["runs"]), ("mine", 2))
        self.assertNotEqual(other["R"], point["R"])

    def test_schemes_of_the_run_file_by_name(self):
        text = SMALL + '[schemes]\nmine = "x = 1/6; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x)"\n'
        self.write("run.toml", text)
        (point,), _ = self.points("--schemes", "mine")
        self.assertEqual(point["scheme"], "mine")
        # Nothing is compared with velocity Verlet where it is not there.
        out = self.done("study", text, "--schemes", "mine", "--verbose").out
        self.assertNotIn("velocity Verlet", out)
        self.assertIn("(ratio to velocity Verlet)", self.done("study", text, "--output", "both", "--verbose").out)
        report = json.loads(self.done("run", text, "--scheme", "mine", "--json").out)
        self.assertEqual(report["scheme"], "mine")
        self.assertTrue(report["text"].startswith("B(0.16666"), report["text"])
        self.assertEqual(json.loads(self.done("run", text, "--json", "--force").out)["scheme"], "hoa2")
        self.refused(("run", "run.toml", "--scheme", "mime"), ["'mime'", "--scheme"])

    def test_a_file_that_is_not_a_record(self):
        self.write("run.toml", SMALL)
        self.refused(("study", "run.toml", "--from-record", "none.csv"), ["'none.csv'", "record"])
        self.refused(("study", "run.toml", "--from-record", "run.toml"), ["run.toml:1", "begins with", "# study"])


if __name__ == "__main__":
    sandbox.main()
