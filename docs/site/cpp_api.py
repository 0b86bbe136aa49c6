# SPDX-License-Identifier: MIT
"""The C++ API as pages of the site, from the XML of Doxygen: a page for each folder of headers.

cpp_api.py XML INCLUDE FOLDER: writes FOLDER/*.rst. Each header has its opening comment and, in the order of
the file, what it declares.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from pathlib import Path

# What a signature begins with. Sphinx does not parse it: its parser takes a minute for these headers.
KINDS = {"function": "", "variable": "", "typedef": "using ", "enum": "enum class ", "struct": "struct ", "class": "class ",
         "concept": "concept "}


# Text of comments.

def escaped(text):
    """Plain text in which reStructuredText sees no marks."""
    return re.sub(r"([\\*`|])|(?<=\w)(_)(?!\w)", r"\\\1\2", text or "")


def inline(node):
    """The text of a node on one line, with its marks."""
    text = escaped(node.text)
    for child in node:
        inner = "".join(child.itertext())
        if child.tag == "computeroutput" and inner.strip():
            text += f"\\ ``{inner.strip()}``\\ "
        elif child.tag in ("emphasis", "bold") and inner.strip():
            mark = "*" if child.tag == "emphasis" else "**"
            text += f"\\ {mark}{escaped(inner.strip())}{mark}\\ "
        elif child.tag == "ulink":
            text += f"\\ `{inner} <{child.get('url')}>`__\\ "
        elif child.tag not in BLOCKS:
            text += inline(child)
        text += escaped(child.tail)
    return re.sub(r"\s+", " ", text)


def parameters(node):
    heading = {"param": "", "templateparam": "", "exception": "throws ", "retval": "value "}[node.get("kind")]
    for item in node.iter("parameteritem"):
        names = ", ".join("".join(n.itertext()) for n in item.iter("parametername"))
        yield f"- {heading}**{escaped(names)}**: {inline(item.find('parameterdescription')).strip()}"
    yield ""


def section(node):
    title = node.findtext("title") or node.get("kind").capitalize()
    yield f"**{title}:** " + " ".join(inline(p).strip() for p in node.findall("para"))
    yield ""


def items(node):
    for item in node.findall("listitem"):
        yield "- " + " ".join(inline(p).strip() for p in item.findall("para"))
    yield ""


def verbatim(node):
    lines = ["".join(" " if n.tag == "sp" else n.text or "" for n in line.iter()) for line in node.iter("codeline")]
    yield from ["::", ""]
    yield from ("   " + line for line in lines or "".join(node.itertext()).splitlines())
    yield ""


BLOCKS = {"parameterlist": parameters, "simplesect": section, "itemizedlist": items, "orderedlist": items,
          "verbatim": verbatim, "programlisting": verbatim, "preformatted": verbatim}


def paragraphs(description):
    """The lines of a description."""
    for paragraph in description if description is not None else ():
        text = inline(paragraph).strip()
        if text:
            yield from [text, ""]
        for block in paragraph:
            if block.tag in BLOCKS:
                yield from BLOCKS[block.tag](block)


def description(node):
    return [*paragraphs(node.find("briefdescription")), *paragraphs(node.find("detaileddescription"))]


# Declarations.

def spaced(code):
    """Code with the spaces of this project: Vec3<double>& J."""
    code = re.sub(r"\s+", " ", code).replace("< ", "<").replace(" >", ">")
    return re.sub(r" ([&*]+) ?(?=\w)", r"\1 ", code).strip()


def plain(node):
    return spaced("".join(node.itertext())) if node is not None else ""


def template(node):
    """The line `template <...>` of a declaration, with its constraints; empty for others."""
    given = node.find("templateparamlist")
    if given is None:
        return ""
    names = []
    for p in given.findall("param"):
        default = plain(p.find("defval"))
        name = p.findtext("declname") or ""
        names.append(" ".join(filter(None, (plain(p.find("type")), name))) + (f" = {default}" if default else ""))
    requires = plain(node.find("requiresclause"))
    return f"template<{', '.join(names)}> " + (f"requires {requires} " if requires else "")


def signature(node, inside=False):
    """The declaration on one line; inside its class a member has its own name alone."""
    kind = node.get("kind")
    word = KINDS[kind]
    qualified = node.findtext("qualifiedname") or node.findtext("compoundname")
    name = node.findtext("name") if inside else qualified.removeprefix("polhode::")
    if kind == "function":
        arguments = spaced(node.findtext("argsstring"))
        words = [w for w in ("static", "explicit") if node.get(w) == "yes"]
        return f"{template(node)}{' '.join([*words, plain(node.find('type'))])} {name}{arguments}".replace("  ", " ")
    if kind == "variable":
        value = plain(node.find("initializer"))
        shown = f" {value}" if len(value) < 60 and value.startswith("=") else ""
        return f"{template(node)}{plain(node.find('type'))} {name}{plain(node.find('argsstring'))}{shown}"
    if kind == "typedef":
        return f"{template(node)}{word}{name} = {plain(node.find('type'))}"
    return template(node) + word + name


def indented(lines, by="   "):
    return [by + line if line else "" for line in lines]


def entity(node, members=(), inside=False):
    """The directive of a declaration, with those of its public members."""
    body = description(node)
    for value in node.findall("enumvalue"):
        body += [f".. describe:: {value.findtext('name')}", "", *indented(description(value)), ""]
    for member in members:
        body += entity(member, inside=True)
    return [f".. describe:: {signature(node, inside).strip()}", "", *indented(body), ""]


def shown(node):
    name = node.findtext("name") or ""
    return (node.get("kind") in KINDS and node.get("prot") == "public" and not name.startswith(("~", "@", "POLHODE_"))
            and "<" not in name  # a specialization
            and not re.search(r"=\s*(default|delete)$", node.findtext("argsstring") or ""))


def line(node):
    return int(node.find("location").get("line"))


def declarations(xml):
    """{header: [(line, lines of text)]}."""
    found, seen = defaultdict(list), set()  # of variants for the preprocessor the first is shown
    for path in sorted(xml.glob("*.xml")):
        compound = ElementTree.parse(path).getroot().find("compounddef")
        if compound is None or compound.get("kind") not in ("namespace", "class", "struct", "concept"):
            continue
        members = [m for m in sorted(compound.iter("memberdef"), key=line)
                   if shown(m) and not (signature(m) in seen or seen.add(signature(m)))]
        if compound.get("kind") == "namespace":
            for member in members:
                found[member.find("location").get("file")].append((line(member), entity(member)))
        elif compound.get("prot") != "private" and "<" not in compound.findtext("compoundname"):
            found[compound.find("location").get("file")].append((line(compound), entity(compound, members)))
    return found


# Pages.

def opening(header):
    """The comment at the beginning of a header."""
    lines = header.read_text(encoding="utf-8").splitlines()[1:]
    count = next((i for i, text in enumerate(lines) if not text.startswith("//")), len(lines))
    return escaped("\n".join(text.lstrip("/ ") for text in lines[:count]))


def titled(text, mark):
    return [text, mark * len(text), ""]


def write(path, text):
    """Writes a file; one with this text keeps its date, so that Sphinx does not read it again."""
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main():
    xml, include, folder = map(Path, sys.argv[1:4])
    found = declarations(xml)
    folder.mkdir(parents=True, exist_ok=True)
    for source in sorted({header.parent for header in include.rglob("*.hpp")}):
        name = source.relative_to(include).as_posix()
        text = titled(name, "=")
        for header in sorted(source.glob("*.hpp")):
            text += titled(header.name, "-") + [opening(header), "", ".. code-block:: cpp", "",
                                                f"   #include \"{header.relative_to(include).as_posix()}\"", ""]
            for _, lines in sorted(found[header.relative_to(include).as_posix()]):
                text += lines
        write(folder / (name.replace("/", "-") + ".rst"), "\n".join(text))


if __name__ == "__main__":
    main()
