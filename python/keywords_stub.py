# SPDX-License-Identifier: MIT
"""keywords_stub.py FOLDER FILE: writes the types of polhode/_keywords.py to FILE, with the module _core in FOLDER."""

import importlib
import sys
import types
from pathlib import Path

folder, file = sys.argv[1:]
sys.path.insert(0, folder)
package = sys.modules["polhode"] = types.ModuleType("polhode")
package.__path__ = [str(Path(__file__).parent / "polhode")]
package._core = sys.modules["polhode._core"] = importlib.import_module("_core")
Path(file).write_text(importlib.import_module("polhode._keywords").stub(), encoding="utf-8")
