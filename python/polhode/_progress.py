# SPDX-License-Identifier: MIT
"""Progress of a job: a bar in terminals and notebooks, silence in pipes."""

import sys

from ._types import Messages, Progress

__all__ = ["hooks"]


def _in_notebook():
    """Whether this runs in a Jupyter kernel."""
    shell = sys.modules.get("IPython")
    return bool(shell and type(shell.get_ipython()).__name__ == "ZMQInteractiveShell")


class Bar:
    """A bar of tqdm if it is installed, or a line of text."""

    def __init__(self):
        self._bar, self._job, self._shown = None, "", False
        try:
            if _in_notebook():
                from tqdm.notebook import tqdm
            else:
                from tqdm import tqdm
            self._tqdm = tqdm
        except ImportError:
            self._tqdm = None

    def __call__(self, job, done, detail):
        if self._tqdm is None:
            percent = "" if done is None else f" {100 * done:3.0f} %"
            sys.stderr.write(f"\r{job}{percent} {detail[:40]:<40}")
            sys.stderr.flush()
            self._shown = True
            return
        if job != self._job:
            self.close()
            self._bar, self._job = self._tqdm(total=100, desc=job, leave=False), job
        self._bar.n = round(100 * (done or 0), 1)
        self._bar.set_postfix_str(detail)

    def close(self):
        if self._bar is not None:
            self._bar.close()
            self._bar = None
        if self._shown:
            sys.stderr.write("\r" + 60 * " " + "\r")
            self._shown = False


class hooks:
    """A context with `progress` and `message` for a job.

    Args:
        progress: None: a bar where someone watches; False: none; True: always a bar; or a function
            called with (job, fraction done or None, detail).
        messages: a function called with each line of text, such as print; None: lines are dropped.
    """

    def __init__(self, progress: Progress = None, messages: Messages = None) -> None:
        self.message, self._bar = messages, None
        if callable(progress):
            self.progress = progress
            return
        watched = _in_notebook() or (sys.stderr is not None and sys.stderr.isatty())
        if progress is True or (progress is None and watched):
            self._bar = Bar()
        self.progress = self._bar

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._bar is not None:
            self._bar.close()
