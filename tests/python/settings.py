# SPDX-License-Identifier: MIT
"""Settings from files, dicts and keywords; quantities of other packages; errors with their texts."""

import inspect
import json
import os
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import polhode

import package
from package import WATER, program

try:
    import pint
except ImportError:
    pint = None
try:
    import openmm.unit as openmm_unit
except ImportError:
    openmm_unit = None


def message(function, *arguments, **keywords):
    """The text of the Error that a call raises."""
    try:
        function(*arguments, **keywords)
    except polhode.Error as e:
        return str(e)
    raise AssertionError("no Error was raised")


def error_of_program(text, *options):
    """What the program says to a run file: the text after "error: " and the place."""
    import subprocess

    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "w.toml").write_text(text, encoding="utf-8")
        result = subprocess.run([package.PROGRAM, "run", "w.toml", *options], cwd=folder,
                                capture_output=True, text=True)
        assert result.returncode == 2, result
        return result.stderr


class Keywords(unittest.TestCase):
    def test_file_dict_and_keywords_are_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "w.toml")
            path.write_text(polhode.settings(WATER).text, encoding="utf-8")
            made = [polhode.Simulation(path), polhode.Simulation(WATER),
                    polhode.Simulation(molecules="tip4p", count=64, density="1 g/cm3",
                                       temperature="297 K", seed=5, cutoff="0.6 nm",
                                       switch="0.5 nm", scheme="hoa2", step="2 fs"),
                    polhode.Simulation(str(path), seed=5),
                    polhode.Simulation({**WATER, "system": {**WATER["system"], "seed": 7}}, seed=5),
                    polhode.Simulation(polhode.settings(WATER, seed=8), seed=5)]
            for s in made[1:]:
                self.assertTrue((s.state.positions == made[0].state.positions).all())
                self.assertTrue((s.state.momenta == made[0].state.momenta).all())

    def test_without_anything_it_is_the_default_run(self):
        self.assertEqual(polhode.Simulation().molecules, [("tip4p", 512)])
        self.assertEqual(polhode.Simulation(step="1 fs").molecules, [("tip4p", 512)])

    def test_mixtures(self):
        s = polhode.Simulation(molecules={"tip4p": 30, "argon": 2}, density="0.8 g/cm3",
                               cutoff="0.4 nm", switch="0.3 nm")
        self.assertEqual(s.molecules, [("tip4p", 30), ("argon", 2)])

    def test_an_ensemble(self):
        s = polhode.settings(WATER, thermostat="langevin", friction="2 1/ps", pressure="3 bar",
                             barostat="monte-carlo")
        self.assertEqual(s.tables["thermostat"], {"type": "langevin", "friction": "2 1/ps"})
        self.assertEqual(s.tables["barostat"], {"pressure": "3 bar", "type": "monte-carlo"})
        self.assertIs(s.tables, s.tables)  # read once, since each run() asks for them

    def test_numpy_numbers_and_paths(self):
        self.assertEqual(polhode.settings(WATER, seed=np.int64(3)).tables["system"]["seed"], 3)
        with tempfile.TemporaryDirectory() as folder:
            polhode.Simulation(WATER).write(Path(folder, "a.gro"))
            system = {"molecules": [{"model": "tip4p"}],
                      "initial_configuration": Path(folder, "a.gro")}
            polhode.Simulation({**WATER, "system": system})


