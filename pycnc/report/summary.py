# SPDX-License-Identifier: MIT
"""What a run tells a person on the terminal: one screen."""

from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from pycnc.planning.plan import BY
from pycnc.report import reasons, times
from pycnc.report.plot import duration

_SHOWN_LIMITS = 6
_BAR = 40  # characters
JERK_TOLD = 1e-6  # by how much a peak of jerk is above its limit before words are made of it
LIMIT_WORDS = {
    "feed": "the programmed feed",
    "rapid": "rapid speed",
    "corner": "a corner",
    "curvature": "the curvature of an arc",
    "chord": "the chord error on an arc",
    "accel": "acceleration and braking",
    "jerk": "jerk",
    "exact_stop": "a stop",
    "dwell": "a dwell",
    "wait": "a wait: M0, M1, M6 etc.",
    "lookahead": "the length of the look-ahead",
    "starved": "starvation: preparation was late",
    "feed_max": "the machine's highest feed",
    "spindle": "the spindle, which follows the surface speed",
    "thread": "threads: the spindle, and the wait for its angle",
    "mode": "a stop where smoothing begins or ends",
}


def limit_words(name):
    """Return a limit in words: ``axis_v:x`` is the top speed of X."""
    kind, _, axis = name.partition(":")
    return f"the top speed of {axis.upper()}" if axis else LIMIT_WORDS[kind]


def render(trace, files=()):
    """Return the summary of a run, to be printed by rich.

    Parameters
    ----------
    trace : Trace
    files : iterable of (str, str)
        What was written: what it is, and its path.
    """
    facts = trace.summary
    parts = [_head(trace), "", _times(trace), "", _limits(trace), "", _peaks(trace)]
    if facts["starved_ticks"]:
        parts += ["", Text(f"{facts['starved_ticks']:,} ticks waited for the path.", "yellow")]
    parts += ["", _diagnostics(trace.program.diagnostics), *_remarks(trace.program.diagnostics)]
    parts += [_whole_line(Text.assemble((f"{what}: ", "bold"), path)) for what, path in files]
    return Group(*parts)


def _head(trace):
    facts = trace.summary
    first = _whole_line(Text(times.head(trace.program, facts["total_s"]), "bold"))
    rate = facts["ticks"] / max(facts["run_s"], 1e-9)
    second = Text(
        f"{facts['blocks']:,} blocks, {_length(facts['length_mm'])} of path, "
        f"{facts['ticks']:,} ticks of {facts['period_s'] * 1e3:g} ms, "
        f"simulated in {facts['run_s']:.2f} s ({rate * facts['period_s']:,.0f} times real time)",
        "dim",
    )
    lines = [first, second]
    if trace.plan.kind != "exact":
        exact, by = duration(trace.plan.exact_time_s), BY[trace.plan.kind]
        lines.append(Text(f"planned {by} on {facts['backend']}; exactly: {exact}", "dim"))
    return Group(*lines)


def _whole_line(text):
    """Let a line with a path in it run on rather than break the path."""
    text.no_wrap, text.overflow = True, "ignore"
    return text


def _length(mm):
    return f"{mm / 1000:.2f} m" if mm >= 10_000 else f"{mm:.1f} mm"


def _table(*columns):
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold")
    for name, justify in columns:
        table.add_column(name, justify=justify)
    return table


def _times(trace):
    facts = {**trace.plan.totals, **trace.summary}  # what the run took, and what no axis makes
    table = _table(("Time", "left"), ("", "right"), ("", "left"))
    for name, word in times.KINDS.items():
        seconds = facts[f"{name}_s"]
        if seconds > 0:
            share = _bar(seconds / max(facts["total_s"], 1e-9))
            table.add_row(f"  {word}", duration(seconds), Text(share, "blue"))
    moving = " · ".join(f"{word} {time}" for word, time in times.told(facts, times.MOTIONS))
    return Group(table, *([Padding(Text(moving, "dim"), (0, 0, 0, 2))] if moving else []))


def _bar(share):
    return "█" * round(_BAR * min(share, 1)) or "▏"


def _limits(trace):
    """Return what holds the path: as ``why`` tells it, if the run was as planned."""
    if trace.as_planned:
        words = "\n".join(reasons.short(trace.plan.why()))
        return Text(words, no_wrap=True, overflow="ellipsis")
    columns = (("What set the speed", "left"), ("time", "right"), ("share", "right"),
               ("most at line", "left"))  # fmt: skip
    table = _table(*columns)
    times = trace.summary["limit_time_s"]
    ranked = sorted((name for name in times if times[name] > 0), key=lambda name: -times[name])
    for name in ranked[:_SHOWN_LIMITS]:
        lines = ", ".join(str(line) for line, _ in trace.worst_lines.get(name, []) if line)
        share = times[name] / max(trace.summary["time_s"], 1e-9)
        table.add_row(
            f"  {limit_words(name)}", duration(times[name]), f"{share:.1%}", Text(lines, "dim")
        )
    return table


def _ratios(peak, told, limited):
    """Return peaks of speed, acceleration and, where it is told, jerk; limited: the jerk is."""
    return [_ratio(peak[kind], told and (limited or kind != "j")) if kind in peak else ""
            for kind in ("vaj" if told else "va")]  # fmt: skip


def _peaks(trace):
    peaks, slope = trace.summary["peaks"], trace.summary["slope"]
    told = any("j" in peak for peak in peaks.values())
    columns = (("Peaks, of the limit", "left"), ("speed", "right"), ("acceleration", "right"),
               *([("jerk", "right")] if told else []))  # fmt: skip
    table = _table(*columns)
    for letter, peak in peaks.items():
        if letter != "path":
            table.add_row(f"  {letter.upper()}", *_ratios(peak, told, False))
        elif not told or slope != "optimal" or max(peak.values()) > 0:  # else: by the axes
            table.add_row(f"  {letter}", *_ratios(peak, told, slope != "linear"))
    error = f"largest distance of path and program: {trace.summary['path_error_mm']:.1e} mm"
    words = [error, *(_jerk_words(trace.summary) if told else _control_words(trace))]
    return Group(table, *(Padding(Text(each, "dim"), (0, 0, 0, 2)) for each in words))


def _control_words(trace):
    kind = trace.program.machine.settings.control.kind
    yield f"Along lines: {kind} limits no jerk, and passes corners with a step of speed."


def _jerk_words(facts):
    """Yield why an axis has more jerk than its limit, if one has."""
    if max(peak["j"] for peak in facts["peaks"].values()) <= 1 + JERK_TOLD:
        return
    if facts["slope"] == "linear":
        yield "The linear slope limits acceleration, not jerk: --set path.slope=jerk does."
    else:
        yield (
            "On an exact path (G61, or no tolerance) a corner crossed moving is a jump of speed: "
            "its jerk has no bound. G64 P0.01 bounds it."
        )


def _ratio(value, promised=True):
    """Return a peak in words: red if it breaks a promise, pale if none is given."""
    broken = "red" if value > 1 + 1e-6 else ""
    return Text(f"{value:.1%}", broken if promised else "dim")


def _remarks(found):
    """Yield what the program says to its operator."""
    for each in found:
        if each.id == "remark":
            yield _whole_line(Text(f"Line {each.line} {each.message}"))


def _diagnostics(found):
    if not len(found):
        return Text("No errors, nothing to note.", "green")
    counts = ", ".join(f"{name} ({n})" if n > 1 else name for name, n in found.counts.items())
    words = f"{found.errors} errors: " if found.errors else "No errors. Noted: "
    return Text(words + counts, "red" if found.errors else "green")
