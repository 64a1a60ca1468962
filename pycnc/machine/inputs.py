# SPDX-License-Identifier: MIT
"""The switches of a machine that is served: where they are, and how it is homed."""

from decimal import Decimal
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field

from pycnc.machine.quantity import Coordinate, Number, SpeedPerMinute, Table, Travel, number
from pycnc.names import AXES

_ORDER_MOST = 8  # axes that one homing takes: a nibble each
_LOCATES = 5  # times pull_off must fit into the travel: the way of the slow approach
_NM = 1_000_000  # in a mm or degree

PullOff = Annotated[Number, Field(ge=Decimal("0.001"), le=1000), BeforeValidator(number)]
Milliseconds = Annotated[Number, Field(ge=0, le=1000), BeforeValidator(number)]


class AxisSwitch(Table):
    """The switches of one axis, in mm or degrees of the machine."""

    end: Literal["least", "most"] = Field(
        "most", description="End of the travel at which the home switch is: bit of grbl's $23."
    )
    at: Travel = Field(None, description="Where it closes. Default: that end of the travel.")
    limit: bool = Field(True, description="It is a limit switch, too.")
    far: Travel = Field(
        None, description="Where a limit switch at the other end closes. Default: there is none."
    )
    second: Travel = Field(
        None, description="Two motors drive the axis: where the home switch of the second one "
        "closes. Homing squares them. Default: one motor."
    )  # fmt: skip


class Inputs(Table):
    """What `pycnc serve` has for switches, and how it homes; a broken wire is a closed switch."""

    homing: bool = Field(
        True, description="There is `$H`, and the machine is locked until it is homed: $22."
    )
    limits: bool = Field(False, description="A limit switch stops the axes: $21.")
    order: str = Field(
        "", description="Axes in the order of homing, as `zxy`. Default: Z, then the others."
    )
    seek_mm_min: SpeedPerMinute = Field(
        Decimal(500), description="Fast approach; of a rotary axis degrees a minute: $25."
    )
    feed_mm_min: SpeedPerMinute = Field(Decimal(25), description="Slow approach: $24.")
    pull_off_mm: PullOff = Field(
        Decimal(1), description="How far off the switch homing ends (rotary: degrees): $27."
    )
    debounce_ms: Milliseconds = Field(
        Decimal(25), description="A switch has not changed for so long before it is open: $26."
    )
    bounce_ms: Milliseconds = Field(
        Decimal(0), description="A switch that changes reads at random for so long."
    )
    skew_mm: PullOff = Field(
        Decimal(5), description="How far one of two motors may go on alone while homing."
    )
    plate_mm: Coordinate | None = Field(
        None, description="The probe touches at this Z and below. Default: nowhere."
    )
    door: Literal["open", "closed"] = Field(
        "closed", description="The door, when the machine is switched on."
    )
    emergency: Literal["pushed", "released"] = Field(
        "released", description="The emergency stop, when the machine is switched on."
    )
    ports: list[Annotated[int, Field(ge=0, le=7)]] = Field(
        [], description="Ports of M66 that read 1, of 0 to 7, when the machine is switched on."
    )
    x: AxisSwitch | None = Field(None, description="Switches of X.")
    y: AxisSwitch | None = Field(None, description="Switches of Y.")
    z: AxisSwitch | None = Field(None, description="Switches of Z.")
    a: AxisSwitch | None = Field(None, description="Switches of A.")
    b: AxisSwitch | None = Field(None, description="Switches of B.")
    c: AxisSwitch | None = Field(None, description="Switches of C.")
    u: AxisSwitch | None = Field(None, description="Switches of U.")
    v: AxisSwitch | None = Field(None, description="Switches of V.")
    w: AxisSwitch | None = Field(None, description="Switches of W.")

    def present(self):
        """Return the axes that have switches, letter → table, in the kernel's order."""
        return {at: getattr(self, at) for at in AXES if getattr(self, at) is not None}

    def homed(self):
        """Return the letters of the axes in the order of homing."""
        letters = self.present()
        return self.order or "".join(sorted(letters, key=lambda at: (at != "z", at not in "xyz")))


def _travel(axis):
    """Return the ends of an axis' travel, None where it is free."""
    ends = [name for name in ("min_mm", "min_deg", "max_mm", "max_deg") if hasattr(axis, name)]
    return [getattr(axis, name) for name in ends]


def contradictions(inputs, axes):
    """Yield (path to key, message) for switches of axes that are not there, and orders of them."""
    if inputs is None:
        return
    letters = inputs.present()
    yield from _switch_contradictions(letters, axes)
    if inputs.plate_mm is not None and "z" not in axes:
        yield "inputs.plate_mm", "the machine has no Z axis"
    bad = [at for at in inputs.order if at not in letters or inputs.order.count(at) > 1]
    if bad:
        yield "inputs.order", (f"must be letters of axes with an [inputs] table, each once "
                               f"(is {inputs.order!r})")  # fmt: skip
    elif len(inputs.homed()) > _ORDER_MOST:
        yield "inputs.order", f"{_ORDER_MOST} axes at most"
    elif inputs.homing:
        yield from _homing_contradictions(inputs, axes)


