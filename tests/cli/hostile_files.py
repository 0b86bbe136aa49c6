# SPDX-License-Identifier: MIT
"""Misleading, endless or huge files are read correctly or refused with their place, and what a format cannot store is not written."""

import resource
import signal
import subprocess

import sandbox
from sandbox import SMALL, Sandbox, edited

# Limit of CPU seconds for each of these files: a few are enough, while the faults that it detects took minutes. CPU
# time, so that a busy machine does not matter.
ENOUGH = 20

ARGON_XYZ = '2\nLattice="20 0 0 0 20 0 0 0 20" Properties=species:S:1:pos:R:3 Time={} pbc="T T T"\nAr 5 5 5\nAr {} 5 5\n'
CRYST = "CRYST1   20.000   20.000   20.000  90.00  90.00  90.00 P 1           1\n"


def atom(serial, name="AR", residue=1, x=5.0, location=" ", record="ATOM  "):
    """A PDB line; a serial given as text is written unchanged from column 7 on."""
    serial = f"{serial:5d}" if isinstance(serial, int) else serial
    return f"{record}{serial} {name:<4}{location}AR   {residue:4d}    {x:8.3f}{5:8.3f}{5:8.3f}  1.00  0.00          Ar\n"


SPCE = """[ defaults ]
1 2
[ atomtypes ]
OW  8  15.9994  0  A  0.316557  0.650629
HW  1  1.008    0  A  0         0
[ moleculetype ]
SOL 2
[ atoms ]
1 OW 1 SOL OW  1 -0.8476 15.9994
2 HW 1 SOL HW1 1  0.4238  1.008
3 HW 1 SOL HW2 1  0.4238  1.008
#ifndef FLEXIBLE
[ settles ]
1 1 0.1 0.16330
#endif
[ system ]
water
[ molecules ]
SOL 1
"""
SPCE_GRO = """water
3
    1SOL     OW    1   0.500   0.500   0.500
    1SOL    HW1    2   0.600   0.500   0.500
    1SOL    HW2    3   0.467   0.594   0.500
   2.50000   2.50000   2.50000
"""
WITH_TOPOLOGY = edited(SMALL, ('molecules = [{ model = "argon", count = 27 }]\nbox = "2.5 nm"',
                               'topology = "topol.top"\ninitial_configuration = "conf.gro"'))

WITH_DATA = edited(SMALL, ('molecules = [{ model = "argon", count = 27 }]\nbox = "2.5 nm"', 'initial_configuration = "in.data"'),
                   ("[forces]\n", '[forces]\nmixing = "geometric"\n'))
# A molecule of one atom and one of two, alternating.
DATA = """interleaved

6 atoms
3 atom types
0 25 xlo xhi
0 25 ylo yhi
0 25 zlo zhi

Masses

1 39.948
2 14.0067
3 14.0067

Pair Coeffs # lj/cut/coul/long

1 0.238 3.405
2 0.072 3.31
3 0.072 3.31

Atoms # full

1 1 1 0 2 2 2
2 2 2 0 8 8 8
3 2 3 0 9.1 8 8
4 3 1 0 2 14 2
5 4 2 0 8 18 8
6 4 3 0 9.1 18 8
"""