class Errors(unittest.TestCase):
    """The texts are those of the program; nothing else is raised."""

    def test_a_bare_number_is_refused_with_the_same_message(self):
        text = polhode.settings(WATER).text.replace('"step" = "2 fs"', '"step" = 2')
        ours = message(polhode.settings, WATER, step=2)
        first = ours.partition("\n")[0]
        self.assertEqual(first, 'step = 2 has no unit; write for example "2 fs"')
        self.assertIn(first, error_of_program(text))
        self.assertIn("in   step", ours)
        self.assertIn('length = 1 has no unit; write for example "1 fs"',
                      message(polhode.Simulation(WATER).run, 1))
        self.assertIn("has no unit", message(polhode.Simulation(WATER).run, np.float64(1.5)))

    def test_texts_are_those_of_the_program(self):
        for change, old, new in (({"scheme": "giere4"}, '"hoa2"', '"giere4"'),
                                 ({"step": "2 nm"}, '"2 fs"', '"2 nm"'),
                                 ({"step": "-2 fs"}, '"2 fs"', '"-2 fs"'),
                                 ({"cutoff": "9 nm"}, '"0.6 nm"', '"9 nm"')):
            ours = message(polhode.Simulation, WATER, **change)
            theirs = error_of_program(polhode.settings(WATER).text.replace(old, new))
            self.assertIn(ours.partition("\n")[0], theirs)

    def test_every_error_has_its_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "water.toml")
            path.write_text("[system]\nmolecules = [{ model = 'tip4q', count = 5 }]\n")
            try:
                polhode.Simulation(path)
                self.fail("no Error")
            except polhode.Error as e:
                self.assertEqual(e.where, f"{path}:2, system.molecules[0].model")
                self.assertIn("did you mean 'tip4p'", e.text)
                self.assertIsInstance(e, ValueError)
                again = pickle.loads(pickle.dumps(e))
                self.assertEqual((again.text, again.where), (e.text, e.where))

    def test_unknown_words_are_refused_with_the_nearest(self):
        self.assertIn("did you mean 'scheme'", message(polhode.settings, WATER, shceme="hoa2"))
        self.assertIn("did you mean", message(polhode.settings, {**WATER, "systm": {}}))

    def test_existing_files_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = os.path.join(folder, "w")
            polhode.run(WATER, output=prefix)
            with self.assertRaises(polhode.OutputError) as caught:
                polhode.run(WATER, output=prefix)
            self.assertTrue(caught.exception.resumable)
            self.assertIn("resume=True", str(caught.exception))
            polhode.run(WATER, output=prefix, force=True)
            polhode.run(WATER, output=prefix, resume=True, length="60 fs")

    def test_values_of_other_types(self):
        for value in (object(), {1, 2}, 1j, b"hoa2", lambda: 1):
            self.assertIsInstance(message(polhode.settings, WATER, integrator={"scheme": value}), str)
        nested = []
        nested.append(nested)
        self.assertIn("nested", message(polhode.settings, WATER, formats=nested))
        self.assertIn("64 bits", message(polhode.settings, WATER, seed=10**30))
        self.assertIn("dict", message(polhode.settings, {"system": 3}))
        self.assertIn("half of a character", message(polhode.settings, WATER, prefix="\ud800"))
        # A text cannot leave its quotes.
        self.assertIn("giere", message(polhode.settings, WATER, scheme='giere"\n[run]\nlength="1 fs'))

    def test_a_file_that_does_not_exist(self):
        self.assertIn("no-such-file.toml", message(polhode.Simulation, "no-such-file.toml"))


class Quantities(unittest.TestCase):
    def test_texts(self):
        self.assertEqual(polhode.quantity("2 fs", "time"), 0.002)
        self.assertIn("no unit", message(polhode.quantity, 2, "time", "step"))
        self.assertIn("no unit", message(polhode.quantity, "2", "time", "step"))
        self.assertIn("did you mean 'time'", message(polhode.quantity, "2 fs", "tim"))

    @unittest.skipUnless(pint, "pint is not installed")
    def test_pint(self):
        u = pint.UnitRegistry()
        for value, text, dimension in ((2 * u.fs, "2 fs", "time"), (10 * u.angstrom, "1 nm", "length"),
                                       (u.Quantity(25, u.degC), "298.15 K", "temperature"),
                                       (1000 * u.kg / u.m**3, "1 g/cm3", "density"),
                                       (1 * u.atm, "1.01325 bar", "pressure"),
                                       (1 * u.kcal / u.mol, "4.184 kJ/mol", "energy"),
                                       (0.005 * u.dimensionless, "0.5 %", "fraction"),
                                       (1 / u.ps, "1 1/ps", "rate")):
            expected = polhode.quantity(text, dimension)
            self.assertAlmostEqual(polhode.quantity(value, dimension) / expected, 1, delta=1e-12)
        self.assertEqual(polhode.quantity(polhode.settings(WATER, step=2 * u.fs).tables["integrator"]["step"], "time"), 0.002)
        self.assertIn("length", message(polhode.settings, WATER, step=2 * u.nm))
        message(polhode.settings, WATER, step=2 * u.tesla)

    @unittest.skipUnless(openmm_unit, "openmm is not installed")
    def test_openmm(self):
        u = openmm_unit
        for value, text, dimension in ((2 * u.femtoseconds, "2 fs", "time"),
                                       (10 * u.angstroms, "1 nm", "length"),
                                       (300 * u.kelvin, "300 K", "temperature"),
                                       (1 * u.kilocalories_per_mole, "4.184 kJ/mol", "energy"),
                                       (1 / u.picosecond, "1 1/ps", "rate"),
                                       (2 * u.kilojoules_per_mole / u.nanosecond, "2 kJ/mol/ns", "power")):
            expected = polhode.quantity(text, dimension)
            self.assertAlmostEqual(polhode.quantity(value, dimension) / expected, 1, delta=1e-12)
        message(polhode.settings, WATER, step=2 * u.nanometers)


