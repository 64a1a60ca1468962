# SPDX-License-Identifier: MIT
"""What ``--json`` tells, as pydantic models: the page json.md is made of them, tests hold them.

Times are in s. Keys that are told may become more; those that are here stay.
"""

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field


def _is(words, **more):
    return Field(description=words, **more)


class Model(BaseModel):
    """Nothing is told that stands not here."""

    model_config = ConfigDict(extra="forbid", strict=True)


class Diagnostic(Model):
    """A finding in a program or a file."""

    file: str = _is("as it was given; `<stdin>` for `-`")
    line: int = _is("from 1; 0: of the whole file", ge=0)
    col: int = _is("byte in the line, from 1; 0: of the whole line", ge=0)
    id: str = _is("stable: see [diagnostics](diagnostics.md)")
    severity: Literal["error", "warning", "note"] = _is("an error ends a program before it moves")
    message: str = _is("one sentence")
    help: str = _is("the remedy; may be empty")


class Program(Model):
    """What is told of every program; alone, of one that has an error."""

    file: str = _is("as it was given; `<stdin>` for `-`")
    machine: str = _is("name of the machine")
    version: str = _is("of pycnc")
    schema_version: int = _is("of these tables: another one where a key's meaning has changed")
    diagnostics: list[Diagnostic] = _is("in the order of the lines")


class Part(Model):
    """A tool, a section or a line of `time --by`; the longest first."""

    name: str = _is("`T1`, the words of the comment, or the line")
    line: int = _is("first source line of it")
    cut_s: float = _is("cutting")
    rapid_s: float = _is("rapids")
    dwell_s: float = _is("dwells and waits")
    tool_change_s: float = _is("tool changes, as the machine has them in `[times]`")
    spindle_s: float = _is("spindle starts, likewise")
    time_s: float = _is("all of these")


class Time(Program):
    """`pycnc time --json`: an object, or a list of them for several files."""

    period_s: float = _is("interpolation period")
    time_s: float = _is("that of the axes and of dwells, to the tick")
    total_s: float = _is("`time_s`, tool changes and spindle starts")
    cut_s: float = _is("cutting")
    rapid_s: float = _is("rapids")
    dwell_s: float = _is("dwells and waits")
    accelerate_s: float = _is("of cuts and rapids: speeding up")
    cruise_s: float = _is("steady")
    decelerate_s: float = _is("braking")
    tool_change_s: float = _is("tool changes")
    spindle_s: float = _is("spindle starts")
    tool_changes: int = _is("how many")
    spindle_starts: int = _is("how many")
    blocks: int = _is("decoded blocks")
    segments: int = _is("pieces of path")
    length_mm: float = _is("of the programmed path; a degree counts as a millimetre")
    limit_time_s: dict[str, float] = _is("limit → how long it held the path; adds up to `time_s`")
    slope: Literal["jerk", "optimal", "linear"] = _is("velocity profile")
    control: Literal["nck", "klipper", "grbl", "grblhal", "fluidnc", "marlin", "linuxcnc"] = _is(
        "whose rules it is planned by; `nck`: this kernel's"
    )
    plan: Literal["exact", "grades", "sshape"] = _is("how speed was planned")
    backend: str = _is("where it was planned")
    plan_s: float = _is("wall time that planning took")
    parts: list[Part] | None = _is("of `--by`; else the key is absent", default=None)


class Peak(Model):
    """Largest values over their limits: 1 is at the limit. Where another control plans, of its own
    limits: of jerk there is none."""

    v: float | None = _is("speed; the path has none", default=None)
    a: float | None = _is("acceleration", default=None)
    j: float | None = _is("jerk", default=None)


class Run(Time):
    """`pycnc run --json`: what `time` tells, of the ticks of the simulation."""

    ticks: int = _is("interpolation periods")
    run_s: float = _is("wall time of all")
    peaks: dict[str, Peak] = _is("axis, or `path` → largest values over their limits")
    path_error_mm: float = _is("largest distance of run and program, both ways")
    starved_ticks: int = _is("ticks in which preparation was late")
    end: str = _is("`done`, `hold`, `single_block`, `override` or `aborted`")


class Place(Model):
    """Lines one behind the other that lose time to the same cause."""

    line_first: int = _is("first source line")
    line_last: int = _is("last source line")
    line_worst: int = _is("with the low point that loses most")
    count: int = _is("low points")
    lost_s: float = _is("at all of them")
    worst_s: float = _is("at the worst one")
    axis: str | None = _is("that holds it there; null: no single one")
    angle_deg: float | None = _is("of a corner; else null")
    text: str = _is("the worst line")