class HostileFiles(Sandbox):
    def polhode(self, *arguments, **environment):
        """Runs as usual, within generous limits."""
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        process = super().polhode(*arguments, **environment)
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime, ENOUGH, arguments)
        return process

    def converted(self, *arguments):
        process = self.polhode("convert", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        return process

    # PDB

    def test_pdb_serials_beyond_five_digits_are_read(self):
        for title, lines in [
            ("six digits from column 6", atom(99999) + atom("100000", record="ATOM ", residue=2, x=9)),
            ("six digits to column 12", atom(99999) + atom("100000", residue=2, x=9).replace("100000 ", "100000", 1)),
            ("hybrid-36", atom(99999) + atom("A0000", residue=2, x=9)),
            ("stars", atom(99999) + atom("*****", residue=2, x=9)),
            ("heteroatoms", atom(99999) + atom("100000", record="HETATM", residue=2, x=9).replace("100000 ", "100000", 1)),
        ]:
            with self.subTest(case=title):
                self.write("in.pdb", CRYST + lines + "END\n")
                self.converted("in.pdb", "out.xyz", "--force")
                self.assertEqual([line.split()[1] for line in (self.folder / "out.xyz").read_text().splitlines()[2:]],
                                 ["5.00000000", "9.00000000"])

    def test_pdb_columns_shifted_by_a_serial_are_refused(self):
        # y and z are so long that the digit before each gives another valid number.
        self.write("in.pdb", CRYST + f"ATOM  100000 {'AR':<4} AR      1    {5.1:8.3f}{1234.5:8.3f}{1005:8.3f}  1.00  0.00\n")
        self.refused(["convert", "in.pdb", "out.xyz"], ["in.pdb:2", "serial", "hybrid-36"])

    def test_pdb_serials_are_written_as_hybrid_36(self):
        count = 100003
        atoms = "".join(f"{k % 100000:5d}{'AR':<5}{'AR':>5}{k % 100000:5d}   1.000   1.000   1.000\n" for k in range(1, count + 1))
        self.write("in.gro", f"many\n{count}\n{atoms}   2.50000   2.50000   2.50000\n")
        self.converted("in.gro", "out.pdb")
        serials = [line[6:11] for line in (self.folder / "out.pdb").read_text().splitlines() if line.startswith("ATOM")]
        self.assertEqual(serials[99998:], ["99999", "A0000", "A0001", "A0002", "A0003"])
        self.converted("out.pdb", "back.gro")
        self.assertEqual((self.folder / "back.gro").read_text().splitlines()[1].strip(), str(count))

    def test_pdb_with_another_meaning_is_refused(self):
        for title, text, words in [
            ("alternate locations", CRYST + atom(1, location="A") + atom(2, location="B", x=5.5) + "END\n",
             ["in.pdb:3", "'A' and 'B'", "delete"]),
            ("no box of a crystal", CRYST.replace("20.000", " 1.000") + atom(1) + "END\n", ["in.pdb:1", "convention for a missing box"]),
            ("record of another name", CRYST + atom(1).replace("ATOM ", "ATOMS") + "END\n", ["in.pdb:2", "'ATOMS '", "HETATM"]),
        ]:
            self.write("in.pdb", text)
            self.refused(["convert", "in.pdb", "out.gro"], words, title)

    def test_pdb_models_without_an_end_are_frames(self):
        self.write("in.pdb", CRYST + "MODEL        1\n" + atom(1) + "MODEL        2\n" + atom(1, x=6) + "END\n")
        self.assertIn("2 frames", self.converted("in.pdb", "out.gro").out)

    def test_a_pdb_file_that_ends_within_a_model_is_refused(self):
        model = "MODEL        {}\n" + atom(1) + atom(2, x=9)
        for title, text in (("the only model", model.format(1)), ("the second model", model.format(1) + "ENDMDL\n" + model.format(2)[:-81])):
            self.write("in.pdb", CRYST + text)
            self.refused(["convert", "in.pdb", "out.gro"], ["in.pdb:", "ends within a MODEL", "cut off"], title)

    def test_an_input_is_not_replaced_by_an_output(self):
        self.write("self-prepared.toml", SMALL.replace('prefix = "out"', 'prefix = "self"'))
        self.refused(["prepare", "self-prepared.toml", "--force"], ["'self-prepared.toml' is an input of this command", "another prefix"])

    def test_a_byte_order_mark_loses_nothing(self):
        mark = b"\xef\xbb\xbf"
        self.write("in.pdb", mark + (atom(1) + CRYST + atom(2, residue=2, x=9) + "END\n").encode())
        self.converted("in.pdb", "a.gro")
        self.assertEqual((self.folder / "a.gro").read_text().splitlines()[1].strip(), "2")
        self.write("in.xyz", mark + ARGON_XYZ.format(0, 9).encode())
        self.converted("in.xyz", "b.gro")
        self.write("topol.top", mark + SPCE.encode())
        self.write("conf.gro", SPCE_GRO)
        self.done("energy", WITH_TOPOLOGY)

    # What a format cannot store

    def test_what_a_format_cannot_store_is_not_written(self):
        wide = ARGON_XYZ.format(0, 10000.0)
        more = ARGON_XYZ.format(1, 9).replace("2\n", "3\n", 1) + "Ar 2 2 2\n"
        late = ARGON_XYZ.format(1, 9) + ARGON_XYZ.format(5, 9)
        for title, text, out, words in [
            ("a coordinate above PDB's columns", wide, "out.pdb", ["1000 nm", ".pdb", "999.9999"]),
            ("a coordinate below PDB's columns", ARGON_XYZ.format(0, -1000.0), "out.pdb", ["-100 nm", "-99.9999"]),
            ("a box beyond PDB's columns", ARGON_XYZ.format(0, 9).replace('"20 ', '"100000 '), "out.pdb", ["10000 nm", ".pdb"]),
            ("coordinates beyond XTC's integers", ARGON_XYZ.format(0, 2e7), "out.xtc", ["2000000 nm", "1073741.8"]),
            ("another number of atoms in DCD", ARGON_XYZ.format(0, 9) + more, "out.dcd", ["1 ps", "3 atoms", "first frame has 2"]),
            ("another number of atoms in H5MD", ARGON_XYZ.format(0, 9) + more, "out.h5md", ["1 ps", "3 atoms", "first frame has 2"]),
            ("uneven times in DCD", ARGON_XYZ.format(0, 9) + late, "out.dcd", ["frame 3 is at 5 ps instead of 2 ps"]),
        ]:
            self.write("in.xyz", text)
            self.refused(["convert", "in.xyz", out], words, title)

    def test_gro_columns_widen(self):
        for x in ("100000.5", "-9999.5", "99999.99999999996"):
            self.write("in.xyz", ARGON_XYZ.format(0, x).replace('"20 ', '"2000000 '))
            self.converted("in.xyz", "out.gro", "--force")
            self.converted("out.gro", "back.xyz", "--force")
            back = (self.folder / "back.xyz").read_text().splitlines()
            self.assertAlmostEqual(float(back[3].split()[1]), float(x), delta=1e-8)
            self.assertIn('Lattice="2000000 ', back[1])

    def test_a_run_whose_box_is_too_large_for_its_format_does_not_start(self):
        text = edited(SMALL, ('"2.5 nm"', '"1200 nm"'), ('plot = "none"', 'plot = "none"\nformats = ["pdb"]'))
        self.write("run.toml", text)
        self.refused(["run", "run.toml"], ["1200 nm", "999.9999", "out-trajectory.pdb"])

    # LAMMPS

    def test_a_data_file_names_atoms_by_their_ids(self):
        self.write("in.data", DATA)
        self.write("in.xyz", '6\nLattice="25 0 0 0 25 0 0 0 25"\n' + "".join(
            f"X {' '.join(line.split()[4:7])}\n" for line in DATA.splitlines()[-6:]))
        self.converted("in.xyz", "in.dcd")
        self.converted("in.dcd", "out.gro", "--names", "in.data")
        atoms = (self.folder / "out.gro").read_text().splitlines()[2:8]
        self.assertEqual([line[10:15].strip() for line in atoms], ["Ar", "N1", "N2", "Ar", "N1", "N2"])
        self.assertEqual([round(float(line[20:35]), 4) for line in atoms], [0.2, 0.8, 0.91] * 2)

    def test_a_data_file_is_topology_and_initial_configuration(self):
        self.write("in.data", DATA)
        self.done("energy", WITH_DATA)

    def test_pair_styles_with_other_laws_are_refused(self):
        self.write("run.toml", WITH_DATA)
        for style in ("lj/cut/soft", "lj/cut/coul/long/soft", "lj/cut/thole/long", "lj/cut/dipole/cut", "lj/cutter"):
            self.write("in.data", DATA.replace("lj/cut/coul/long", style))
            self.refused(["energy", "run.toml"], [f"'{style}'", "lj/cut or buck", "in.data"], style)
        self.write("in.data", DATA.replace("lj/cut/coul/long", "lj/cut/coul/long/omp"))
        self.done("energy", WITH_DATA)

    def test_one_molecule_of_all_atoms_is_refused_quickly(self):
        count = 40000
        lines = "".join(f"{k} 1 1 0 {k % 200 / 10} {k // 200 % 200 / 10} {k // 40000}\n" for k in range(1, count + 1))
        head = DATA[:DATA.index("1 1 1 0 2 2 2")].replace("6 atoms", f"{count} atoms")
        self.write("in.data", head + lines)
        self.write("run.toml", WITH_DATA)
        self.refused(["energy", "run.toml"], [f"{count} sites", "1024", "in.data"])

    # GROMACS

    def test_misleading_topologies_are_refused(self):
        self.write("conf.gro", SPCE_GRO)
        types = "[ atomtypes ]\nOW  8  15.9994  0  A  0.3  0.6\n"
        for title, topology, words in [
            ("late atom types", SPCE.replace("[ system ]", types + "[ system ]"), ["topol.top:16", "after [ moleculetype ] 'SOL'"]),
            ("late pairs", SPCE.replace("[ system ]", "[ nonbond_params ]\nOW OW 1 0.3 0.6\n[ system ]"), ["topol.top:16", "after [ moleculetype ]"]),
            ("atom types given twice", SPCE.replace("[ moleculetype ]", types + "[ moleculetype ]", 1),
             ["topol.top:7", "topol.top:4", "other parameters"]),
        ]:
            self.write("topol.top", topology)
            self.write("run.toml", WITH_TOPOLOGY)
            self.refused(["energy", "run.toml"], words, title)
        self.write("topol.top", SPCE.replace("[ moleculetype ]", "[ atomtypes ]\nOW 8 15.9994 0.0 A 0.316557 0.650629\n[ moleculetype ]", 1))
        self.done("energy", WITH_TOPOLOGY)  # a repeated identical definition is allowed

    def test_incorrect_macros_are_refused(self):
        self.write("conf.gro", SPCE_GRO)
        self.write("topol.top", SPCE)
        self.write("run.toml", edited(WITH_TOPOLOGY, ("[forces]", 'define = ["-DFLEXIBLE"]\n\n[forces]')))
        self.refused(["energy", "run.toml"], ["'-DFLEXIBLE'", "without -D", "run.toml:6", "system.define"])
        self.write("run.toml", edited(WITH_TOPOLOGY, ("[forces]", 'define = ["FLEXIBLE"]\n\n[forces]')))
        self.refused(["energy", "run.toml"], ["not held rigid"])

    def test_nested_macros_are_limited(self):
        self.write("conf.gro", SPCE_GRO)
        macros = "#define A x x x x x x x x x x\n" + "".join(
            f"#define {name} {' '.join([within] * 10)}\n" for name, within in ("BA", "CB", "DC"))
        self.write("topol.top", SPCE.replace("[ system ]", macros + "[ dihedrals ]\n" + "D\n" * 20000 + "[ system ]"))
        self.write("run.toml", WITH_TOPOLOGY)
        self.refused(["energy", "run.toml"], ["topol.top", "4194304 words", "shorter macros"])

    # Others

    def test_boxes_that_are_not_periodic_or_not_numbers_are_refused(self):
        self.write("in.xyz", ARGON_XYZ.format(0, 9).replace('"T T T"', '"F F F"'))
        self.refused(["convert", "in.xyz", "out.gro"], ["in.xyz:2", 'pbc is "F F F"', "T T T"])
        self.write("ok.xyz", ARGON_XYZ.format(0, 9))
        self.converted("ok.xyz", "ok.dcd")
        dcd = bytearray((self.folder / "ok.dcd").read_bytes())
        angle = dcd.index(b"\x00\x00\x00\x00\x00\x80\x56\x40")  # 90
        dcd[angle:angle + 8] = b"\x00\x00\x00\x00\x00\x00\xf8\x7f"
        self.write("nan.dcd", bytes(dcd))
        self.refused(["convert", "nan.dcd", "out.xtc"], ["nan.dcd", "angle", "nan"])

    def test_keys_of_many_parts_are_refused(self):
        self.write("run.toml", ".".join(["a"] * 40000) + " = 1\n")
        self.refused(["energy", "run.toml"], ["run.toml:1", "dots"])
        self.write("run.toml", "x = [\n" + "{ a.a.a.a.a.a.a.a.a.a = [\n" * 200)
        self.refused(["energy", "run.toml"], ["run.toml:2", "dots"])
        self.done("energy", "# a.b.c.d.e.f.g.h.i.j.k.l\n" + SMALL.replace('"out"', '"out.1.2.3.4.5.6.7.8.9.10"'))

    def test_lengths_beyond_the_step_counter_are_refused(self):
        for old, new in [('length = "0.02 ps"', 'length = "1e300 ps"'), ('length = "0.02 ps"', 'length = "0.02 ps"\nequilibrate = "1e300 ps"'),
                         ('step = "2 fs"\n\n', 'step = "1e-300 fs"\n\n')]:
            self.write("run.toml", edited(SMALL, (old, new)))
            self.refused(["run", "run.toml"], ["run.toml"], new)

    def test_bins_and_windows_beyond_memory_are_refused(self):
        self.done("run", SMALL.replace("[output]", '[output]\ntrajectory_every = "4 fs"'))
        for option, words in [(["--bin", "1e-20 nm"], ["1e-20 nm", "larger width"]), (["--window", "1e300 ps"], ["1e+300", "shorter"])]:
            self.refused(["analyze", "out-trajectory.gro", "--molecules", "argon 27", "--plot", "none", *option], words)

    def test_records_of_a_study_are_read_in_linear_time(self):
        self.done("study", SMALL, "--output", "st")
        lines = (self.folder / "st-runs.csv").read_text().splitlines()
        fields = lines[-1].split(";")
        self.write("st-runs.csv", "\n".join(lines + [";".join([*fields[:2], str(k), *fields[3:]]) for k in range(2, 100000)]) + "\n")
        process = self.polhode("study", "run.toml", "--output", "st")
        self.assertEqual(process.returncode, 0, process.err)

    # H5MD

    def h5md(self):
        self.write("in.xyz", ARGON_XYZ.format(0, 9) + ARGON_XYZ.format(1, 8))
        self.converted("in.xyz", "in.h5md", "--force")
        return (self.folder / "in.h5md").read_bytes()

    def test_a_damaged_superblock_of_h5md_is_refused_at_once(self):
        whole = self.h5md()
        for place in range(48):  # the superblock and its checksum
            with self.subTest(byte=place):
                damaged = bytearray(whole)
                damaged[place] ^= 0xff
                self.write("damaged.h5md", bytes(damaged))
                process = self.polhode("convert", "damaged.h5md", "out.xyz", "--force")
                self.assertIn(process.returncode, (0, 2), process.err)

    def test_equal_runs_write_equal_h5md(self):
        text = SMALL.replace("[output]", '[output]\ntrajectory_every = "4 fs"\nformats = ["h5md"]')
        for output in ("one", "two"):
            self.done("run", text, "--output", output)
        one, two = ((self.folder / f"{output}-trajectory.h5md").read_bytes() for output in ("one", "two"))
        self.assertEqual(one, two)

    def test_h5md_on_a_full_disk_ends_with_an_error(self):
        """A limit of the file size stands for a full disk: --resume copies, and fails soon."""
        text = edited(SMALL, ('length = "0.02 ps"', 'length = "1 ps"'),
                      ("[output]", '[output]\ntrajectory_every = "2 fs"\nformats = ["h5md"]\ncheckpoint_every = "0.01 s"'))
        self.done("run", text)
        size = (self.folder / "out-trajectory.h5md").stat().st_size
        self.write("run.toml", edited(text, ('length = "1 ps"', 'length = "2 ps"')))
        before = (self.folder / "out-trajectory.h5md").read_bytes()
        for limit in (size // 8, size // 2, size + 4096):
            with self.subTest(limit=limit, size=size):
                process = self.limited(limit, "run", "run.toml", "--resume")
                self.assertEqual(process.returncode, 1, process.err)
                self.assertIn("disk full", process.err)
                self.assertEqual(list(self.folder.glob("*.part")), [])
                if limit < size:
                    self.assertEqual((self.folder / "out-trajectory.h5md").read_bytes(), before)
        process = self.polhode("run", "run.toml", "--resume")
        self.assertEqual(process.returncode, 0, process.err)

    def limited(self, size, *arguments):
        """Runs polhode with a limit of the file size in bytes; writing more is an error, not a signal."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        process = subprocess.run([sandbox.PROGRAM, *arguments], cwd=self.folder, text=True, stdin=subprocess.DEVNULL,
                                 capture_output=True, preexec_fn=limit, timeout=sandbox.LONGEST, check=False)
        process.err = process.stderr
        return process


if __name__ == "__main__":
    sandbox.main()
