# SPDX-License-Identifier: MIT
"""The exceptions of the package. Their texts are the same as on the command line."""

import re

__all__ = ["Error", "OutputError", "RunError"]


class Error(ValueError):
    """Invalid input, such as a value, a file or an option. The command line exits with code 2.

    Attributes:
        text (str): description of the error with value, unit and bound, and advice.
        where (str): file, line and key, as far as known, such as ``"water.toml:9, forces.cutoff"``.
    """

    def __init__(self, text: str, where: str = "") -> None:
        self.text = text
        self.where = re.sub(r"^(keywords|dict):\d+", r"\1", where)  # lines of a text nobody wrote
        super().__init__(f"{text}\n  in   {self.where}" if self.where else text)

    def __reduce__(self):
        return type(self), (self.text, self.where)


class OutputError(Error):
    """Outputs of an earlier job that can neither be overwritten nor resumed as they are.

    Attributes:
        resumable (bool): whether ``resume=True`` would resume the earlier job.
    """

    def __init__(self, text: str, where: str = "", resumable: bool = False) -> None:
        super().__init__(text, where)
        self.resumable = resumable
        remedy = "resume=True, which resumes, or " if resumable else ""
        self.args = (f"{self.args[0]}\n  try  {remedy}force=True, which starts over and overwrites the earlier output",)

    def __reduce__(self):
        return type(self), (self.text, self.where, self.resumable)


class RunError(RuntimeError):
    """A run cannot continue although the input was valid, for example because it blows up. The command
    line exits with code 1."""
