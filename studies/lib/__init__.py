# SPDX-License-Identifier: MIT
"""The library of all studies: options, runs of the program, records, statistics and figures."""
