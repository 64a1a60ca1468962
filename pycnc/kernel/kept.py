# SPDX-License-Identifier: MIT
"""What of a session outlives it: settings as a machine file has them, and where it stands."""

from decimal import Decimal

from pycnc.kernel.bind import check, ffi, lib
from pycnc.names import AXES, ROTARY_AXES, WORK_SYSTEMS

_NM = Decimal(1_000_000)
_PLACE_MOST, _COUNT_MOST = 2**63 - 1, 2**32 - 1  # of int64_t, uint32_t


def modal_of(nck):
    """Return the kernel's modal state: ``nck_modal_t *``."""
    modal = ffi.new("nck_modal_t *")
    lib.nck_modal(nck, modal)
    return modal


def present(nck):
    """Return (index, letter, unit) of every axis that the machine has."""
    axes = lib.nck_machine_of(nck).axis
    return [(k, at, "deg" if at in ROTARY_AXES else "mm")
            for k, at in enumerate(AXES[: lib.NCK_AXIS_MAX]) if axes[k].present]  # fmt: skip


def _real(value):
    return Decimal(f"{value:.9g}")


def settings(nck, inputs, has_inputs):
    """Return path to key of a machine file → Decimal, bool or str, of all that can be changed."""
    machine, modal, found = lib.nck_machine_of(nck), modal_of(nck), {}
    for k, at, unit in present(nck):
        axis = machine.axis[k]
        for name, value, power in (("v_max", axis.v_max, ""), ("rapid", axis.rapid, ""),
                                   ("a_max", axis.a_max, "2")):  # fmt: skip
            found[f"axis.{at}.{name}_{unit}_s{power}"] = _real(value)
        places = [(f"work.{name}", modal.systems_nm[row]) for row, name in enumerate(WORK_SYSTEMS)]
        places += [(f"home.{name}", modal.home_nm[row]) for row, name in enumerate(("g28", "g30"))]
        found |= {f"{table}.{at}_{unit}": place[k] / _NM for table, place in places}
    if has_inputs:
        found |= _inputs(inputs, machine.period_s)
    return found


def _inputs(inputs, period_s):
    homed = [at for k, at in enumerate(AXES) if _is_homed(inputs.order, k)]
    ends = {f"inputs.{at}.end": "least" if inputs.reverse >> AXES.index(at) & 1 else "most"
            for at in homed}  # fmt: skip
    return ends | {
        "inputs.homing": inputs.homes != 0, "inputs.limits": inputs.limits != 0,
        "inputs.seek_mm_min": _real(inputs.seek), "inputs.feed_mm_min": _real(inputs.feed),
        "inputs.pull_off_mm": _real(inputs.pull_off),
        "inputs.debounce_ms": _real(inputs.debounce * period_s * 1e3),
    }  # fmt: skip


def _is_homed(order, axis):
    return any(order >> shift & 15 == axis + 1 for shift in range(0, 32, 4))


def record(nck, host):
    """Return what a power failure must not lose, as numbers and texts."""
    modal = modal_of(nck)
    at = {lib.nck_joint_axis(nck, k): host.axes.joint_nm[k]
          for k in range(lib.nck_joint_count(nck))}  # fmt: skip
    axes = [k for k, _, _ in present(nck)]
    return {
        "position_nm": {AXES[k]: at[k] for k in axes},
        "g92_nm": {AXES[k]: modal.g92_nm[k] for k in axes},
        "tool_nm": list(modal.tool_nm),
        "work_system": WORK_SYSTEMS[min(modal.work_system, len(WORK_SYSTEMS) - 1)],
        "tool_next": modal.tool_next, "tool_in": modal.tool_in,
        "line": host.pose.line if host.serve.phase or not lib.nck_is_idle(nck) else 0,
        "moves": not lib.nck_is_idle(nck),
    }  # fmt: skip


def _found(said, key, kinds):
    """Return the value of a key (``g92_nm.x``) of a record, which is of one of these types."""
    value = said
    for name in key.split("."):
        if not isinstance(value, dict) or name not in value:
            raise ValueError(f"{key}: is missing")
        value = value[name]
    if type(value) not in kinds:
        words = " or ".join({int: "whole number", bool: "true", str: "text", list: "list"}[kind]
                            for kind in kinds)  # fmt: skip
        raise ValueError(f"{key}: {value!r:.40} is no {words}")
    return value


def _number(value, key, least, most):
    if type(value) is not int or not least <= value <= most:
        raise ValueError(f"{key}: {value!r:.40} is no whole number from {least} to {most}")
    return value


def _place(said, key):
    return _number(_found(said, key, (int,)), key, -_PLACE_MOST, _PLACE_MOST)


def _count(said, key):
    return _number(_found(said, key, (int,)), key, 0, _COUNT_MOST)


def restore(nck, host, said):
    """Take a record over; return what it was, in words, or raise ValueError with the key."""
    modal, length = modal_of(nck), _found(said, "tool_nm", (list,))
    system = _found(said, "work_system", (str,))
    if system not in WORK_SYSTEMS:
        raise ValueError(f"work_system: {system!r:.40} is none")
    modal.work_system = WORK_SYSTEMS.index(system)
    modal.tool_next, modal.tool_in = _count(said, "tool_next"), _count(said, "tool_in")
    if len(length) != len(modal.tool_nm):
        raise ValueError("tool_nm: has not three numbers")
    modal.tool_nm = [_number(each, "tool_nm", -_PLACE_MOST, _PLACE_MOST) for each in length]
    for k, at, _ in present(nck):
        modal.position_nm[k] = _place(said, f"position_nm.{at}")
        modal.g92_nm[k] = _place(said, f"g92_nm.{at}")
    line, moved = _count(said, "line"), _found(said, "moves", (bool,))
    check(lib.host_serve_restore(host, modal, moved))
    if not moved:
        return "the axes stand where they stood"
    return f"the power has failed in motion, in line {line}: the place of the axes is a guess"


def shown(nck, host):
    """Return what a person wants to see: the state, where the tool is, speeds, overrides."""
    serve, modal = host.serve, modal_of(nck)
    origin = [modal.origin_nm[k] / 1e6 for k in range(lib.NCK_AXIS_MAX)]
    at, tick = list(host.pose.axis), serve.tick
    pins = host.inputs.pins if serve.inputs else 0
    bits = [(each + k, at.upper()) for k, at, _ in present(nck)
            for each in (lib.HAL_IN_LIMIT, lib.HAL_IN_HOME)]  # fmt: skip
    bits += [(lib.HAL_IN_PROBE, "probe"), (lib.HAL_IN_DOOR, "door"),
             (lib.HAL_IN_EMERGENCY, "emergency")]  # fmt: skip
    named = dict.fromkeys(word for bit, word in bits if pins >> bit & 1)
    return {
        "state": ffi.string(lib.serve_state(ffi.addressof(serve))).decode(),
        "at": at[:3], "line": host.pose.line,
        "axes": [[AXES[k].upper(), at[k], at[k] - origin[k]] for k, _, _ in present(nck)],
        "speed": host.pose.v * 60 / host.pose.feed_scale, "rpm": tick.rpm if tick.turns else 0,
        "feed": serve.feed, "rapid": serve.rapid, "spindle": serve.spindle,
        "pins": " ".join(named),
    }  # fmt: skip
