# SPDX-License-Identifier: MIT
"""A progress bar that is missing or broken never stops a run, and a bar that works is shown."""

import io
import sys
import types
import unittest
from unittest import mock

import polhode

import package
from package import WATER, optional


class ZMQInteractiveShell:
    """What IPython.get_ipython() returns in a Jupyter kernel is of a class with this name."""


def notebook(**modules):
    """Modules as in a kernel of Jupyter, with others replaced; None: not installed."""
    kernel = types.SimpleNamespace(get_ipython=ZMQInteractiveShell)
    return mock.patch.dict(sys.modules, {"IPython": kernel, **modules})


def raising(error):
    """A module whose names raise an error."""
    class Module(types.ModuleType):
        def __getattr__(self, name):
            raise error
    return Module("broken")


class BrokenBar:
    """A bar of tqdm that fails at one place."""
    at = ""

    def __init__(self, **_):
        self.fail("init")

    def fail(self, name):
        if self.at == name:
            raise OSError("broken")

    def set_postfix_str(self, detail):
        self.fail("set")

    def close(self):
        self.fail("close")


class Progress(unittest.TestCase):
    def run_and_read(self, progress=None):
        """What a run writes to the stream of errors."""
        with mock.patch("sys.stderr", new=io.StringIO()) as shown:
            s = polhode.Simulation(WATER)
            s.run("0.8 ps", progress=progress)
            self.assertEqual(s.steps, 400)
        return shown.getvalue()

    def test_a_notebook_without_ipywidgets(self):
        optional("tqdm")
        with notebook(ipywidgets=None):
            shown = self.run_and_read()
        self.assertIn("running", shown)  # the bar of text
        self.assertNotIn("Exception", shown)

    def test_a_notebook_with_broken_ipywidgets(self):
        optional("tqdm")
        for error in (ImportError("IProgress not found"), RuntimeError("no frontend")):
            with notebook(**{"ipywidgets": types.ModuleType("ipywidgets"), "tqdm.notebook": raising(error)}):
                self.assertIn("running", self.run_and_read())

    def test_without_tqdm(self):
        for in_notebook in (True, False):
            none = {"tqdm": None, "tqdm.notebook": None}
            with notebook(**none) if in_notebook else mock.patch.dict(sys.modules, none):
                self.assertIn("running", self.run_and_read(progress=True))

    def test_a_bar_that_fails(self):
        for at in ("init", "set", "close", ""):
            bar = type("Bar", (BrokenBar,), {"at": at})
            with mock.patch.dict(sys.modules, {"tqdm": types.SimpleNamespace(tqdm=bar)}):
                self.run_and_read(progress=True)

    def test_a_stream_that_is_closed_or_missing(self):
        closed = io.StringIO()
        closed.close()
        for stream in (closed, None):
            for progress in (None, True):
                with mock.patch("sys.stderr", new=stream):
                    polhode.Simulation(WATER).run("0.4 ps", progress=progress)

    def test_an_ipython_that_is_not_whole(self):
        with mock.patch.dict(sys.modules, {"IPython": types.ModuleType("IPython")}):
            self.run_and_read()

    def test_errors_of_a_function_of_ones_own_are_raised(self):
        def progress(*_):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            polhode.Simulation(WATER).run("0.8 ps", progress=progress)


if __name__ == "__main__":
    package.main()
