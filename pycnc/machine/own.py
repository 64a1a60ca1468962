# SPDX-License-Identifier: MIT
"""Codes of the machine's own: M codes, and G codes whose meaning its file says."""

import re
from decimal import Decimal
from typing import Literal

from pydantic import Field

from pycnc.kernel.bind import lib
from pycnc.machine.quantity import Size, Table

_G = re.compile(r"(0|[1-9]\d{0,2})(?:_([1-9]))?(?:_([pq])(0|[1-9]\d{0,8}))?")


class OwnM(Table):
    """An M code of the machine's own."""

    action: Literal["output", "wait"] = Field(
        description="`output`: the code is handed over and the path goes on. `wait`: the path "
        "rests, the code is handed over, and the program waits to be resumed."
    )
    stays: bool = Field(
        False, description="What it does stays, as a clamp's state does: a program that begins "
        "behind it (`--from-line`) does it on its way in."
    )


class OwnG(Table):
    """A G code that chooses a mode of the control's, or that the language does not have."""

    action: Literal["ignore", "note", "tolerance"] = Field(
        description="`ignore`: the code changes nothing. `note`: the same, and a note says so, "
        "once in a program. `tolerance`: the path stays within `tolerance_mm` from there on, where "
        "no G64 P says another one."
    )
    tolerance_mm: Size = Field(
        Decimal(0), description="Of `tolerance`: 0, which is exact path, or 0.0001 at least."
    )


def g_code(name):
    """Return (code in tenths, letter, value) of a table's name, such as ``5_1_q1``; or None."""
    if not (match := _G.fullmatch(name)):
        return None
    whole, tenths, letter, value = match.groups()
    return int(whole) * 10 + int(tenths or 0), (letter or "").upper(), int(value or 0)


def _is_number(name):
    return name.isdecimal() and name.isascii() and name == str(int(name))


def _problems_of_g(name, own):
    if g_code(name) is None:
        yield f"g.{name}", "a G code's name is its number, as in [g.187], [g.5_1], [g.5_1_q1]"
    if own.action != "tolerance" and own.tolerance_mm != 0:
        yield f"g.{name}.tolerance_mm", f'only action = "tolerance" has one (is {own.action!r})'
    if 0 < own.tolerance_mm < Decimal("0.0001"):
        yield f"g.{name}.tolerance_mm", "must be 0 (exact path) or 0.0001 at least"


def code_problems(machine):
    """Yield (path to key, message) of names that are no code's or no work system's."""
    for number in machine.m:
        if not _is_number(number):
            yield f"m.{number}", "an M code's name is its number, as in [m.428]"
    for name, own in machine.g.items():
        yield from _problems_of_g(name, own)
    for number in machine.work.p:
        if not (_is_number(number) and 1 <= int(number) <= lib.NCK_WORK_MOST):
            yield f"work.p.{number}", f"a system's name is P, 1 to {lib.NCK_WORK_MOST}: [work.p.7]"
    for key, many in (("g", machine.g), ("work.p", machine.work.p)):
        if len(many) > lib.NCK_OWN_M_MAX:
            yield key, f"{lib.NCK_OWN_M_MAX} at most (the table has {len(many)})"
