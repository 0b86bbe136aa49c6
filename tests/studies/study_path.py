# SPDX-License-Identifier: MIT
"""Where tests find the studies, and the built program as benchmarks have it."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "studies"), str(ROOT / "tests/bench")]