def _switch_contradictions(letters, axes):
    for letter, switch in letters.items():
        if letter not in axes:
            yield f"inputs.{letter}", f"the machine has no {letter.upper()} axis"
            continue
        yield from _axis_contradictions(letter, switch, axes[letter])
    pairs = [at for at, switch in letters.items() if switch.second is not None]
    if len(pairs) > 1:
        yield f"inputs.{pairs[1]}.second", f"{pairs[0].upper()} has two motors, and one axis can"


def _axis_contradictions(letter, switch, axis):
    least, most = _travel(axis)
    end = least if switch.end == "least" else most
    if switch.at is None and end is None:
        yield f"inputs.{letter}.at", f"must be there, for the travel of {letter.upper()} is free"
        return
    at = end if switch.at is None else switch.at
    if switch.far is not None and (switch.far <= at) != (switch.end == "most"):
        side = "below" if switch.end == "most" else "above"
        yield f"inputs.{letter}.far", f"must be {side} the home switch at {at} (is {switch.far})"


def _homing_contradictions(inputs, axes):
    if not inputs.present():
        yield "inputs.homing", "no axis has a switch: add [inputs.x], or homing = false"
    for letter in inputs.homed():
        least, most = _travel(axes[letter]) if letter in axes else (0, 2**31)
        if least is None or most is None:
            yield f"inputs.{letter}", f"homing needs the travel of {letter.upper()}, which is free"
        elif most - least < _LOCATES * inputs.pull_off_mm:
            yield "inputs.pull_off_mm", (f"{_LOCATES} times it must fit into the travel of "
                                         f"{letter.upper()} (is {inputs.pull_off_mm})")  # fmt: skip


def _nm(value):
    return int(value * _NM)


def _bits(letters):
    return sum(1 << AXES.index(at) for at in letters)


def _places(letters, axes):
    """Return where the home switches and those at the far ends are, in nm by axis; 0: none."""
    place, far = [0] * len(AXES), [0] * len(AXES)
    for at, switch in letters.items():
        end = _travel(axes[at])[switch.end == "most"]
        place[AXES.index(at)] = _nm(end if switch.at is None else switch.at)
        far[AXES.index(at)] = _nm(switch.far or 0)
    return place, far


def _least(letters):
    return _bits(at for at, switch in letters.items() if switch.end == "least")


def _pair(letters):
    """Return the axis of two motors, each with a switch; None without one."""
    return next((at for at, switch in letters.items() if switch.second is not None), None)


def _wires(settings):
    """Return where the simulated machine has its switches."""
    inputs, axes, period = settings.inputs, settings.axis.present(), settings.kernel.period_ms
    letters, pair = inputs.present(), _pair(inputs.present())
    place, far = _places(letters, axes)
    wires = {
        "wired": _bits(letters), "least": _least(letters), "place_nm": place,
        "homes_only": _bits(at for at, switch in letters.items() if not switch.limit),
        "far": _bits(at for at, switch in letters.items() if switch.far is not None),
        "far_nm": far, "bounce": round(inputs.bounce_ms / period),
        "rpm_tick": float(settings.spindle.a_max_rpm_s * period / 1000),
    }  # fmt: skip
    if pair:
        wires |= {"pair": AXES.index(pair) + 1, "second_nm": _nm(letters[pair].second)}
    if inputs.plate_mm is not None:
        wires["plate_nm"] = _nm(inputs.plate_mm)
    return wires


def switches_of(settings):
    """Return what ``Session.connect`` and ``Session.push`` take; None without [inputs]."""
    inputs = settings.inputs
    if inputs is None:
        return None
    letters = inputs.present()
    least = _least(letters)
    period = settings.kernel.period_ms
    pair = _pair(letters)
    order = sum(AXES.index(at) + 1 << 4 * k for k, at in enumerate(inputs.homed()))
    said = {
        "homes": int(inputs.homing), "limits": int(inputs.limits), "reverse": least,
        "order": order, "seek": float(inputs.seek_mm_min), "feed": float(inputs.feed_mm_min),
        "pull_off": float(inputs.pull_off_mm),
        "debounce": round(inputs.debounce_ms / period),
        "pair": AXES.index(pair) + 1 if pair else 0, "skew": float(inputs.skew_mm),
    }  # fmt: skip
    pushed = {"door": inputs.door == "open", "emergency": inputs.emergency == "pushed"}
    pushed |= {f"port{k}": True for k in inputs.ports}
    return said, _wires(settings), pushed
