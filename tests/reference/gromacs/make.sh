#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes water with sodium chloride by GROMACS's own tools, and its energy by GROMACS: conf.gro,
# topol.top and energies.txt. Wants gmx (GROMACS 2022.5 of Debian 12 made the files here).
set -eu
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
export GMX_MAXBACKUP=-1

cat > topol.top <<'END'
; Water (TIP4P) with sodium chloride, of GROMACS's own force field.
#include "oplsaa.ff/forcefield.itp"
#include "oplsaa.ff/tip4p.itp"
#include "oplsaa.ff/ions.itp"

[ system ]
Sodium chloride

[ molecules ]
END
cat > "$work/em.mdp" <<'END'
integrator = steep
nsteps = 200
emstep = 0.001
cutoff-scheme = Verlet
coulombtype = PME
rcoulomb = 0.9
rvdw = 0.9
END
# Ewald's sum, finely resolved, and Lennard-Jones with GROMACS's switch, which is polhode's of smoothness 2.
cat > "$work/single.mdp" <<'END'
integrator = md
nsteps = 0
cutoff-scheme = Verlet
coulombtype = PME
rcoulomb = 0.9
ewald-rtol = 1e-6
fourierspacing = 0.05
pme-order = 8
vdwtype = Cut-off
vdw-modifier = Potential-switch
rvdw-switch = 0.75
rvdw = 0.9
DispCorr = no
continuation = yes
gen-vel = no
END

gmx solvate -cs tip4p.gro -box 2 2 2 -p topol.top -o "$work/water.gro"
gmx grompp -f "$work/em.mdp" -c "$work/water.gro" -p topol.top -o "$work/ions.tpr" -po "$work/po.mdp" -maxwarn 1
echo SOL | gmx genion -s "$work/ions.tpr" -p topol.top -o "$work/salt.gro" -np 3 -nn 3 -pname NA -nname CL -seed 7
gmx grompp -f "$work/em.mdp" -c "$work/salt.gro" -p topol.top -o "$work/em.tpr" -po "$work/po.mdp"
(cd "$work" && gmx mdrun -ntmpi 1 -ntomp 1 -s em.tpr -deffnm em)
# With seven decimals, as settles holds them: G96 has nine, and GROMACS reads as many as a GRO file has.
echo System | gmx trjconv -f "$work/em.trr" -s "$work/em.tpr" -dump 1000 -o "$work/em.g96"
python3 - "$work/em.g96" > conf.gro <<'END'
import sys
lines = open(sys.argv[1]).read().split("\n")
first = lines.index("POSITION") + 1
atoms = lines[first:lines.index("END", first)]
box = lines[lines.index("BOX") + 1].split()
print("water with sodium chloride", len(atoms), sep="\n")
for a in atoms:
    r = [float(a[24 + 15 * k:39 + 15 * k]) for k in range(3)]
    print("%5s%-5s%5s%5d" % (a[:5], a[6:11], a[12:17].strip(), int(a[17:24])) + "".join("%12.7f" % x for x in r))
print("".join("%12.7f" % float(x) for x in box))
END
gmx grompp -f "$work/single.mdp" -c conf.gro -p topol.top -o "$work/single.tpr" -po "$work/po.mdp"
cp conf.gro "$work"
(cd "$work" && gmx mdrun -ntmpi 1 -ntomp 1 -s single.tpr -rerun conf.gro -deffnm single)
printf 'LJ-(SR)\nCoulomb-(SR)\nCoul.-recip.\nPotential\n' | gmx energy -f "$work/single.edr" -o "$work/e.xvg" -dp
{
  echo '# time [ps], LJ-(SR), Coulomb-(SR), Coul.-recip., Potential [kJ/mol]'
  grep -v '^[#@]' "$work/e.xvg"
} > energies.txt
cat energies.txt