class Pickling(unittest.TestCase):
    def test_settings_schemes_molecules_and_reports(self):
        settings = pickle.loads(pickle.dumps(polhode.settings(WATER, step="1 fs")))
        self.assertEqual(settings.tables["integrator"]["step"], "1 fs")
        for thing in (polhode.Scheme("hoa2"), polhode.molecules("tip4p"), polhode.energy(WATER)):
            self.assertEqual(pickle.loads(pickle.dumps(thing)).data, thing.data)

    def test_a_simulation_says_what_to_do_instead(self):
        with self.assertRaises(TypeError) as caught:
            pickle.dumps(polhode.Simulation(WATER))
        self.assertIn("save()", str(caught.exception))

    def test_pickled_results(self):
        run = polhode.Simulation(WATER).run("40 fs", frames="20 fs")
        again = pickle.loads(pickle.dumps(run))
        self.assertEqual(again.ratio, run.ratio)
        self.assertEqual(len(again.frames), len(run.frames))
        self.assertEqual(again.summary["R"], run.summary["R"])
        with self.assertRaisesRegex(polhode.Error, "pickled"):
            again.to_mdanalysis()


class Types(unittest.TestCase):
    def test_arguments_of_public_functions_have_types(self):
        for name in polhode.__all__:
            thing = getattr(polhode, name)
            members = vars(thing).items() if inspect.isclass(thing) else [(name, thing)]
            for member, function in members:
                if not inspect.isfunction(function) or member.startswith("_") and member != "__init__":
                    continue
                if name in ("State", "Run", "EnergySeries", "Report", "Settings") and member == "__init__":
                    continue  # made by the package
                signature = inspect.signature(function)
                for parameter in signature.parameters.values():
                    if parameter.name not in ("self", "ax"):  # ax: of matplotlib, which is optional
                        self.assertIsNot(parameter.annotation, parameter.empty, f"{name}.{member}({parameter.name})")


class Version(unittest.TestCase):
    def test_it_is_that_of_the_program(self):
        self.assertEqual(program("--version").strip(), f"polhode {polhode.__version__}")


class Descriptions(unittest.TestCase):
    def test_a_setting_with_its_value(self):
        length, = polhode.settings(WATER, length="2 ps").describe("run.length")
        self.assertEqual((length["key"], length["value"], length["default"]), ("length", "2 ps", '"15 ps"'))
        self.assertEqual((length["min"], length["min_excluded"], length["max"]), (0, True, None))
        self.assertEqual(json.loads(program("settings", "run.length", "--json"))[0]["meaning"], length["meaning"])
        self.assertEqual({s["table"] for s in polhode.settings(WATER).describe("barostat")}, {"barostat"})
        self.assertIn("did you mean 'cutoff'", message(polhode.settings(WATER).describe, "cutof"))

    def test_each_bound_is_that_of_the_program(self):
        """Just outside each bound; the run file itself is tested in tests/unit/io/settings_test.cpp."""
        tried = 0
        for s in polhode.settings(WATER).describe():
            for bound, excluded, way in ((s["min"], s["min_excluded"], -1), (s["max"], s["max_excluded"], 1)):
                if bound is None:
                    continue
                whole = s["kinds"] == ["integer"]
                outside = bound if excluded else bound + way * (1 if whole else 1e-9 * max(1, abs(bound)))
                value = f"{outside!r} {s['unit']}" if s["unit"] else int(outside) if whole else outside
                table = {s["key"]: value}
                if "only_with" in s:
                    table[s["only_with"]["key"]] = s["only_with"]["values"][0]
                if s["table"] == "barostat":
                    table.setdefault("pressure", "1 bar")
                base = {**WATER, "integrator": {}} if s["key"] == "accuracy" else WATER
                base = {k: v for k, v in base.items() if k != "system" or s["key"] != "density"}
                if s["key"] == "density":
                    base["system"] = {"molecules": [{"model": "tip4p", "count": 8}]}
                self.assertRegex(message(polhode.settings, {**base, s["table"]: {**base.get(s["table"], {}), **table}}),
                                 s["key"] + " = .* must be", (s["table"], s["key"], value))
                tried += 1
        self.assertGreater(tried, 40)


