# SPDX-License-Identifier: MIT
"""Pictures of the benchmarks: a gnuplot script kept beside its image, so that either can be changed."""

import shutil
import subprocess


def draw(script, image):
    """Writes the script beside the image and runs gnuplot on it."""
    beside = image.with_suffix(".gp")
    beside.write_text(script, encoding="utf-8")
    if not shutil.which("gnuplot"):
        print(f"no gnuplot on PATH, so no figure; its script is {beside}")
        return
    subprocess.run(["gnuplot", beside.name], cwd=image.resolve().parent, check=True)
