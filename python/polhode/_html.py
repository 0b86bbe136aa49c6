# SPDX-License-Identifier: MIT
"""HTML for notebooks: small tables that suit light and dark backgrounds."""

from html import escape

import numpy as np

from . import _core

_STYLE = "style='text-align:left;padding:0.15em 0.8em 0.15em 0'"


def number(x):
    """A number with five digits; other values are unchanged."""
    if isinstance(x, bool) or x is None:
        return {True: "yes", False: "no", None: "–"}[x]
    if isinstance(x, float):
        return f"{x:.5g}"
    return str(x)


def table(rows, head=None, caption="", meanings=None):
    """An HTML table in which all texts are escaped. Meanings of rows are tooltips."""
    def line(cells, tag, meaning=""):
        title = f" title='{escape(meaning)}'" if meaning else ""
        return "<tr>" + "".join(f"<{tag} {_STYLE}{title}>{escape(number(c))}</{tag}>" for c in cells) + "</tr>"

    top = f"<caption style='text-align:left;font-weight:bold'>{escape(caption)}</caption>" \
        if caption else ""
    heading = f"<thead>{line(head, 'th')}</thead>" if head else ""
    body = "".join(line(r, "td", m) for r, m in zip(rows, meanings or [""] * len(rows)))
    return f"<table style='margin:0 0 0.6em'>{top}{heading}<tbody>{body}</tbody></table>"


def report_html(report):
    """A report: the rows that the command line prints, with meanings as tooltips."""
    plain = [row for row in report.rows if not row["table"]]
    parts = [table([("\u2003" * row["level"] + row["label"], row["text"]) for row in plain],
                   caption=report.job, meanings=[row["meaning"] for row in plain])]
    parts += [table(row["table"][1:], row["table"][0], row["label"])
              for row in report.rows if row["table"]]
    return "".join(parts)


def scheme_html(scheme):
    """A scheme with its stages."""
    head = table([("order", scheme.order or "unknown"), ("force evaluations per step",
                  scheme.force_evaluations), ("cost", scheme.cost),
                  ("palindrome", scheme.palindrome), ("source", scheme.source),
                  ("as text", scheme.text)], caption=scheme.name)
    stages = [(s["flow"], s["fraction"], s["xi"], s["gradient"]) for s in scheme.stages]
    return head + table(stages, ("flow", "fraction of the step", "xi", "gradient"))


def molecule_html(m):
    """A molecule with its sites."""
    head = table([("description", m.description), ("mass [u]", m.mass),
                  ("moments [u nm²]", ", ".join(f"{x:.5g}" for x in m.moments)), ("top", m.top),
                  ("charge [e]", m.charge), ("dipole [D]", m.dipole), ("source", m.source)],
                 caption=m.name)
    sites = [(s["name"], *s["position"], s["mass"], s["charge"], s["sigma"], s["epsilon"])
             for s in m.sites]
    return head + table(sites, ("site", "x [nm]", "y [nm]", "z [nm]", "mass [u]", "charge [e]",
                                "sigma [nm]", "epsilon [kJ/mol]"))


def simulation_html(s):
    """A simulation: the system, and the progress of the run."""
    names = ", ".join(f"{n} {name}" for name, n in s.molecules)
    integrator = s.settings.tables.get("integrator") or {}
    box = " × ".join(f"{x:.4g}" for x in s.state.box)
    return table([("molecules", names), ("box [nm]", box),
                  ("scheme", integrator.get("scheme", "hoa2")), ("step", integrator.get("step")),
                  ("steps done", s.steps), ("time [ps]", s.time)], caption="Simulation")


def _fluctuation(values):
    """The rms fluctuation with three digits; 0 if it is only round-off."""
    rms = values.std()
    return "0" if rms <= 1e-14 * np.abs(values).max() * len(values)**0.5 else f"{float(f'{rms:.3g}'):g}"


def _error(values):
    """The standard error of the mean with two digits, or the reason why it is not known."""
    _, error, reason = _core.series_mean(values.tolist())
    return reason if error is None else f"{float(f'{error:.2g}'):g}"


def run_html(run):
    """A run: the mean energies of its samples with errors, and R."""
    e = run.energies
    if not len(e):
        return table([], caption="Run without samples")
    units = e.units()
    shown = [name for name in e.names() if name != "time" and (name != "external" or e[name].any())
             and (name != "conserved" or e.conserves)]
    rows = [(name.replace("_", " "), f"{e[name].mean():.6g}", _error(e[name]), _fluctuation(e[name]),
             units[name].replace("nm3", "nm³")) for name in shown]
    ratio = f", R = {100 * e.ratio:.3g} %" if len(e) >= 3 and e.conserves else ""
    caption = f"{len(e)} samples, {e['time'][0]:g} to {e['time'][-1]:g} ps{ratio}"
    return table(rows, ("", "mean", "± standard error", "fluctuation", "unit"), caption)
