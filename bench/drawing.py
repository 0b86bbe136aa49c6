# SPDX-License-Identifier: MIT
"""Figures of the benchmarks: a gnuplot script is stored with its image, so that the figure can be changed."""

import shutil
import subprocess


def head(image, width, height):
    """The lines that figures of R against cost begin with."""
    terminal = (f'svg size {width},{height} dynamic enhanced font "Helvetica,13"' if image.suffix != ".png" else
                f'pngcairo size {width},{height} enhanced font "Helvetica,10"')
    return [f"# Restyle this and run it again: gnuplot draws {image.name}.", "set encoding utf8", "set minussign",
            f'set terminal {terminal} background "white"', f'set output "{image.name}"',
            'set border 3 linewidth 1 linecolor "#404040"', 'set tics nomirror out scale 0.6 textcolor "#404040"',
            'set grid linewidth 0.5 linecolor "#e4e4e4"',
            'set key top right textcolor "#404040" samplen 1.5 spacing 1 noenhanced font ",9"', "set logscale y",
            'set ylabel "R  (%)" offset 1']


def draw(script, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    stored = image.with_suffix(".gp")
    stored.write_text(script, encoding="utf-8")
    if not shutil.which("gnuplot"):
        print(f"no gnuplot on PATH, so no figure; its script is {stored}")
        return
    subprocess.run(["gnuplot", stored.name], cwd=image.resolve().parent, check=True)
