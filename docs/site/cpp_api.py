# SPDX-License-Identifier: MIT
"""The C++ API as pages of the site: a page for each folder of headers, which breathe fills from the XML of Doxygen.

cpp_api.py INCLUDE FOLDER: writes FOLDER/*.rst.
"""

import re
import sys
from pathlib import Path

HEADER = """{name}
{line}

.. code-block:: cpp

   #include "{path}"

.. doxygenfile:: {name}
   :sections: briefdescription detaileddescription innernamespace typedef enum innerclass public-type public-static-attrib public-attrib public-static-func public-func func var
"""


def header_text(path, included):
    """The directives of a header; breathe shows concepts only one by one."""
    concepts = re.findall(r"^concept (\w+)", path.read_text(encoding="utf-8"), re.M)
    return (HEADER.format(name=path.name, line="-" * len(path.name), path=included)
            + "".join(f"\n.. doxygenconcept:: polhode::{name}\n" for name in concepts))


def write(path, text):
    """Writes a file; one with this text keeps its date, so that Sphinx does not read it again."""
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main():
    include, pages = map(Path, sys.argv[1:3])
    pages.mkdir(parents=True, exist_ok=True)
    for folder in sorted({header.parent for header in include.rglob("*.hpp")}):
        title = folder.relative_to(include).as_posix()
        headers = [header_text(header, header.relative_to(include).as_posix()) for header in sorted(folder.glob("*.hpp"))]
        write(pages / f"{title.replace('/', '-')}.rst", "\n".join([title, "=" * len(title), "", *headers]))


main()