class AsOnTheCommandLine(unittest.TestCase):
    def test_every_key_is_a_keyword_with_a_type(self):
        """The list is what the reader of run files asks for: each of its tables, and each key of the manual's page."""
        keys = {(table, key): kinds for table, key, kinds in polhode._core.setting_keys()}
        tables = {key for table, key in keys if not table}
        self.assertEqual(tables - {"pair", "shape", "schemes"}, {table for table, _ in keys if table})
        self.assertTrue(all(keys.values()))
        manual = Path(__file__).resolve().parents[2] / "docs/manual"
        text = (manual / "run-files.md").read_text(encoding="utf-8") + (manual / "ensembles.md").read_text(encoding="utf-8")
        for table, key in keys:
            self.assertIn(f"{key}", text)
        bare = [key for table, key in keys if table not in ("study", "prepare")]
        for function in (polhode.settings, polhode.Simulation, polhode.run, polhode.advise, polhode.study):
            parameters = inspect.signature(function).parameters
            self.assertFalse([p for p in parameters.values() if p.kind is p.VAR_KEYWORD])
            for table, key in keys:
                word = {"lambda": "lambda_", "steps": "hybrid_steps"}.get(key, key)
                if not table or table in ("study", "prepare") or bare.count(key) > 1:
                    word = f"{table}_{key}" if table else key
                self.assertIn(word, parameters, function)
                if word in parameters:
                    self.assertIsNot(parameters[word].annotation, inspect.Parameter.empty)
        self.assertEqual(inspect.signature(polhode.settings).parameters["cutoff"].annotation, "Quantity | None")
        self.assertEqual(inspect.signature(polhode.settings).parameters["minimise"].annotation, "bool | None")

    def test_every_keyword_reaches_its_key(self):
        from polhode._keywords import PATH_OF

        base = {"system": {"molecules": [{"model": "argon", "count": 2}]}, "barostat": {"pressure": "1 bar"},
                "thermostat": {"type": "rescaling"}}
        for word, path in PATH_OF.items():
            # A dict is of no kind that the readers accept but for molecules: the error names the key.
            said = message(polhode.settings, base, **{word: {"a": 1}})
            self.assertIn("molecules" if path == "system.molecules" else path.partition(".")[2], said, f"{word} is {path}")
            self.assertTrue(said.endswith(f"in   {word}") or path == "system.molecules", said)

    def test_keys_of_several_tables_need_theirs(self):
        base = polhode.settings(WATER, thermostat="rescaling", pressure="1 bar")
        said = message(polhode.settings, base, time_constant="1 ps")
        self.assertIn("thermostat_time_constant or barostat_time_constant", said)
        made = polhode.settings(base, thermostat_time_constant="0.3 ps", **{"barostat.time_constant": "3 ps"})
        self.assertEqual((made.tables["thermostat"]["time_constant"], made.tables["barostat"]["time_constant"]), ("0.3 ps", "3 ps"))

    def test_settings_of_jobs_are_those_of_their_verbs(self):
        self.assertIn("in   runs", message(polhode.study, WATER, runs=-1))
        self.assertIn("in   length", message(polhode.study, WATER, length="-1 ps"))
        self.assertIn("length", message(polhode.advise, WATER, accuracy="1 %", length="-1 ps"))

    def test_types_have_names_that_say_something(self):
        import pydoc

        text = pydoc.render_doc(polhode.Simulation)
        self.assertNotIn("._With", text)
        self.assertIn("cutoff: 'Quantity | None'", text)

    def test_the_package_has_types_of_keywords(self):
        stub = Path(polhode.__file__).with_name("_keywords.pyi").read_text(encoding="utf-8")
        compile(stub, "_keywords.pyi", "exec")
        self.assertIn("    cutoff: Quantity | None\n", stub)

    def test_a_dict_of_keywords(self):
        words = dict(molecules="tip4p", count=64, density="1 g/cm3", cutoff="0.6 nm", switch="0.5 nm", thermostat="langevin")
        self.assertEqual(polhode.settings(words).text, polhode.settings(**words).text)
        self.assertEqual(polhode.settings({**WATER, "seed": 7}).tables["system"]["seed"], 7)
        self.assertEqual(polhode.settings({"step": "1 fs"}).tables["system"], polhode.settings(step="1 fs").tables["system"])
        self.assertIn("did you mean 'scheme'", message(polhode.settings, {**words, "shceme": "hoa2"}))

    def test_a_pressure_alone(self):
        self.assertEqual(polhode.Simulation(WATER, pressure="1 bar").thermostat, "langevin")
        self.assertEqual(polhode.Simulation(WATER, pressure="1 bar", thermostat="rescaling").thermostat, "rescaling")
        self.assertIsNone(polhode.Simulation(WATER, pressure="1 bar", hybrid_steps=4).thermostat)

    def test_another_thermostat_than_that_of_the_file(self):
        langevin = polhode.settings(WATER, thermostat="langevin", friction="2 1/ps")
        self.assertEqual(polhode.Simulation(langevin, thermostat_time_constant="1 ps", thermostat="rescaling").thermostat, "rescaling")
        self.assertEqual(polhode.settings(langevin, thermostat="langevin").tables["thermostat"]["friction"], "2 1/ps")

    def test_lengths_are_rounded_to_whole_steps(self):
        s = polhode.Simulation(WATER, step="3 fs", length="50 fs")
        self.assertEqual(s.run("20 fs", observe=lambda s: None, every="5 fs").simulation.steps, 7)
        s.run()
        self.assertEqual(s.steps, 17)

    def test_lengths_that_are_none(self):
        s = polhode.Simulation(WATER)
        for call in (lambda: s.run("-1 ps"), lambda: s.run("0 fs"), lambda: s.run("4 fs", frames="-1 fs"),
                     lambda: s.run("4 fs", observe=print, every="0 fs"), lambda: polhode.prepare(WATER, nvt="-1 ps"),
                     lambda: polhode.study(WATER, steps=["-1 fs"])):
            self.assertRegex(message(call), r'= .*-?[01] [fp]s.* must (all )?be (longer than 0|0 or longer|0 ps or longer|above 0)')
        self.assertIn("half a step", message(s.run, "0.9 fs"))

    def test_bounds_of_the_adviser(self):
        self.assertIn("200 %", message(polhode.advise, WATER, accuracy="200 %"))
        self.assertIn("accuracy excludes bias", message(polhode.advise, WATER, accuracy="1 %", bias="0.1 K"))
        self.assertIn('length = "1 ps" has no meaning with ensemble "nvt"', message(polhode.advise, WATER, ensemble="nvt", length="1 ps"))

    def test_one_bound_through_all_doors(self):
        """An option of the command line, the keyword, and where it is a setting the run file say the same."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "w.toml")
            path.write_text(polhode.settings(WATER).text, encoding="utf-8")
            polhode.Simulation(WATER).write(Path(folder, "w.gro"))
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            jobs = {"advise": lambda **k: polhode.advise(path, **k), "minimise": lambda **k: polhode.minimise(path, **k),
                    "tune-scheme": lambda **k: polhode.tune_scheme(path, **k), "study": lambda **k: polhode.study(path, **k),
                    "run": lambda **k: polhode.run(path, **k), "prepare": lambda **k: polhode.prepare(path, **k),
                    "analyze": lambda **k: polhode.analyze("w.gro", run=path, **k)}
            for verb, name, value in (("advise", "accuracy", "200 %"), ("advise", "temperature_bias", "0 %"), ("advise", "time", "0"),
                                      ("minimise", "max_force", "0 kJ/mol/nm"), ("minimise", "max_steps", "0"), ("tune-scheme", "runs", "1"),
                                      ("tune-scheme", "step", "0 fs"), ("study", "runs", "0"), ("study", "length", "0 ps"), ("run", "step", "-1 fs"),
                                      ("run", "pressure", "1 K"), ("prepare", "nvt", "-1 ps"), ("analyze", "bin", "0 nm"),
                                      ("analyze", "cutoff", "0.001 nm"), ("analyze", "fit", "2 ps, 1 ps"), ("analyze", "plot", "pdf")):
                with self.subTest(verb=verb, option=name, value=value):
                    given = int(value) if (verb, name) == ("study", "runs") else value  # a number, as in a run file
                    ours = message(jobs[verb], **{name: given})
                    option = "--" + name.replace("_", "-")
                    arguments = ("w.gro", "--run", "w.toml") if verb == "analyze" else ("w.toml",)
                    done = subprocess.run([package.PROGRAM, verb, *arguments, option, value], capture_output=True, text=True)
                    self.assertEqual(done.returncode, 2, done)
                    theirs = done.stderr.removeprefix("error: ").strip().replace(option, name)
                    self.assertEqual(ours, theirs.replace('"0"', "0") if isinstance(given, int) else theirs)
                    setting = polhode._core.job_settings(verb).get(name)
                    if setting:
                        table, _, key = setting.partition(".")
                        tables = {name: dict(keys) for name, keys in polhode.settings(WATER).tables.items()}
                        of_file = message(polhode.settings, {**tables, table: {**tables.get(table, {}), key: given}})
                        self.assertEqual(of_file.partition("\n")[0], ours.partition("\n")[0])


if __name__ == "__main__":
    package.main()
