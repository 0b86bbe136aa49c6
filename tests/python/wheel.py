# SPDX-License-Identifier: MIT
"""Wheels need nothing of the system but glibc and GCC's libraries, and name the licences of what is in them.

Inspects the wheels in build/wheels that scripts/wheel made of this version; without any, only the list of licences.
"""

import re
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(polhode VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
WHEELS = sorted((ROOT / "build/wheels").glob(f"polhode-{VERSION}-*.whl"))
# Of the policies manylinux; each system has them.
SYSTEM = re.compile(r"(lib(c|m|stdc\+\+|gcc_s)|ld-linux-x86-64|ld-linux-aarch64)\.so\.\d+")
# What a package of packages.txt is called in the list of licences.
NAMES = {"libboost-dev": "Boost", "libcli11-dev": "CLI11", "libeigen3-dev": "Eigen", "libfmt-dev": "{fmt}",
         "libhdf5-dev": "HDF5", "libhwy-dev": "Highway", "libtomlplusplus-dev": "toml++",
         "nlohmann-json3-dev": "nlohmann-json"}
IN_WHEEL = {"libfmt": "{fmt}", "libhwy": "Highway", "libtomlplusplus": "toml++"}


def needed(file):
    """The libraries that a program or library names as needed."""
    listed = subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\(NEEDED\).*\[(.+)\]", listed)


class Licences(unittest.TestCase):
    listed = (ROOT / "python/LICENSES.md").read_text(encoding="utf-8")

    def test_every_library_of_the_build_is_listed(self):
        packages = (ROOT / "packages.txt").read_text().splitlines()
        for package in [p for p in packages if p.endswith("-dev")]:
            self.assertIn(f"[{NAMES[package]}", self.listed, f"add {package} to python/LICENSES.md")


@unittest.skipUnless(WHEELS, "there are no wheels; scripts/wheel builds them")
class Wheel(unittest.TestCase):
    def each(self):
        for path in WHEELS:
            with zipfile.ZipFile(path) as wheel:
                yield path, wheel, [name for name in wheel.namelist() if not name.endswith("/")]

    def test_tag_and_size(self):
        for path, _, _ in self.each():
            self.assertRegex(path.name, r"-manylinux_2_\d\d_(x86_64|aarch64)\.whl$")
            self.assertLess(path.stat().st_size, 40e6)  # kernels of all sets, in module and program: 18 MB

    def test_it_has_module_program_stubs_and_typing(self):
        for _, _, names in self.each():
            for wanted in (r"polhode/_core\..*\.so", r"polhode/bin/polhode", r"polhode/_core\.pyi", r"polhode/py\.typed",
                           r"polhode/references\.bib", r".*dist-info/entry_points\.txt"):
                self.assertTrue(any(re.fullmatch(wanted, n) for n in names), wanted)

    def test_libraries_are_in_the_wheel_or_of_every_system(self):
        for _, wheel, names in self.each():
            own = {Path(n).name for n in names if n.startswith("polhode.libs/")}
            files = [n for n in names if re.search(r"\.so(\.|$)|polhode/bin/polhode$", n)]
            with tempfile.TemporaryDirectory() as folder:
                for name in files:
                    for library in needed(wheel.extract(name, folder)):
                        self.assertTrue(library in own or SYSTEM.fullmatch(library), f"{name} needs {library}")
            for library in own:
                self.assertIn(library.split("-")[0], IN_WHEEL)

    def test_licences_are_in_it(self):
        for _, _, names in self.each():
            texts = [Path(n).name for n in names if "/licenses/" in n]
            for wanted in ("LICENSE", "LICENSES.md", "LICENSE.md", "LICENSE-hdf5.txt", "LICENSE-zlib.txt", "nanobind.txt",
                           *(f"{p}.txt" for p in NAMES if p != "libhdf5-dev")):
                self.assertIn(wanted, texts)


if __name__ == "__main__":
    unittest.main()
