# SPDX-License-Identifier: MIT
"""Energy drift, from the energy and from the shadow energy of the same runs of water, by `polhode run`: the table of
docs/shadow-and-bias.md."""

import argparse
import json
import subprocess
import sys
import tempfile
from datetime import date
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import machine

ROWS = [("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4), ("hoa2", 6)]  # scheme, step [fs]
WATER = 'molecules = [{ model = "tip4p" }]\ninitial_configuration = "w512"'
RUN_FILE = """[system]
{system}
[forces]
{forces}
precision = "mixed"
[run]
equilibrate = "{equilibrate:g} ps"
length = "{length:g} ps"
sample = "{sample:g} fs"
shadow_sample = "{sample:g} fs"
[output]
trajectory_every = "0 ps"
plot = "none"
"""


def sample(step):
    """Between energies, and between shadow energies: 4 fs in whole steps [fs]."""
    return step * max(1, round(4 / step))


def run(o, scheme, step):
    """What one run reports about both; the start has velocities, so the run is the same for every seed."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "run.toml").write_text(
            RUN_FILE.format(system=o.system, forces=o.forces, equilibrate=o.equilibrate, length=o.length,
                            sample=sample(step)), encoding="utf-8")
        done = subprocess.run([o.program, "run", "run.toml", "--scheme", scheme, "--step", f"{step:g} fs", "--threads",
                               str(o.threads), "--json"], cwd=folder, text=True, capture_output=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    said = json.loads(done.stdout)
    return {"scheme": scheme, "step_fs": step, "sample_fs": sample(step),
            **{key: said[key] for key in ("R", "rms_total_kJ_per_mol", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value",
                                          "shadow")}}


def number(x, error):
    return f"{x:.2g} ± {error:.1g}"


def table(runs):
    text = ["| scheme | step [fs] | R [%] | rms of E | rms of H̃ | drift of E (p-value) | drift of H̃ (p-value) | sooner |",
            "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for r in runs:
        s = r["shadow"]
        text.append(f"| {r['scheme']} | {r['step_fs']:g} | {100 * r['R']:.2f} | {r['rms_total_kJ_per_mol']:.2g} "
                    f"| {s['rms_kJ_per_mol']:.2g} | {number(r['drift_kJ_per_mol_ps'], r['drift_error'])} ({r['drift_p_value']:.1g}) "
                    f"| {number(s['drift_kJ_per_mol_ps'], s['drift_error'])} ({s['drift_p_value']:.1g}) "
                    f"| {s['time_gain']:.2g} times |")
    return "\n".join(text) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode", help="path of polhode")
    parser.add_argument("--system", default=WATER, help="lines for the table [system] of the run file")
    parser.add_argument("--forces", default="", help="lines for the table [forces] of the run file")
    parser.add_argument("--length", type=float, default=12, help="length of each run [ps]")
    parser.add_argument("--equilibrate", type=float, default=2, help="length of the equilibration [ps]")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--output", type=Path, default=Path(f"{date.today()}-shadow.json"))
    o = parser.parse_args()
    o.program = machine.program(o.program)
    runs = [run(o, scheme, step) for scheme, step in ROWS]
    o.output.write_text(json.dumps({"date": str(date.today()), "machine": machine.processor(),
                                    "command": f"bench/shadow/shadow.py --length {o.length:g} --equilibrate {o.equilibrate:g} "
                                               f"--threads {o.threads}", "runs": runs}, indent=1) + "\n", encoding="utf-8")
    print(table(runs), end="")


if __name__ == "__main__":
    main()
