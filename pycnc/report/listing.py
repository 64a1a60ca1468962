# SPDX-License-Identifier: MIT
"""Listings: the decoded motions of a program, and the settings of a machine."""

import json
from decimal import Decimal

from pycnc.machine.schema import AXES, LINEAR_AXES
from pycnc.kernel.records import enum

_KINDS = {int(kind): kind.name.lower() for kind in enum("nck_block_kind_t")}
_OUTPUTS = enum("nck_output_kind_t")
_FEED_UNITS = {"mm": ("mm/min", "1/min", "mm/rev"), "inch": ("in/min", "1/min", "in/rev")}
_CENTRE_AXES = {17: "XY", 18: "ZX", 19: "YZ"}
_CHUNK = 16384


def motions(program, units="mm"):
    """Yield every decoded block as a dict: what is moved where, machine coordinates.

    Parameters
    ----------
    program : Program
        With its blocks.
    units : {"mm", "inch"}
        Of linear axes, centres and feeds. Rotary axes are in degrees.

    Yields
    ------
    dict
        line, kind, and as the kind needs: axes (letter → exact decimal text of the tool tip's
        target), plane, centre, sweep_deg, feed, feed_unit, seconds, output.
    """
    letters = program.machine.axes
    for begin in range(0, len(program.blocks), _CHUNK):
        for block in program.blocks[begin : begin + _CHUNK]:
            yield _motion(block, letters, units)


def _motion(block, letters, units):
    kind = _KINDS[int(block["kind"])]
    motion = {"line": int(block["line"]), "kind": kind}
    if kind in ("rapid", "line", "arc", "thread", "tap"):
        target = block["target_nm"]
        motion["axes"] = {a.upper(): _decimal(target[AXES.index(a)], a, units) for a in letters}
    if kind == "arc":
        scale = 25.4 if units == "inch" else 1.0
        motion["plane"] = int(block["plane"])
        motion["centre"] = [float(c) / scale for c in block["centre_mm"]]
        motion["sweep_deg"] = float(block["sweep_rad"]) * 180 / 3.141592653589793
    if kind in ("line", "arc"):
        mode = int(block["feed_mode"])
        per_inch = 25.4 if units == "inch" and mode != 1 else 1.0
        motion["feed"] = float(block["feed"]) / per_inch
        motion["feed_unit"] = _FEED_UNITS[units][mode]
    return motion | _beside_path(block, kind)


def _beside_path(block, kind):
    """Return what a block says that is not its path: of a spindle's turns, a rest, an output."""
    if kind == "thread":
        thread = block["thread"]
        return {"lead_mm": float(thread["lead"]), "turn": float(thread["turn"])}
    if kind == "tap":
        tap = block["tap"]
        return {"lead_mm": float(tap["lead"]), "way_mm": [float(x) for x in tap["way"]]}
    if kind == "dwell":
        return {"seconds": float(block["dwell_s"])}
    return {"output": _output(block["output"])} if kind in ("output", "wait", "end") else {}


def _decimal(nm, letter, units):
    """Return a coordinate as decimal text: exact in mm and degrees, 10 decimals in inches."""
    value = int(nm)
    if units == "inch" and letter in LINEAR_AXES:
        return f"{Decimal(value) / Decimal(25_400_000):.10f}"
    digits = 6 if letter in LINEAR_AXES else 9
    whole, part = divmod(abs(value), 10**digits)
    return f"{'-' if value < 0 else ''}{whole}.{part:0{digits}d}"


def _output(output):
    kind, value = int(output["kind"]), float(output["value"])
    letter = {_OUTPUTS.SPINDLE_SPEED: "S", _OUTPUTS.M: "M", _OUTPUTS.TOOL: "T",
              _OUTPUTS.SURFACE_SPEED: "G96 S"}.get(kind)
    if letter:
        return f"{letter}{value:g}"
    name = {_OUTPUTS.SETTING: "M{} S", _OUTPUTS.DIGITAL: "port {} = ",
            _OUTPUTS.ANALOGUE: "analogue port {} = ", _OUTPUTS.INPUT: "input {} within "}[kind]
    return f"{name.format(int(output['number']))}{value:g}"


def lines(program, units="mm"):
    """Yield the motions as text, one a line."""
    for motion in motions(program, units):
        words = [str(motion["line"]), motion["kind"]]
        words += [f"{letter}{value}" for letter, value in motion.get("axes", {}).items()]
        if "centre" in motion:
            pair = _CENTRE_AXES[motion["plane"]]
            centre = " ".join(f"{a}{c!r}" for a, c in zip(pair, motion["centre"], strict=True))
            words += [f"G{motion['plane']}", f"centre {centre} sweep {motion['sweep_deg']!r} deg"]
        if "feed" in motion:
            words.append(f"F{motion['feed']:g} {motion['feed_unit']}")
        if "lead_mm" in motion:
            lead = f"lead {motion['lead_mm']:g} mm"
            way = " ".join(f"{way:g}" for way in motion.get("way_mm", ()))
            turn = f"{360 * motion.get('turn', 0):g} deg"
            words.append(f"{lead} along {way}" if way else f"{lead} at {turn}")
        if "seconds" in motion:
            words.append(f"{motion['seconds']:g} s")
        if "output" in motion:
            words.append(motion["output"])
        yield " ".join(words)


def json_lines(program, units="mm"):
    """Yield the motions as JSON, one object a line."""
    for motion in motions(program, units):
        yield json.dumps(motion)


def _plain(value):
    """Return a setting as JSON has it."""
    if isinstance(value, Decimal):
        return int(value) if value == value.to_integral_value() else float(value)
    return "free" if value is None else value


def settings_dict(machine):
    """Return path to key → {"value", "source"} of every setting."""
    return {
        key: {"value": _derived(key, value), "source": source}
        for key, value, source in machine.effective()
    }


def _derived(key, value):
    """Return a setting for reading; a limit that is left to the axes is said so."""
    if value is None and not key.endswith(("min_mm", "max_mm", "min_deg", "max_deg")):
        return "v_max" if ".rapid_" in key else "axes"
    return _plain(value)


def settings_toml(machine, defaults):
    """Yield the settings as TOML lines, each with its source; defaults: also those left alone."""
    table = None
    for key, value, source in machine.effective():
        if source == "default" and not defaults:
            continue
        folder, _, leaf = key.rpartition(".")
        if folder != table:
            table = folder
            yield from ([f"\n[{folder}]"] if folder else [])
        shown = _derived(key, value)
        text = f"{leaf} = {json.dumps(shown, ensure_ascii=False)}"
        if value is None and shown != "free":  # TOML has no word for it: what applies is a comment
            text = f"# {leaf}: as {'v_max' if shown == 'v_max' else 'the axes give'}"
        yield f"{text:40}  # {source}"
