# SPDX-License-Identifier: MIT
"""Progress of a job: a bar in terminals and notebooks, nothing in pipes."""

from __future__ import annotations

import sys

from ._types import Messages, Progress


def _in_notebook():
    """Whether Python runs in a Jupyter kernel."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell"


def _of_notebook(job):
    import ipywidgets  # noqa: F401: without it tqdm makes half a bar, which complains when it is deleted
    from tqdm.notebook import tqdm

    return tqdm(total=100, desc=job, leave=False)


def _of_text(job):
    from tqdm import tqdm

    return tqdm(total=100, desc=job, leave=False)


class _Line:
    """A line of text that replaces the bar if tqdm is not installed."""

    def __init__(self, job):
        self._job, self.n, self._shown = job, 0, False

    def set_postfix_str(self, detail):
        sys.stderr.write(f"\r{self._job} {self.n:3.0f} % {detail[:40]:<40}")
        sys.stderr.flush()
        self._shown = True

    def close(self):
        if self._shown:
            sys.stderr.write("\r" + 60 * " " + "\r")


class Bar:
    """A tqdm bar. In a notebook with ipywidgets it consists of widgets, otherwise of text. Without
    tqdm it is a line of text. A bar that fails must not stop a run, so it is replaced by the next kind,
    and finally by nothing."""

    def __init__(self):
        self._kinds = [*([_of_notebook] if _in_notebook() else []), _of_text, _Line]
        self._bar, self._job = None, None

    def __call__(self, job, done, detail):
        while self._kinds:
            try:
                self._show(job, done, detail)
                return
            except Exception:  # of any kind: ImportError without ipywidgets, ValueError of a closed stream
                self._bar, self._kinds = None, self._kinds[1:]

    def _show(self, job, done, detail):
        if self._bar is None or job != self._job:
            self.close()
            self._bar, self._job = self._kinds[0](job), job
        self._bar.n = round(100 * (done or 0), 1)
        self._bar.set_postfix_str(detail)

    def close(self):
        bar, self._bar = self._bar, None
        try:
            if bar is not None:
                bar.close()
        except Exception:  # as above
            pass


def _watched():
    """Whether a bar would be visible to a user."""
    try:
        return _in_notebook() or sys.stderr.isatty()
    except (AttributeError, ValueError):  # there is no stream, or it is closed
        return False


class hooks:
    """A context with `progress` and `message` for a job.

    Args:
        progress: None for a bar if a user can see it; False for none; True for a bar in any case; or a function
            called with (job, fraction done or None, detail).
        messages: a function called with each line of text, such as print; None: lines are dropped.
    """

    def __init__(self, progress: Progress = None, messages: Messages = None) -> None:
        self.message, self._bar = messages, None
        if callable(progress):
            self.progress = progress
            return
        if progress is True or (progress is None and _watched()):
            self._bar = Bar()
        self.progress = self._bar

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._bar is not None:
            self._bar.close()
