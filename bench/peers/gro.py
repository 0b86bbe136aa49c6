# SPDX-License-Identifier: MIT
"""Initial configurations: GRO files are read, replicated and written, also as a LAMMPS data file."""

from math import sqrt
from typing import NamedTuple

NAMES = 20  # characters of residue number and name, atom name and atom number
SITES = 4  # of a TIP4P water: O, H, H, M
COULOMB = 138.935458 * 10 / 4.184  # e² N_A/(4 π ε₀) [kcal/mol Å/e²]


class Start(NamedTuple):
    labels: list  # (residue name, atom name) of each atom
    positions: list  # [nm]
    velocities: list  # [nm/ps]
    box: tuple  # edges [nm]

    @property
    def molecules(self):
        return len(self.labels) // SITES


def read(text):
    """A GRO file with velocities and a rectangular box, with any number of decimals."""
    lines = text.splitlines()
    count = int(lines[1])
    start = Start([], [], [], tuple(float(x) for x in lines[2 + count].split()[:3]))
    for line in lines[2 : 2 + count]:
        start.labels.append((line[5:10].strip(), line[10:15].strip()))
        dots = [i for i, c in enumerate(line) if c == "." and i >= NAMES]
        width = dots[1] - dots[0]
        numbers = [float(line[NAMES + k * width : NAMES + (k + 1) * width]) for k in range(3)]
        velocities = [float(x) for x in line[NAMES + 3 * width :].split()]
        start.positions.append(tuple(numbers))
        start.velocities.append(tuple(velocities))
    return start


def replicated(start, times):
    """The box replicated `times` times along each edge, image by image, with velocities."""
    images = [(i, j, k) for i in range(times) for j in range(times) for k in range(times)]
    shifts = [tuple(n * edge for n, edge in zip(image, start.box)) for image in images]
    return Start(
        start.labels * len(images),
        [tuple(x + s for x, s in zip(r, shift)) for shift in shifts for r in start.positions],
        start.velocities * len(images),
        tuple(times * edge for edge in start.box),
    )


def written(start, title):
    """The text of a GRO file, positions with 10 decimals and velocities with 11."""
    lines = [title, f"{len(start.labels):5d}"]
    for i, ((residue, atom), r, v) in enumerate(zip(start.labels, start.positions, start.velocities)):
        lines.append(
            f"{(i // SITES + 1) % 100000:5d}{residue[:5]:>5}{atom:>5}{(i + 1) % 100000:5d}"
            + "".join(f"{x:15.10f}" for x in r)
            + "".join(f"{x:15.11f}" for x in v)
        )
    lines.append("".join(f"{edge:15.10f}" for edge in start.box))
    return "\n".join(lines) + "\n"


def lammps_data(start, charges, masses):
    """A data file of atom style full in units real; site i of a water has the type min(i, 3)."""
    kinds = [1, 2, 2, 3]
    lines = ["TIP4P water", "", f"{len(start.labels)} atoms", "3 atom types", ""]
    lines += [f"0 {10 * edge:.12g} {x}lo {x}hi" for edge, x in zip(start.box, "xyz")]
    lines += ["", "Masses", "", *(f"{t} {m}" for t, m in enumerate(masses, 1)), "", "Atoms # full", ""]
    for i, r in enumerate(start.positions):
        kind = kinds[i % SITES]
        place = " ".join(f"{10 * x:.10f}" for x in r)
        lines.append(f"{i + 1} {i // SITES + 1} {kind} {charges[kind - 1]} {place}")
    lines += ["", "Velocities", ""]
    lines += [
        f"{i + 1} " + " ".join(f"{x / 100:.13f}" for x in v) for i, v in enumerate(start.velocities)
    ]
    return "\n".join(lines) + "\n"


def lammps_tables(rows, nearest, cutoff, charges):
    """Energy and force of the reaction field with infinite dielectric constant, for each pair of charged sites."""
    low, high = 10 * nearest, 10 * cutoff
    lines = []
    for name, qq in (("HH", charges[1] ** 2), ("HM", charges[1] * charges[2]), ("MM", charges[2] ** 2)):
        lines += [name, f"N {rows} RSQ {low} {high}", ""]
        for i in range(rows):
            r = sqrt(low**2 + (high**2 - low**2) * i / (rows - 1))
            energy = COULOMB * qq * (1 / r + r * r / (2 * high**3) - 1.5 / high)
            force = COULOMB * qq * (1 / r**2 - r / high**3)
            lines.append(f"{i + 1} {r:.12g} {energy:.15g} {force:.15g}")
        lines.append("")
    return "\n".join(lines)
