# SPDX-License-Identifier: MIT
"""Prints the command that loads the plugin in a script of LAMMPS."""

from . import plugin


def main():
    print(f"plugin load {plugin()}")


if __name__ == "__main__":
    main()
