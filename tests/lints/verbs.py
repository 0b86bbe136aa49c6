# SPDX-License-Identifier: MIT
"""Each verb of the command line has its function in Python, and both call the same functions of the library: those of
run/ that the verb's file calls, but for those that only show results. The verbs are those of cli/verbs.cpp."""

import re

from tree import Finding, line_of, lines, main, without_comments

SHOWN = re.compile(r"\w+_(?:text|json|help)|text_of|json_text|row_of_files")
DECLARED = re.compile(r"^(?!class|struct|using|#|namespace|template|enum|\}|return)[A-Za-z_][^;{}()=\n]*?\b(\w+)\(|^class (\w+)", re.M)
DEFINED = re.compile(r"^(?:int|void|Action) (\w+)\(", re.M)
LISTED = re.compile(r"^__all__ \+?= (\[[^\]]*\])", re.M)


def text_of(paths):
    return "\n".join(text for path in paths for _, text in lines(path))


def calls(text, function):
    """Whether a function is called, or passed on, in some C++ text."""
    return re.search(rf"\b{function}\b\s*[(<,)]|\b{function} \w+\(", text) is not None


def python_names(root):
    """The public names of the package, and of its modules of which it has all."""
    package = root / "python/polhode"
    text = text_of([package / "__init__.py"] if package.exists() else [])
    modules = [package / f"{name}.py" for name in re.findall(r"^from \.(\w+) import \*", text, re.M)]
    listed = LISTED.findall("\n".join([text, text_of(modules)]))
    return {name for names in listed for name in re.findall(r'"(\w+)"', names)}


def verbs_of(path):
    """(verb, line) of each entry of the table of verbs."""
    if not path.exists():
        return
    text = text_of([path])
    for match in re.finditer(r'\{"([a-z-]+)",\s*"[^"]*",\s*\w+_verb\}', text):
        yield match[1], line_of(text, match.start())


def library(root):
    """The functions and classes that headers of run/ declare."""
    headers = [p for folder in ("include/polhode/run", "src/run") for p in sorted((root / folder).rglob("*.hpp"))]
    return {name for found in DECLARED.findall(text_of(headers)) for name in found if name}


def check(root):
    verbs, names, declared = root / "cli/verbs.cpp", python_names(root), library(root)
    python = text_of(sorted((root / "python/src").glob("*.[ch]pp")))
    sources = [without_comments(text_of([path])) for path in sorted((root / "cli/verbs").glob("*.cpp"))]
    for verb, number in verbs_of(verbs):
        name = verb.replace("-", "_")
        if name not in names:
            yield Finding(verbs, number, f"{verb} has no function polhode.{name}; add it")
        source = next((text for text in sources if f"Action {name}_verb(" in text), "")
        called = {f for f in declared - set(DEFINED.findall(source)) if calls(source, f)}
        if not called:
            yield Finding(verbs, number, f"{verb} calls no function of run/; verbs only read options and print")
        for function in sorted(f for f in called if not SHOWN.fullmatch(f) and not calls(python, f)):
            yield Finding(verbs, number, f"python/src does not call {function}() for {verb}; both front ends must")


if __name__ == "__main__":
    main(check, __doc__)
