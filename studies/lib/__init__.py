# SPDX-License-Identifier: MIT
"""What all studies share: options, runs of the program, records, statistics and figures."""
