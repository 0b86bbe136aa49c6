# SPDX-License-Identifier: MIT
"""The tests of the documents fail on a planted fault, and pass without it."""

import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = '#!/usr/bin/env bash\n[[ $1 != wrong ]] && echo "$@"\n'
SOUND = """# Title
[here](README.md#title)
<!-- file: water.toml -->
```toml
step = "2 fs"
```
```sh
grep fs water.toml
polhode run water.toml > out.txt
./polhode run
```
```sh
grep run out.txt
```
```sh no-run
no-such-command
```
"""
FAULTS = [  # test, text added to the document, what the output must name
    ("run_commands", "```sh\npolhode run\npolhode wrong\ntrue\n```\n", "README.md:20: exit code 1"),
    ("run_commands", "```sh\ncat missing.toml | cat\n```\n", "README.md:19: exit code 1"),
    ("links", "[there](docs/nowhere.md)\n", "README.md:18: docs/nowhere.md"),
    ("links", "[there](#nowhere)\n", "README.md:18: no heading #nowhere"),
]


def result(test, text):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "README.md").write_text(text)
        program = root / "program"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        place = ["--program", program, "--root", root] if test == "run_commands" else [root]
        run = subprocess.run([sys.executable, HERE / f"{test}.py", *place], text=True,
                             capture_output=True, check=False)
    return run.returncode, run.stdout + run.stderr


wrong = []
for test in ("run_commands", "links"):
    code, output = result(test, SOUND)
    if code != 0:
        wrong.append(f"{test} is red on a sound document:\n{output}")
for test, fault, named in FAULTS:
    code, output = result(test, SOUND + fault)
    if code != 1 or named not in output:
        wrong.append(f"{test} does not say '{named}':\n{output}")
print("\n".join(wrong) or f"{len(FAULTS)} planted faults found")
sys.exit(1 if wrong else 0)
