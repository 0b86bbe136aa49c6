# SPDX-License-Identifier: MIT
"""Prints the command that loads the plugin in a script of LAMMPS."""

import argparse

from . import plugin


def main():
    parser = argparse.ArgumentParser(prog="polhode-lammps", description=__doc__)
    parser.add_argument("--path", action="store_true", help="print only the path of the plugin")
    print(plugin() if parser.parse_args().path else f"plugin load {plugin()}")


if __name__ == "__main__":
    main()
