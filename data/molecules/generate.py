#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the molecule files of this folder from published bond lengths, angles and parameters.

    python3 data/molecules/generate.py

Every number is given once, in the unit of its paper; positions get 17 significant digits.
"""
from math import cos, radians, sin, sqrt
from pathlib import Path

KCAL = 4.184  # kJ, thermochemical
R = 1.380649e-26 * 6.02214076e23  # kJ/mol/K, CODATA 2018
O, H, C, N, CL = ("O", 15.9994), ("H", 1.008), ("C", 12.011), ("N", 14.0067), ("Cl", 35.453)
NE, AR, KR, XE = ("Ne", 20.1797), ("Ar", 39.948), ("Kr", 83.798), ("Xe", 131.293)
NA, K = ("Na", 22.98977), ("K", 39.0983)
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


GEOMETRIC = 'Its sigma is meant to be mixed geometrically: mixing = "geometric" in a run file does so.'


def kcal(x):
    return {"epsilon": x * KCAL, "note": f"{x:.4f} kcal/mol"}


def kelvin(x):
    return {"epsilon": x * R, "note": f"{x:g} K times k_B N_A"}


def water(bond, angle, q, oxygen, m=None, charge=None):
    """O at the origin, hydrogens at `bond` and `angle`; the negative charge on M at distance m, else on O,
    unless that has another `charge`."""
    x, y = bond * sin(radians(angle / 2)), bond * cos(radians(angle / 2))
    if charge is None:
        charge = 0.0 if m else -2 * q
    sites = [
        site("OW", O, (0, 0, 0), charge=charge, **oxygen),
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

molecule("tip4p-ew",
         "TIP4P-Ew water: O-H 0.09572 nm, H-O-H 104.52 degrees, O-M 0.0125 nm on the bisector; "
         "oxygen at the origin.",
         "four-site rigid water, refitted with Ewald sums", "horn2004",
         water(0.09572, 104.52, 0.52422, {"sigma": 0.316435, **kcal(0.16275)}, m=0.0125))

molecule("tip4p-ice",
         "TIP4P/Ice water: O-H 0.09572 nm, H-O-H 104.52 degrees, O-M 0.01577 nm on the bisector; "
         "oxygen at the origin.",
         "four-site rigid water, refitted to ices", "abascal2005b",
         water(0.09572, 104.52, 0.5897, {"sigma": 0.31668, **kelvin(106.1)}, m=0.01577))

molecule("opc",
         "OPC water: O-H 0.08724 nm, H-O-H 103.6 degrees, O-M 0.01594 nm on the bisector; "
         "oxygen at the origin.",
         "four-site rigid water, charges free of the atoms", "izadi2014",
         water(0.08724, 103.6, 0.6791, {"sigma": 0.316655, "epsilon": 0.89036}, m=0.01594))

molecule("opc3", "OPC3 water: O-H 0.097888 nm, H-O-H 109.47 degrees; oxygen at the origin.",
         "three-site rigid water, optimal charges", "izadi2016",
         water(0.097888, 109.47, 0.447585, {"sigma": 0.317427, "epsilon": 0.68369}))

lone, q = 0.07, 0.241
x, y = lone * sin(radians(109.47 / 2)), lone * cos(radians(109.47 / 2))
molecule("tip5p",
         "TIP5P water: O-H 0.09572 nm, H-O-H 104.52 degrees; lone pairs at O-L 0.07 nm, L-O-L 109.47\n"
         "# degrees, on the other side of the oxygen, across the plane of the atoms; oxygen at the origin.",
         "five-site rigid water, charges on the lone pairs", "mahoney2000",
         water(0.09572, 104.52, q, {"sigma": 0.312, **kcal(0.16)}, charge=0.0) +
         [site("LP1", M, (0, -y, x), charge=-q), site("LP2", M, (0, -y, -x), charge=-q)])

# SPC and SPC/E give their Lennard-Jones term as -(A/r)^6 + (B/r)^12 with A = 0.37122 and B = 0.3428
# (nm, kJ/mol): sigma = B²/A, epsilon = (A/B)^12 / 4.
A, B = 0.37122, 0.3428
oxygen = {"sigma": B**2 / A, "epsilon": (A / B)**12 / 4,
          "note": "A = 0.37122, B = 0.3428: B²/A and (A/B)^12 / 4"}
molecule("spc", "SPC water: O-H 0.1 nm, H-O-H 109.47 degrees; oxygen at the origin.",
         "three-site rigid water", "berendsen1981", water(0.1, 109.47, 0.41, oxygen))
molecule("spce", "SPC/E water: O-H 0.1 nm, H-O-H 109.47 degrees; oxygen at the origin.",
         "three-site rigid water, charges corrected for polarization", "berendsen1987",
         water(0.1, 109.47, 0.4238, oxygen))

bond = 0.110
molecule("n2", "TraPPE nitrogen: N-N 0.11 nm along x, a charge at the centre.",
         "rigid nitrogen with a quadrupole", "potoff2001",
         [site("N1", N, (-bond / 2, 0, 0), -0.482, 0.331, **kelvin(36.0)),
          site("N2", N, (bond / 2, 0, 0), -0.482, 0.331, **kelvin(36.0)),
          site("MN", M, (0, 0, 0), 0.964)])

bond = 0.121
molecule("o2", "TraPPE oxygen: O-O 0.121 nm along x, a charge at the centre.",
         "rigid oxygen with a quadrupole", "zhang2006",
         [site("O1", O, (-bond / 2, 0, 0), -0.113, 0.302, **kelvin(49.0)),
          site("O2", O, (bond / 2, 0, 0), -0.113, 0.302, **kelvin(49.0)),
          site("MO", M, (0, 0, 0), 0.226)])

bond = 0.116
molecule("co2", "TraPPE carbon dioxide: C-O 0.116 nm, linear along x; carbon at the origin.",
         "rigid carbon dioxide with a quadrupole", "potoff2001",
         [site("C", C, (0, 0, 0), 0.70, 0.280, **kelvin(27.0)),
          site("O1", O, (-bond, 0, 0), -0.35, 0.305, **kelvin(79.0)),
          site("O2", O, (bond, 0, 0), -0.35, 0.305, **kelvin(79.0))])

bond = 0.1149
molecule("co2-epm2",
         "EPM2 carbon dioxide, kept straight: C-O 0.1149 nm, linear along x; carbon at the origin.\n"
         "# " + GEOMETRIC,
         "rigid carbon dioxide, fitted to its critical point", "harris1995",
         [site("C", C, (0, 0, 0), 0.6512, 0.2757, **kelvin(28.129)),
          site("O1", O, (-bond, 0, 0), -0.3256, 0.3033, **kelvin(80.507)),
          site("O2", O, (bond, 0, 0), -0.3256, 0.3033, **kelvin(80.507))])


def tetrahedron(radius):
    d = radius / sqrt(3)
    return [(d, d, d), (d, -d, -d), (-d, d, -d), (-d, -d, d)]


molecule("ch4",
         "OPLS-AA methane, kept rigid: C-H 0.109 nm, tetrahedral; carbon at the origin.\n"
         "# " + GEOMETRIC,
         "five-site rigid methane", "jorgensen1996",
         [site("C", C, (0, 0, 0), -0.24, 0.350, **kcal(0.066))] +
         [site(f"H{i + 1}", H, r, 0.06, 0.250, **kcal(0.030)) for i, r in enumerate(tetrahedron(0.109))])

# GROMOS gives square roots of C6 [(kJ/mol nm⁶)^1/2] and C12 [(kJ/mol nm¹²)^1/2]; sigma = (C12/C6)^1/6, epsilon =
# C6²/(4 C12). Geometric means of both are those of sigma and epsilon.
def gromos(root6, root12):
    return {"sigma": (root12 / root6)**(1 / 3), "epsilon": root6**4 / (4 * root12**2),
            "note": f"C6 = ({root6:g})², C12 = ({root12:g})²: C6²/(4 C12)"}


molecule("ccl4",
         "GROMOS carbon tetrachloride: C-Cl 0.176 nm, tetrahedral, without charges; carbon at the origin.\n"
         "# " + GEOMETRIC,
         "five-site rigid carbon tetrachloride", "oostenbrink2004",
         [site("C", C, (0, 0, 0), **gromos(0.051292, 2.7568e-3))] +
         [site(f"Cl{i + 1}", CL, r, **gromos(0.087201, 3.5732e-3)) for i, r in enumerate(tetrahedron(0.1760))])

# From the axis and along it, as published; N-H is 0.10136 nm, H-N-H 105.99 degrees.
out, up, down = 0.0934689, 0.0075705, 0.0316392
molecule("nh3", "Ammonia: N-H 0.10136 nm, H-N-H 105.99 degrees, three-fold about z.",
         "four-site rigid ammonia", "eckl2008",
         [site("N", N, (0, 0, up), -0.9993, 0.3376, **kelvin(182.9))] +
         [site(f"H{k + 1}", H, (out * c, out * s, -down), 0.3331)
          for k, (c, s) in enumerate([(1, 0), (-0.5, sqrt(3) / 2), (-0.5, -sqrt(3) / 2)])])

# CH3 and NH are united atoms, off the places of C and N as the fit put them.
molecule("methylhydrazine",
         "Monomethylhydrazine, CH3-NH-NH2: no two moments are equal and no plane is a mirror.\n"
         "# CH3 and NH are united atoms; masses are those of the atoms, each at its site.",
         "rigid monomethylhydrazine, without any symmetry", "elts2012",
         [site("CH3", ("C", C[1] + 3 * H[1]), (-0.0025, -0.0302, 0.1477), 0.0, 0.36072, **kelvin(120.15)),
          site("NH", ("N", N[1] + H[1]), (0.0043, 0.0597, 0.0036), 0.0, 0.33587, **kelvin(147.83)),
          site("N", N, (-0.0057, -0.0305, -0.1075), -0.6654, 0.33587, **kelvin(147.83)),
          site("H1", H, (0.0856, -0.0705, -0.1308), 0.3327),
          site("H2", H, (-0.0361, 0.0244, -0.1875), 0.3327)])

cc, ch = 0.140, 0.108
h = sqrt(3) / 2
ring = [(1, 0), (0.5, h), (-0.5, h), (-1, 0), (-0.5, -h), (0.5, -h)]
molecule("benzene",
         "OPLS benzene: C-C 0.14 nm, C-H 0.108 nm, a regular hexagon about the origin in the xy plane.\n"
         "# " + GEOMETRIC,
         "twelve-site rigid benzene", "jorgensen1990",
         [site(f"C{k + 1}", C, (cc * c, cc * s, 0), -0.115, 0.355, **kcal(0.070))
          for k, (c, s) in enumerate(ring)] +
         [site(f"H{k + 1}", H, ((cc + ch) * c, (cc + ch) * s, 0), 0.115, 0.242, **kcal(0.030))
          for k, (c, s) in enumerate(ring)])

molecule("argon", "Argon: one site at the origin.", "Lennard-Jones argon", "rowley1975",
         [site("Ar", AR, (0, 0, 0), 0.0, 0.3405, **kelvin(119.8))])

for name, atom, sigma, epsilon in [("neon", NE, 0.28010, 33.921), ("krypton", KR, 0.36274, 162.58),
                                   ("xenon", XE, 0.39011, 227.55)]:
    molecule(name, f"{name.capitalize()}: one site at the origin.", f"Lennard-Jones {name}", "vrabec2001",
             [site(atom[0], atom, (0, 0, 0), 0.0, sigma, **kelvin(epsilon))])

# Ions for one model of water each, sigma = 2^(5/6) times half the published distance of the minimum
# [nm], epsilon [kcal/mol].
for water_model, called, ions in [
        ("spce", "SPC/E", [("na", NA, 1, 0.1212, 0.3526418), ("k", K, 1, 0.1593, 0.4297054),
                           ("cl", CL, -1, 0.2711, 0.0127850)]),
        ("tip3p", "TIP3P", [("na", NA, 1, 0.1369, 0.0874393), ("k", K, 1, 0.1705, 0.1936829),
                            ("cl", CL, -1, 0.2513, 0.0355910)]),
        ("tip4p-ew", "TIP4P-Ew", [("na", NA, 1, 0.1226, 0.1684375), ("k", K, 1, 0.1590, 0.2794651),
                                  ("cl", CL, -1, 0.2760, 0.0116615)])]:
    for name, atom, q, half, epsilon in ions:
        long = {"na": "sodium", "k": "potassium", "cl": "chloride"}[name]
        molecule(f"{name}-{water_model}",
                 f"{long.capitalize()} ion for {called} water: half the distance of the minimum is {half:.4f} nm.",
                 f"{long} ion in {called} water", "joung2008",
                 [site(atom[0], atom, (0, 0, 0), q, 2**(5 / 6) * half, epsilon * KCAL, f"{epsilon:.7f} kcal/mol")])
