# SPDX-License-Identifier: MIT
"""Trajectories of every format, read back by MDAnalysis, mdtraj and h5py, and H5MD files after kill -9."""

import signal
import time
import unittest
import warnings

import sandbox
from sandbox import SMALL, Sandbox, edited

try:
    import h5py
    import MDAnalysis
    import mdtraj
    import numpy
except ImportError as missing:
    print(f"skipped: {missing}; on Debian: apt-get install python3-h5py python3-mdanalysis python3-mdtraj")
    raise SystemExit(77) from None

FORMATS = ["gro", "pdb", "xyz", "xtc", "trr", "dcd", "h5md"]
WATER = edited(SMALL, ('"argon"', '"tip4p"'), ('"100 K"', '"297 K"'),
               ('plot = "none"', f'plot = "none"\ntrajectory_every = "4 fs"\nformats = {FORMATS}'.replace("'", '"')))
# nm: half of the last digit of a format, and that of the float which both readers keep, 2^-24 of 25 Å.
LAST_DIGIT = {"gro": 0, "pdb": 0.5e-4, "xyz": 0.5e-9, "xtc": 0.5e-3, "trr": 0, "dcd": 0, "h5md": 0}
FLOAT = 3 * 2.0**-22
warnings.filterwarnings("ignore")


