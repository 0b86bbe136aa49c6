# SPDX-License-Identifier: MIT
"""What no setting may be is rejected through three doors with one message: run file, option of the command line, keyword of
Python. The settings are those that the program lists: just outside of each bound, and what is in no list of names.
"""

import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import polhode
from polhode import _core
from polhode._settings import toml_text

import package
from package import program

JOBS = {"run": (), "prepare": (), "minimise": (), "export": ("lammps",), "advise": (), "study": ()}


def outside(row):
    """Values just outside of what a setting may be, as Python has them."""
    kinds, unit = row["kinds"], row["unit"]
    for bound, excluded, outwards in ((row["min"], row["min_excluded"], -1), (row["max"], row["max_excluded"], 1)):
        if bound is None:
            continue
        next_to_it = 1 if "integer" in kinds else 1e-9 * max(1, abs(bound))
        number = bound if excluded else bound + outwards * next_to_it
        number = int(number) if "integer" in kinds else number
        if row["table"] == "hybrid_monte_carlo" and number == 0:
            number = -1  # by an option 0 steps mean that there is none
        value = f"{number!r} {unit}" if unit else number
        yield [value] if kinds == ["texts"] else value
    if row["min"] is None and kinds == ["texts"]:
        yield ["?"]
    if row["values"].startswith('"') and kinds == ["text"]:
        yield "?"


def unmarked(message):
    """A message without the marks around a value: an option is a text without them, and a run file has quotes and brackets."""
    return re.sub(r"""["']|\[ | \]""", "", message)


def tables_for(row):
    """The tables of a run file in which the setting has a meaning, without it."""
    tables = {"system": {"molecules": [{"model": "tip4p", "count": 64}], "density": "1 g/cm3"}, "thermostat": {"type": "langevin"}}
    if row["key"] == "box":
        del tables["system"]["density"]
    tables.setdefault(row["table"], {})
    if row["table"] == "barostat":
        tables["barostat"]["pressure"] = "1 bar"
    if "only_with" in row:
        tables[row["table"]][row["only_with"]["key"]] = row["only_with"]["values"][0]
    tables[row["table"]].pop(row["key"], None)
    return tables


class Bounds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, tables):
        path = self.folder / name
        path.write_text(toml_text(tables), encoding="utf-8")
        return path

    def of_program(self, *words):
        """(message, place) of the error that a command ends with."""
        done = subprocess.run([package.PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2, (words, done.stdout, done.stderr))
        message, _, place = done.stderr.partition("error: ")[2].rstrip("\n").partition("\n  in   ")
        return message, place

    def of_python(self, function, *arguments, **keywords):
        with self.assertRaises(polhode.Error, msg=keywords) as caught:
            function(*arguments, **keywords)
        message, _, place = str(caught.exception).partition("\n  in   ")
        return message, place

    def doors(self, row, value):
        """(door, place that it names, (message, place)) of each door to a setting."""
        tables, path = tables_for(row), f"{row['table']}.{row['key']}"
        base = self.file("base.toml", tables)
        bad = self.file("bad.toml", {**tables, row["table"]: {**tables[row["table"]], row["key"]: value}})
        yield "run file", path, self.of_program("settings", "--file", bad)
        yield "keyword", path, self.of_python(polhode.settings, base, **{path: value})
        for job, words in JOBS.items():
            for name, key in _core.job_settings(job).items():
                if key != path:
                    continue
                option = "--" + name.replace("_", "-")
                values = value if isinstance(value, list) else [value]
                yield job, option, self.of_program(job, *words, base, f"{option}={values[0]}", *values[1:])
                yield f"polhode.{job}()", name, self.of_python(getattr(polhode, job), *words, base, **{name: value})

    def test_each_setting(self):
        tried = {}
        for row in json.loads(program("settings", "--json")):
            for value in outside(row):
                said = list(self.doors(row, value))
                tried[row["table"], row["key"], str(value)] = len(said)
                for door, named, (message, place) in said:
                    with self.subTest(setting=f"{row['table']}.{row['key']}", value=value, door=door):
                        self.assertEqual(unmarked(message), unmarked(said[0][2][0]))
                        self.assertTrue(place.endswith(named), place)
        self.assertGreater(len(tried), 60)
        self.assertGreater(sum(tried.values()), 150)


if __name__ == "__main__":
    package.main()
