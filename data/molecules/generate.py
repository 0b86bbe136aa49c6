#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the molecule files beside it from published bond lengths, angles and parameters.

    python3 data/molecules/generate.py

Every number stands here once, in the unit of its paper; positions get 17 significant digits.
"""
from math import cos, radians, sin, sqrt
from pathlib import Path

KCAL = 4.184  # kJ, thermochemical
R = 1.380649e-26 * 6.02214076e23  # kJ/mol/K, CODATA 2018
O, H, C, N, AR = ("O", 15.9994), ("H", 1.008), ("C", 12.011), ("N", 14.0067), ("Ar", 39.948)
M = ("", 0.0)  # a massless site


def digits(x):
    """A decimal number as it was published if it is short, else 17 significant digits."""
    short = f"{x + 0.0:.12g}"
    return short if float(short) == x else f"{x:.17g}"


def site(name, atom, r, charge=0.0, sigma=0.0, epsilon=0.0, note=""):
    """One [[site]]: r and sigma in nm, charge in e, epsilon in kJ/mol; note says where epsilon is from."""
    element, mass = atom
    lines = ["[[site]]", f'name = "{name}"']
    if element:
        lines.append(f'element = "{element}"')
    lines.append('position = "{} {} {} nm"'.format(*map(digits, r)))
    for key, value, unit in [("mass", mass, "u"), ("charge", charge, "e"), ("sigma", sigma, "nm")]:
        if value:
            lines.append(f'{key} = "{value:.12g} {unit}"')
    if epsilon:
        lines.append(f'epsilon = "{epsilon:.12g} kJ/mol"' + (f"  # {note}" if note else ""))
    return "\n".join(lines)


def molecule(name, geometry, description, source, sites):
    head = f'# {geometry}\nname = "{name}"\ndescription = "{description}"\nsource = "{source}"\n'
    text = head + "\n" + "\n\n".join(sites) + "\n"
    Path(__file__).with_name(f"{name}.toml").write_text(text, encoding="utf-8")


def kcal(x):
    return {"epsilon": x * KCAL, "note": f"{x:.4f} kcal/mol"}


def kelvin(x):
    return {"epsilon": x * R, "note": f"{x:g} K times k_B N_A"}


def water(bond, angle, q, oxygen, m=None):
    """O at the origin, hydrogens at `bond` and `angle`; the negative charge on M at distance m, else on O."""
    x, y = bond * sin(radians(angle / 2)), bond * cos(radians(angle / 2))
    sites = [
        site("OW", O, (0, 0, 0), charge=0.0 if m else -2 * q, **oxygen),
        site("HW1", H, (x, y, 0), charge=q),
        site("HW2", H, (-x, y, 0), charge=q),
    ]
    return sites + ([site("MW", M, (0, m, 0), charge=-2 * q)] if m else [])


molecule("tip3p", "TIP3P water: O-H 0.09572 nm, H-O-H 104.52 degrees; oxygen at the origin.",
         "three-site rigid water", "jorgensen1983",
         water(0.09572, 104.52, 0.417, {"sigma": 0.315061, **kcal(0.1521)}))

molecule("tip4p",
         "TIP4P water: O-H 0.09572 nm, H-O-H 104.52 degrees, O-M 0.015 nm on the bisector; "
         "oxygen at the origin.",
         "four-site rigid water", "jorgensen1983",
         water(0.09572, 104.52, 0.52, {"sigma": 0.315365, **kcal(0.1550)}, m=0.015))

molecule("tip4p-2005",
         "TIP4P/2005 water: O-H 0.09572 nm, H-O-H 104.52 degrees, O-M 0.01546 nm on the bisector; "
         "oxygen at the origin.",
         "four-site rigid water, refitted to the phase diagram", "abascal2005",
         water(0.09572, 104.52, 0.5564, {"sigma": 0.31589, **kelvin(93.2)}, m=0.01546))

# SPC/E gives its Lennard-Jones term as -(A/r)^6 + (B/r)^12 with A = 0.37122 and B = 0.3428
# (nm, kJ/mol): sigma = B²/A, epsilon = (A/B)^12 / 4.
A, B = 0.37122, 0.3428
molecule("spce", "SPC/E water: O-H 0.1 nm, H-O-H 109.47 degrees; oxygen at the origin.",
         "three-site rigid water, charges corrected for polarization", "berendsen1987",
         water(0.1, 109.47, 0.4238,
               {"sigma": B**2 / A, "epsilon": (A / B)**12 / 4,
                "note": "A = 0.37122, B = 0.3428: B²/A and (A/B)^12 / 4"}))

bond = 0.110
molecule("n2", "TraPPE nitrogen: N-N 0.11 nm along x, a charge at the centre.",
         "rigid nitrogen with a quadrupole", "potoff2001",
         [site("N1", N, (-bond / 2, 0, 0), -0.482, 0.331, **kelvin(36.0)),
          site("N2", N, (bond / 2, 0, 0), -0.482, 0.331, **kelvin(36.0)),
          site("MN", M, (0, 0, 0), 0.964)])

bond = 0.116
molecule("co2", "TraPPE carbon dioxide: C-O 0.116 nm, linear along x; carbon at the origin.",
         "rigid carbon dioxide with a quadrupole", "potoff2001",
         [site("C", C, (0, 0, 0), 0.70, 0.280, **kelvin(27.0)),
          site("O1", O, (-bond, 0, 0), -0.35, 0.305, **kelvin(79.0)),
          site("O2", O, (bond, 0, 0), -0.35, 0.305, **kelvin(79.0))])

d = 0.109 / sqrt(3)
molecule("ch4",
         "OPLS-AA methane, kept rigid: C-H 0.109 nm, tetrahedral; carbon at the origin. OPLS mixes sigma\n"
         "# geometrically; here, as for all models, sigma mixes arithmetically between unlike sites.",
         "five-site rigid methane", "jorgensen1996",
         [site("C", C, (0, 0, 0), -0.24, 0.350, **kcal(0.066))] +
         [site(f"H{i + 1}", H, r, 0.06, 0.250, **kcal(0.030))
          for i, r in enumerate([(d, d, d), (d, -d, -d), (-d, d, -d), (-d, -d, d)])])

cc, ch = 0.140, 0.108
h = sqrt(3) / 2
ring = [(1, 0), (0.5, h), (-0.5, h), (-1, 0), (-0.5, -h), (0.5, -h)]
molecule("benzene",
         "OPLS benzene: C-C 0.14 nm, C-H 0.108 nm, a regular hexagon about the origin in the xy plane. OPLS\n"
         "# mixes sigma geometrically; here, as for all models, sigma mixes arithmetically between unlike sites.",
         "twelve-site rigid benzene", "jorgensen1990",
         [site(f"C{k + 1}", C, (cc * c, cc * s, 0), -0.115, 0.355, **kcal(0.070))
          for k, (c, s) in enumerate(ring)] +
         [site(f"H{k + 1}", H, ((cc + ch) * c, (cc + ch) * s, 0), 0.115, 0.242, **kcal(0.030))
          for k, (c, s) in enumerate(ring)])

molecule("argon", "Argon: one site at the origin.", "Lennard-Jones argon", "rowley1975",
         [site("Ar", AR, (0, 0, 0), 0.0, 0.3405, **kelvin(119.8))])
