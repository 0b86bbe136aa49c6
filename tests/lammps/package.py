# SPDX-License-Identifier: MIT
"""The Python package polhode-lammps: its wheel has the plugin, and LAMMPS runs the command that the package prints."""

import re
import subprocess
import sys
import zipfile

import engine
from engine import ROOT, LammpsTest

TOOL = "scikit-build-core"  # builds the wheel
VERSIONS = (ROOT / "lammps/requirements.txt").read_text().split()


def pinned(text):
    """What a line of requirements names exactly."""
    return re.findall(r'"((?:lammps|mpich|scikit-build-core)==[\d.]+)"', text)


class Package(LammpsTest):
    project = (ROOT / "lammps/pyproject.toml").read_text(encoding="utf-8")

    def pip(self, *words):
        done = subprocess.run([engine.ENGINE.folder / "bin/python", "-m", "pip", *words, "--quiet", "--disable-pip-version-check"],
                              text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_versions_are_those_of_the_tests(self):
        requires, dependencies = re.findall(r"^(?:requires|dependencies) = \[(.*)\]$", self.project, re.M)
        self.assertEqual([v for v in pinned(requires) if TOOL not in v], VERSIONS)
        self.assertEqual(pinned(dependencies), VERSIONS)

    def test_the_wheel_loads_in_lammps(self):
        """The plugin is what the other tests built: the same folder, and the same options."""
        tool, = [version for version in pinned(self.project) if TOOL in version]
        self.pip("install", tool)
        build = engine.ENGINE.build
        define = {"POLHODE_LAMMPS_LIBRARY": build / "libpolhode-core.a", "POLHODE_DEVELOPER": "ON",
                  "POLHODE_INSTRUCTION_SETS": engine.ENGINE.instruction_sets()}
        settings = [f"--config-settings=cmake.define.{name}={value}" for name, value in define.items()]
        self.pip("wheel", ROOT / "lammps", "--no-deps", "--no-build-isolation", "--wheel-dir", self.folder, *settings,
                 f"--config-settings=build-dir={build / 'lammps-plugin'}")
        wheel, = self.folder.glob("polhode_lammps-*-py3-none-*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(self.folder)
            metadata, = [archive.read(name).decode() for name in archive.namelist() if name.endswith("METADATA")]
        self.assertEqual(re.findall(r"^Requires-Dist: (\S+)$", metadata, re.M), VERSIONS)
        command, path = (subprocess.run([sys.executable, "-m", "polhode_lammps", *words], cwd=self.folder, text=True, capture_output=True,
                                        check=True).stdout for words in ((), ("--path",)))
        self.assertEqual(command, f"plugin load {path}")
        self.write("test.in", command + "plugin list\n")
        self.assertIn("polhode", engine.ENGINE.run(self.folder, "test.in").stdout.partition("Currently loaded plugins")[2])


if __name__ == "__main__":
    engine.main(__doc__)