class Formats(Sandbox):
    def trajectory(self, ending):
        return str(self.folder / f"out-trajectory.{ending}")

    def truth(self):
        """Positions [nm], velocities [nm/ps] and times [ps] of the GRO file, which has ten decimals."""
        r, v, times = [], [], []
        lines = (self.folder / "out-trajectory.gro").read_text(encoding="utf-8").splitlines()
        while lines:
            times.append(float(lines[0].split("t=")[1]))
            count = int(lines[1])
            atoms = lines[2:2 + count]
            r.append([[float(a[20 + 15 * k:35 + 15 * k]) for k in range(3)] for a in atoms])
            v.append([[float(a[65 + 15 * k:80 + 15 * k]) for k in range(3)] for a in atoms])
            lines = lines[3 + count:]
        return numpy.array(r), numpy.array(v), numpy.array(times)

    def check(self, ending, found, truth):
        self.assertEqual(found.shape, truth.shape, ending)
        self.assertLessEqual(numpy.abs(found - truth).max(), LAST_DIGIT[ending] * 1.0001 + FLOAT, ending)

    def test_other_programs_read_our_files(self):
        self.done("run", WATER)
        r, v, times = self.truth()
        self.assertEqual(len(times), 6)
        self.done_convert("out-trajectory.gro", "first.gro", "--to", "0 ps")
        first = str(self.folder / "first.gro")
        for ending in ["pdb", "xyz", "xtc", "trr", "dcd", "h5md"]:
            with self.subTest(ending=ending):
                universe = MDAnalysis.Universe(first, self.trajectory(ending), convert_units=True)
                frames = [(f.positions.copy() / 10, f.dimensions, f.time,
                           f.velocities / 10 if f.has_velocities else None) for f in universe.trajectory]
                self.check(ending, numpy.array([f[0] for f in frames]), r)
                if ending not in ("pdb", "xyz"):
                    numpy.testing.assert_allclose([f[2] for f in frames], times, atol=2e-7)
                if ending != "xyz":
                    numpy.testing.assert_allclose([f[1] for f in frames], [[25, 25, 25, 90, 90, 90]] * 6, atol=1e-5)
                if ending in ("trr", "h5md"):
                    numpy.testing.assert_allclose([f[3] for f in frames], v, atol=4e-6)
        for ending in ["pdb", "xtc", "trr", "dcd"]:
            with self.subTest(mdtraj=ending):
                read = mdtraj.load(self.trajectory(ending), top=first) if ending != "pdb" else mdtraj.load(self.trajectory(ending))
                self.check(ending, read.xyz.astype(float), r)
                numpy.testing.assert_allclose(read.unitcell_lengths, [[2.5, 2.5, 2.5]] * 6, atol=1e-6)

    def done_convert(self, *arguments):
        process = self.polhode("convert", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        return process

    def test_h5md_has_bodies_observables_and_units(self):
        self.done("run", WATER)
        r, _, times = self.truth()
        with h5py.File(self.trajectory("h5md")) as file:
            self.assertEqual(list(file["h5md"].attrs["version"]), [1, 1])
            self.assertEqual(file["particles/all/position/value"].attrs["unit"], "nm")
            self.assertEqual(file["observables/potential_energy/value"].attrs["unit"], "kJ mol-1")
            numpy.testing.assert_array_equal(file["particles/bodies/orientation/time"][:], times)
            orientation = file["particles/bodies/orientation/value"][:]
            numpy.testing.assert_allclose((orientation**2).sum(axis=2), 1, atol=1e-14)
            mass = file["particles/all/mass"][:4]
            self.assertEqual(mass[3], 0)
            # The centre of the first water equals that of its sites, up to whole box edges.
            centre = file["particles/bodies/position/value"][:, 0]
            off = (r[:, :4] * mass[:, None]).sum(axis=1) / mass.sum() - centre
            off -= 2.5 * numpy.round(off / 2.5)
            self.assertLess(numpy.abs(off).max(), 1e-9)
            energies = self.rows("out-energies.csv")
            column = energies[0].split(",").index("potential [kJ/mol]")
            expected = {round(float(line.split(",")[0]), 6): float(line.split(",")[column]) for line in energies[1:]}
            numpy.testing.assert_allclose(file["observables/potential_energy/value"][:],
                                          [expected[round(t, 6)] for t in times], rtol=1e-12)

    def test_h5md_frames_of_a_killed_run_are_readable(self):
        endless = edited(WATER, ('length = "0.02 ps"', 'length = "1000 ps"'))
        self.write("run.toml", endless)
        process = self.start("run", "run.toml")
        end = time.monotonic() + sandbox.LONGEST
        while (seen := self.frames_so_far()) < 3:  # read while it is written
            self.assertIsNone(process.poll(), "it ended by itself")
            self.assertLess(time.monotonic(), end, "it never came so far")
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        self.done_convert("out-trajectory.h5md", "saved.gro")
        self.assertGreaterEqual((self.folder / "saved.gro").read_text().count("t="), seen)

    def frames_so_far(self):
        """Frames that another program finds in all series of the H5MD file of a run in progress; 0 as long as it cannot be opened."""
        try:
            with h5py.File(self.trajectory("h5md"), "r", libver="latest", swmr=True) as file:
                lengths = []
                file.visititems(lambda name, item: lengths.append(len(item)) if name.endswith("/value") else None)
                return min(lengths, default=0)
        except OSError:
            return 0

    def test_a_killed_run_resumes_in_its_h5md_file(self):
        self.write("run.toml", edited(WATER, ('length = "0.02 ps"', 'length = "4 ps"'), ("formats = ", "# "),
                                      ('plot = "none"', 'plot = "none"\nformats = ["h5md", "xtc"]\ncheckpoint_every = "0.01 s"')))

        def left_behind():
            """All numbers of the H5MD file, and the bytes of the XTC file."""
            numbers = {}
            with h5py.File(self.trajectory("h5md")) as file:
                file.visititems(lambda name, item: numbers.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
            return numbers, (self.folder / "out-trajectory.xtc").read_bytes()

        start = time.monotonic()
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        took = time.monotonic() - start
        whole, packed = left_behind()
        self.assertEqual(len(whole["particles/all/position/value"]), 1001)
        for path in self.folder.glob("out*"):
            path.unlink()
        self.kill_at_random_moments(3, took / 3, "run", "run.toml", "--resume")
        process = self.polhode("run", "run.toml", "--resume")
        self.assertEqual(process.returncode, 0, process.err)
        again, packed_again = left_behind()
        self.assertEqual(packed_again, packed)
        self.assertEqual(again.keys(), whole.keys())
        for name, numbers in whole.items():
            numpy.testing.assert_array_equal(again[name], numbers, name)

    def test_convert_between_all_formats_and_select(self):
        self.done("run", WATER)
        r, _, times = self.truth()
        here = "out-trajectory.gro"
        for ending in ["h5md", "trr", "dcd", "xyz", "xtc", "pdb", "gro"]:
            there = f"around.{ending}"
            self.done_convert(here, there, "--names", "out-trajectory.gro")
            here = there
        lines = (self.folder / here).read_text().splitlines()
        last = numpy.array([[float(a[20 + 15 * k:35 + 15 * k]) for k in range(3)] for a in lines[2:110]])
        self.assertLess(numpy.abs(last - r[0]).max(), 0.5e-3 + 0.5e-4 + 1e-6)  # XTC and PDB round
        process = self.done_convert("out-trajectory.trr", "some.xtc", "--from", "4 fs", "--to", "16 fs", "--every", "2")
        self.assertRegex(process.err, r"velocities are not written, because the format of '\S+' cannot store velocities")
        self.assertEqual(process.out, "2 frames written to some.xtc\n")
        self.assertEqual(list(mdtraj.open(str(self.folder / "some.xtc")).read()[1]), list(numpy.float32(times[[1, 3]])))

    def test_errors_of_convert_have_a_remedy(self):
        self.done("run", WATER)
        for arguments, parts in [
            (["out-trajectory.xtc", "a.gro"], ["has no atom names", "conf.gro"]),
            (["out-trajectory.xtc", "a.grp"], ["the extension of 'a.grp' is unknown", "'gro'"]),
            (["out-trajectory.gro", "out-trajectory.pdb"], ["exists and would be overwritten", "--force"]),
            (["out-trajectory.gro", "a.pdb", "--from", "1 ps"], ["no frame", "first and the last time"]),
            (["out-trajectory.gro", "a.pdb", "--every", "0"], ["from 1 to", "whole number"]),
            (["out-trajectory.gro", "a.pdb", "--from", "2 ps", "--to", "1 ps"], ["2 ps", "1 ps", "swap"]),
            (["run.toml", "a.pdb"], ["the extension of 'run.toml' is unknown"]),
        ]:
            before = self.contents()
            process = self.polhode("convert", *arguments)
            self.assertEqual(process.returncode, 2, process.err)
            for part in parts:
                self.assertIn(part, process.err)
            self.assertEqual(self.contents(), before)


if __name__ == "__main__":
    sandbox.main()
