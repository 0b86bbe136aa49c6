# SPDX-License-Identifier: MIT
"""Functions have at most 60 lines, and at most two lambdas are within each other."""

import re

from tree import Finding, files, line_of, main, without_comments

MAX_LINES = 60
MAX_LAMBDAS = 2  # one within the other
FOLDERS = ("include", "src", "cli", "python", "lammps", "tests", "bench", "studies", "examples")
LITERAL = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|__attribute__\(\(\w+\)\)'
                     r"|\[\[.*?\]\]|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
SCOPE = re.compile(r"\b(namespace|struct|class|union|enum|extern|concept)\b")
LAMBDA = re.compile(r"(?<![\w)\]])\s*\[[^\[\]]*\]\s*(?:<[^{}]*>\s*)?(?:\([^{}]*\))?\s*(?:mutable|noexcept|->[^{}]*)?\s*$")


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def bodies(text):
    """(begin, end, depth of lambdas) of each function and each lambda, in the order of their ends."""
    stack = []  # of each open brace: what it opens, where that begins, and the open brackets around it
    head = brackets = last = 0  # where the statement and the last closed body begin
    for found in re.finditer(r"[{}();]", text):
        symbol, at = found[0], found.start()
        if symbol in "()":
            brackets += 1 if symbol == "(" else -1
        elif symbol == "{":
            statement = text[head:at]
            kind = kind_of(statement, [kind for kind, *_ in stack])
            begin = last if kind == "continued" else at - len(statement.lstrip())
            stack.append((kind, begin, brackets))
            head, brackets = at + 1, 0
        elif symbol == "}" and stack:
            kind, last, brackets = stack.pop()
            if kind in ("function", "continued", "lambda"):
                yield last, at, [kind for kind, *_ in stack].count("lambda") + (kind == "lambda")
            head = at + 1
        elif symbol == ";" and brackets == 0:
            head = at + 1


def kind_of(statement, around):
    """What the brace after `statement` opens, within those `around` it."""
    if LAMBDA.search(statement):
        return "lambda"
    if any(kind != "scope" for kind in around):
        return "block"
    if not statement.strip() or statement.lstrip().startswith((",", ")")):
        return "continued"  # after braces in parameters or initializers
    if SCOPE.search(re.sub(r"<[^<>]*>", "", statement)) and not statement.rstrip().endswith(")"):
        return "scope"
    return "function" if "(" in statement and not statement.rstrip().endswith("=") else "other"


def check(root):
    for path in files(root, (".hpp", ".cpp"), FOLDERS):
        text = LITERAL.sub(blank, without_comments(path.read_text(encoding="utf-8")))
        for begin, end, depth in bodies(text):
            line, size = line_of(text, begin), line_of(text, end) - line_of(text, begin) + 1
            if size > MAX_LINES:
                yield Finding(path, line, f"a function of {size} lines; split it, {MAX_LINES} are allowed")
            if depth > MAX_LAMBDAS:
                yield Finding(path, line, f"a lambda within {depth - 1} others; name it, or the one around it")


if __name__ == "__main__":
    main(check, __doc__)