class Cause(Model):
    """What time is lost to."""

    cause: str = _is("a name of `limit_time_s`, or `ends`")
    words: str = _is("for people")
    lost_s: float = _is("over the programmed feed")
    share: float = _is("of `time_s`")
    count: int = _is("low points")
    axis: str | None = _is("that holds most of them; null: no single one")
    axis_s: dict[str, float] = _is("axis → lost where it holds")
    angle_deg: list[float] | None = _is("least and most of corners; else null")
    places: list[Place] = _is("the worst ones, worst first")


class Ideal(Model):
    """The time without losses."""

    cut_s: float = _is("cuts at the programmed feed")
    rapid_s: float = _is("rapids at their speed")
    dwell_s: float = _is("dwells and waits")


class SlowFeed(Model):
    """A programmed feed far below the rest, which part of the ideal time goes to."""

    feed_mm_min: float = _is("as it is programmed, of the tool along its path")
    time_s: float = _is("at it")
    over_s: float = _is("of that over the time at the mean feed of the rest")
    length_mm: float = _is("cut at it")
    moves: int = _is("cut at it")
    line_first: int = _is("first source line")
    line_last: int = _is("last source line")


class Cure(Model):
    """A plan with one thing changed."""

    cure: str = _is("what was changed, in words or as `--what-if KEY=VALUE` asks for it")
    time_s: float = _is("of that plan")
    total_s: float = _is("the same with tool changes and spindle starts")
    gain_s: float = _is("how much sooner it ends; negative: later")


class Why(Program):
    """`pycnc why --json`: `ideal_s` and the `lost_s` of all causes add up to `time_s`."""

    period_s: float = _is("interpolation period")
    slope: Literal["jerk", "optimal", "linear"] = _is("velocity profile")
    control: Literal["nck", "klipper", "grbl", "grblhal", "fluidnc", "marlin", "linuxcnc"] = _is(
        "whose rules it is planned by; `nck`: this kernel's"
    )
    time_s: float = _is("as `time` tells it")
    total_s: float = _is("as `time` tells it")
    tool_change_s: float = _is("tool changes")
    spindle_s: float = _is("spindle starts")
    limit_time_s: dict[str, float] = _is("as `time` tells it")
    ideal_s: float = _is("ideal time: if only feeds, rapids and dwells held it back")
    ideal: Ideal = _is("what that is made of")
    slow_feeds: list[SlowFeed] = _is("the dearest first")
    causes: list[Cause] = _is("the worst first")
    what_if: list[Cure] = _is("with `--what-if`, the best first; else empty")


class Report(Why):
    """`pycnc report --json`: what `why` tells, and the page."""

    report: str = _is("the file that was written")


class Sweep(Model):
    """`pycnc sweep --json`."""

    machine: str = _is("name of the machine")
    settings: dict[str, list[str]] = _is("setting → values")
    rows: list[dict[str, str | float | None]] = _is(
        "a plan each, the last setting changing first: `file`, the settings, `time_s`, `total_s`, "
        "`cut_s`, `rapid_s`, `dwell_s` and `error`: null, or why there are no times"
    )


class LineDifference(Model):
    """A source line of two runs."""

    line: int = _is("source line")
    time_a_s: float = _is("in A")
    time_b_s: float = _is("in B")
    difference_s: float = _is("B less A")


class Compare(Model):
    """`pycnc compare --json`."""

    a: str = _is("what A is")
    b: str = _is("what B is")
    axes: str = _is("that both have")
    time_a_s: float = _is("from the first sample to the last")
    time_b_s: float = _is("likewise")
    time_difference_s: float = _is("B less A")
    distance_mm: float = _is("largest distance of B from the path of A")
    distance_mean_mm: float = _is("mean distance")
    distance_line: int | None = _is("where it is largest; null: the run has no lines")
    distance_t_s: float = _is("when, in B")
    clock_shift_s: float = _is("by how much B is later than A")
    clock_rate: float = _is("B's time over A's")
    clock_residual_s: float = _is("what these two do not explain")
    notes: list[str] = _is("what makes one doubt the rest: a gap in a log, other units")
    lines: list[LineDifference] = _is("if both have lines; those that differ most first")


MODELS = {
    "time": Time, "run": Run, "why": Why, "report": Report, "sweep": Sweep, "compare": Compare,
}  # fmt: skip
SHARED = (
    Program, Diagnostic, Part, Peak, Ideal, SlowFeed, Cause, Place, Cure, LineDifference,
)  # fmt: skip
