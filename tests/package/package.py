# SPDX-License-Identifier: MIT
"""polhode as other projects meet it: installed to a folder, found by CMake and pkg-config, and as a part."""

import argparse
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = None  # the build folder, from the command line
COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)]
# What the library is built on; to find one of them is to need it.
DEPENDENCIES = ("fmt", "hwy", "tomlplusplus", "Threads", "Boost", "Eigen3", "nlohmann_json", "CLI11")


def command(*words, **environment):
    """The output of a command that succeeds."""
    run = subprocess.run([str(word) for word in words], env={**os.environ, **environment}, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600, check=False)
    if run.returncode:
        raise AssertionError(f"{words} ended with {run.returncode}:\n{run.stdout}")
    return run.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.prefix = cls.folder / "moved"
        command("cmake", "--install", BUILD, "--prefix", cls.folder / "installed")
        (cls.folder / "installed").rename(cls.prefix)  # it may be moved

    def configure(self, compiler, *options):
        build = Path(tempfile.mkdtemp(dir=self.folder))
        command("cmake", "-S", HERE, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", *options,
                CXX=compiler, CXXFLAGS="-Wall -Wextra -Werror")
        return build

    def build_and_run(self, build, component):
        command("cmake", "--build", build, "--target", component)
        return command(build / component)

    def test_the_program_runs_where_it_is_installed(self):
        self.assertRegex(command(self.prefix / "bin/polhode", "--version"), r"^polhode \d+\.\d+\.\d+")
        self.assertIn("TIP4P", command(self.prefix / "bin/polhode", "molecules").upper())

    def test_licences_are_installed(self):
        self.assertTrue((self.prefix / "share/doc/polhode/LICENSE").exists())
        self.assertTrue((self.prefix / "share/doc/polhode/LICENSE-pocketfft.md").exists())

    def test_cmake_finds_the_headers_without_any_dependency(self):
        none = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in DEPENDENCIES]
        for compiler in COMPILERS:
            with self.subTest(compiler):
                build = self.configure(compiler, "-DCOMPONENTS=headers", *none)
                self.assertIn("schemes", self.build_and_run(build, "headers"))

    def test_cmake_finds_the_library(self):
        for compiler in COMPILERS:
            with self.subTest(compiler):
                build = self.configure(compiler, "-DCOMPONENTS=library")
                self.assertIn("512 molecules", self.build_and_run(build, "library"))

    def test_cmake_finds_the_core_without_what_reads_files(self):
        none = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in DEPENDENCIES if name not in ("fmt", "hwy", "Threads")]
        build = self.configure("g++", "-DCOMPONENTS=core", *none)
        self.assertIn("two atoms", self.build_and_run(build, "core"))

    def test_a_component_that_does_not_exist_is_refused(self):
        with self.assertRaisesRegex(AssertionError, "python"):
            self.configure("g++", "-DCOMPONENTS=python")

    @unittest.skipUnless(shutil.which("pkg-config"), "no pkg-config")
    def test_pkg_config_knows_headers_core_and_library(self):
        for name, component in ("polhode-headers", "headers"), ("polhode-core", "core"), ("polhode", "library"):
            flags = command("pkg-config", "--cflags", "--libs", name,
                            PKG_CONFIG_PATH=str(self.prefix / "lib/pkgconfig")).split()
            for compiler in COMPILERS:
                with self.subTest(component=component, compiler=compiler):
                    program = self.folder / f"{component}-{compiler}"
                    command(compiler, "-std=c++20", HERE / f"{component}.cpp", "-o", program, *flags)
                    command(program)

    def test_headers_as_a_part_need_no_dependency(self):
        none = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in DEPENDENCIES]
        build = self.configure("g++", "-DCOMPONENTS=headers", f"-DPOLHODE_SOURCE={ROOT}",
                               "-DPOLHODE_LIBRARY=OFF", *none)
        self.build_and_run(build, "headers")

    def test_the_library_as_a_part_adds_itself_alone(self):
        build = self.configure("g++", "-DCOMPONENTS=library", f"-DPOLHODE_SOURCE={ROOT}",
                               "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DPOLHODE_QUICK_BUILD=OFF")
        compiled = json.loads((build / "compile_commands.json").read_text())
        of_it = {Path(c["file"]).relative_to(ROOT).parts[0] for c in compiled
                 if Path(c["file"]).is_relative_to(ROOT)}
        self.assertEqual(of_it, {"src", "tests"})  # tests: library.cpp

    def test_warnings_are_errors_for_developers_only(self):
        build = Path(tempfile.mkdtemp(dir=self.folder))
        command("cmake", "-S", ROOT, "-B", build)
        self.assertNotIn("-Werror", (build / "compile_commands.json").read_text())
        presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
        self.assertEqual(presets[0]["cacheVariables"]["POLHODE_DEVELOPER"], "ON")


class WithoutHdf5(unittest.TestCase):
    def test_no_source_of_such_a_build_includes_its_header(self):
        """A build takes minutes; what its sources include, directly or not, is known after it is configured."""
        includes = {}

        def included(path):
            if path not in includes:
                includes[path] = set()
                for name in re.findall(r'^#include ["<]([^">]+)', path.read_text(encoding="utf-8"), re.M):
                    files = (path.parent / name, ROOT / "include" / name, ROOT / "src" / name)
                    found = next((file for file in files if file.exists()), None)
                    includes[path] |= {name} if found is None else included(found.resolve())
            return includes[path]

        with tempfile.TemporaryDirectory() as folder:
            command("cmake", "-S", ROOT, "-B", folder, "-DPOLHODE_HDF5=OFF", "-DPOLHODE_TESTS=OFF",
                    "-DPOLHODE_BENCH=OFF", "-DPOLHODE_EXAMPLES=OFF", "-DPOLHODE_QUICK_BUILD=OFF",
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
            entries = json.loads((Path(folder) / "compile_commands.json").read_text(encoding="utf-8"))
            sources = {Path(e["file"]).resolve() for e in entries}
        ours = {path for path in sources if path.is_relative_to(ROOT / "src")}
        self.assertIn(ROOT / "src/io/formats/h5md_missing.cpp", ours)
        self.assertIn("hdf5.h", included(ROOT / "src/io/formats/h5md_writer.cpp"))
        self.assertEqual([str(path.relative_to(ROOT)) for path in sorted(ours) if "hdf5.h" in included(path)], [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    BUILD = parser.parse_args().build
    unittest.main(argv=[__file__], verbosity=2)
