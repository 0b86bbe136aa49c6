# SPDX-License-Identifier: MIT
"""The output of polhode bench is complete; times are not tested, because they depend on the load."""

import json
import re

import sandbox
from sandbox import Sandbox

PARTS = {"forces", "list", "drift", "kick", "rest"}


class Bench(Sandbox):
    def test_json(self):
        process = self.polhode("bench", "--quick", "--json")
        self.assertEqual(process.returncode, 0, process.err)
        report = json.loads(process.out)
        self.assertIn(report["instruction_set"], report["instruction_sets"])
        self.assertTrue(report["processor"])
        self.assertTrue(report["verdict"])
        self.assertEqual([limit["precision"] for limit in report["limits"]], ["mixed", "double"])
        for limit in report["limits"]:
            self.assertGreater(limit["multiply_adds_per_ns"], 0)
            for kind in ("forces", "energies"):
                for pair in ("inside", "truncated"):
                    self.assertGreater(limit["pair_ns"][kind][pair]["best"], 0)
        self.assertEqual([(s["molecules"], s["precision"], s["threads"]) for s in report["systems"]],
                         [(512, p, n) for p in ("mixed", "double") for n in report["threads"]])
        for system in report["systems"]:
            self.assertEqual([e["switch_nm"] for e in system["evaluations"]], [0.765, 0.85])
            for e in system["evaluations"]:
                # The pairs of the built-in configuration within the cutoff, and their fraction of a list with skin.
                self.assertEqual(e["pairs"], system["evaluations"][0]["pairs"])
                self.assertTrue(0.5 < e["fill"] < 1, e["fill"])
                self.assertGreater(e["arithmetic_us"], 0)
                for key in ("forces_us", "energies_us", "list_us"):
                    self.assertTrue(0 < e[key]["best"] <= e[key]["median"], key)
            self.assertEqual([(t["scheme"], t["step_fs"], t["interactions"]) for t in system["steps"]],
                             [("hoa2", 4, "reaction field"), ("velocity-verlet", 2, "reaction field"),
                              ("gier4-fd", 5, "reaction field"), ("velocity-verlet", 2, "site switch"),
                              ("velocity-verlet", 2, "Ewald sum")])
            for t in system["steps"]:
                self.assertEqual(set(t["parts_us"]), PARTS)
                self.assertAlmostEqual(sum(t["parts_us"].values()) / t["step_us"]["best"], 1, 9)
                self.assertGreater(t["ns_per_day"], 0)
        self.assertEqual(self.contents(), {})

    def test_text_and_other_sizes(self):
        process = self.polhode("bench", "--quick", "--sizes", "216,600", "--precision", "mixed", "--threads", "1", "--verbose")
        self.assertEqual(process.returncode, 0, process.err)
        for words in ("216 waters", "600 waters", "multiply-adds", "mixed", "hoa2", "ns/day", "Ewald sum", "site switch"):
            self.assertIn(words, process.out)
        self.assertNotIn("double", process.out)
        self.assertNotIn("speed-up", process.out)

    def test_speed_up_by_threads(self):
        common = ("bench", "--quick", "--precision", "mixed", "--threads", "2", "--sizes", "216")
        lines = self.polhode(*common).out.splitlines()
        head = next(k for k, line in enumerate(lines) if line.startswith("waters "))
        self.assertEqual(lines[head - 1], "a step of velocity Verlet, 2 fs, without energies")
        self.assertEqual(re.split("  +", lines[head]),
                         ["waters", "interactions", "precision", "1 thread [ms]", "2 threads [ms]", "speed-up"])
        for line, interactions in zip(lines[head + 1:], ("reaction field", "site switch", "Ewald sum")):
            cells = re.split("  +", line.strip())
            self.assertEqual(cells[:3], ["216", interactions, "mixed"])
            one, two, ratio = map(float, cells[3:])
            self.assertAlmostEqual(one / two / ratio, 1, delta=0.02)  # of numbers with three digits

    def test_wrong_options(self):
        for options, words in ((("--sizes", "100"), ("cutoff", "100 waters")), (("--sizes", "0"), ("--sizes",)),
                               (("--sizes", "many"), ("--sizes",)), (("--precision", "half"), ("double", "mixed")),
                               (("--threads", "0"), ("--threads",)), (("--threads", "99999"), ("--threads",)),
                               (("--nonsense",), ("--nonsense",))):
            process = self.polhode("bench", "--quick", *options)
            self.assertEqual(process.returncode, 2, options)
            self.assertTrue(process.err.startswith("error: "), process.err)
            for word in words:
                self.assertIn(word, process.err)


if __name__ == "__main__":
    sandbox.main()
