# SPDX-License-Identifier: MIT
"""polhode bias: energies of runs of polhode, whose summaries predict the same bias."""

import json
import unittest

import sandbox
from sandbox import Sandbox

RUN = """[system]
molecules = [{ model = "tip4p", count = 64 }]
density = "1 g/cm3"
temperature = "298 K"
seed = 3
[forces]
cutoff = "0.6 nm"
precision = "mixed"
[integrator]
scheme = "velocity-verlet"
step = "4 fs"
[run]
minimise = true
equilibrate = "5 ps"
length = "40 ps"
sample = "8 fs"
shadow_sample = "8 fs"
[output]
prefix = "run"
trajectory_every = "0 ps"
plot = "none"
"""
THERMOSTAT = '[thermostat]\ntype = "rescaling"\ntime_constant = "0.1 ps"\n'


class Bias(Sandbox):
    def both(self, text):
        """The bias of the potential energy by the summary of a run, and by its energies file."""
        self.write("run.toml", text)
        run = self.polhode("run", "run.toml", "--json", "--force")
        self.assertEqual(run.returncode, 0, run.err)
        process = self.polhode("bias", "run-energies.csv", "--json")
        self.assertEqual(process.returncode, 0, process.err)
        bias = json.loads(process.out)
        found = next(c for c in bias["columns"] if c["name"] == "potential")["bias"]
        summary = json.loads(run.out)["step_bias"]["potential_kJ_per_mol"]
        return bias, {key: found[key] / 64 for key in ("value", "error")}, summary

    def test_constant_energy(self):
        bias, found, summary = self.both(RUN)
        self.assertEqual(bias["ensemble"], "constant energy")
        # The same samples; only the line through the energy is removed here. It takes 4 τ/T of a slow part of the
        # covariance, 10 % with τ = 1 ps.
        self.assertLess(abs(found["value"] - summary["value"]), 0.1 * summary["value"] + summary["error"])
        self.assertGreater(summary["value"], 5 * summary["error"])
        # Constant temperature: times C/C_K, which is 2 for harmonic modes; liquid water has more.
        ratio = bias["potential_bias_at_constant_temperature"]["value"] / 64 / found["value"]
        self.assertGreater(ratio, 1.5)
        self.assertLess(ratio, 6)

    def test_a_thermostat(self):
        """Eq. (53) of the theory, compared with Eq. (48), which uses samples of the shadow energy of the same run."""
        bias, found, summary = self.both(RUN + THERMOSTAT)
        self.assertEqual(bias["ensemble"], "thermostat")
        self.assertEqual(bias["warnings"], [])
        # Both are estimates from one trajectory, so they differ by less than independent ones.
        self.assertLess(abs(found["value"] - summary["value"]), 3 * (found["error"] ** 2 + summary["error"] ** 2) ** 0.5)
        self.assertGreater(found["value"], 3 * found["error"])

    def test_a_langevin_thermostat_is_not_taken_for_rescaling(self):
        self.write("run.toml", RUN.replace('shadow_sample = "8 fs"\n', "") + '[thermostat]\ntype = "langevin"\nfriction = "5 /ps"\n')
        run = self.polhode("run", "run.toml", "--json", "--force")
        self.assertEqual(run.returncode, 0, run.err)
        process = self.polhode("bias", "run-energies.csv")
        self.assertTrue(process.returncode == 2 or "WARNING" in process.out, process.out)

    def test_wrong_input(self):
        self.write("a.csv", "time,total [kJ/mol],potential [kJ/mol]\n0,1,2\n1,2,x\n")
        self.refused(("bias", "a.csv"), ["a.csv:3", "'x'"])
        self.refused(("bias", "absent.csv"), ["absent.csv"])
        self.write("b.csv", "time,total [kJ/mol],potential [kJ/mol]\n" + "".join(f"{k},{k % 3},{k % 7}\n" for k in range(12)))
        self.refused(("bias", "b.csv"), ["no temperature", "298 K"])
        self.refused(("bias", "b.csv", "--temperature", "298 K", "--start", "50"), ["no row has a time from 50; the times are 0 to 11"])
        self.refused(("bias", "b.csv", "--temperature", "298 K", "--start", "50", "--stop", "40"), ["no row has a time from 50 up to 40; the"])
        self.refused(("bias", "b.csv", "--temperature", "298 K", "--start", "10 ps"), ['--start = "10 ps" must be a number without a unit', "unit of the log; write for example 0"])
        self.write("d.csv", "time,total [kJ/mol],potential [kJ/mol]\n" + "".join(f"{k},1,-5000\n" for k in range(12)))
        self.refused(("bias", "d.csv", "--temperature", "298 K"), ["'potential' has the value -5000 in every row", "more digits"])
        self.write("yaml.log", "---\nkeywords: ['Step', 'PotEng', 'TotEng', ]\ndata:\n  - [0, -5000, -3000, ]\n  - [10, -5001, -3001, ]\n...\n")
        self.refused(("bias", "yaml.log"), ["the log of LAMMPS has no rows of energies", "thermo_style custom"])
        self.write("c.csv", "time [ps],total [kJ/mol],potential [kJ/mol]\n" + "".join(f"{k},{k % 3},{k % 7}\n" for k in range(12)))
        self.refused(("bias", "c.csv", "--temperature", "298 K", "--stop", "late"), ['--stop = "late" must be a number without a unit', "unit of the log, ps; write"])
        self.refused(("bias", "b.csv", "--temperature", "-1 K"), ["--temperature", "-1 K"])


if __name__ == "__main__":
    sandbox.main()
