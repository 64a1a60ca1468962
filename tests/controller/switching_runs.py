# SPDX-License-Identifier: MIT
"""Homing, probing and switches of a machine that speaks grbl's protocol, in virtual time.

    python tests/controller/switching_runs.py homes COUNT [FIRST]    homed again and again
    python tests/controller/switching_runs.py probes COUNT [FIRST]   a plate that is probed
    python tests/controller/switching_runs.py limits COUNT [FIRST]   limits, doors, broken wires
    python tests/controller/switching_runs.py waits COUNT [FIRST]    the spindle's speed, M66
"""

import random
import sys

from serving_runs import HOLD, RESET, RESUME, Broken, Talk, main, mill

from pycnc.machine import Machine

STEP_NM = 5000  # of a motor: 200 steps a millimetre
MOST_NM = 200_000_000  # of the least travel, either way


def machine_with(draw, talk, **switches):
    """Wire switches at random places; return the members of `inputs_set_t`."""
    bounce = draw.randint(0, 6)
    slow = 0.8 * STEP_NM / (bounce + 1) * 0.06  # so many mm/min that a bounce is within a step
    inputs = {
        "homes": 1, "limits": draw.randint(0, 1), "feed": min(slow, draw.uniform(20, 200)),
        "seek": draw.uniform(300, 9000), "pull_off": draw.uniform(0.5, 4), "reverse":
        draw.randint(0, 7), "debounce": draw.randint(7, 40),
    }  # fmt: skip
    reverse = inputs["reverse"]
    places = [draw.randint(-MOST_NM, MOST_NM) * (-1 if reverse >> k & 1 else 1) for k in range(3)]
    wired = {"wired": 7, "place_nm": places, "least": reverse, "bounce": bounce,
             "seed": draw.randint(1, 10**9)}  # fmt: skip
    talk.session.connect(inputs, **(wired | switches))
    return inputs, places


def lines_of(talk, patience=2_000_000):
    """Return what is said until the line in work is answered."""
    lines = []
    for _ in range(patience // 50):
        while talk.said:
            line = talk.said.pop(0)
            lines.append(line)
            if line == "ok" or line.startswith("error:"):
                return lines
        talk.wait(50)
    raise Broken(f"no answer: {lines}")


def home(talk):
    """Home; return what was said."""
    talk.send(b"$H\n")
    return lines_of(talk)


def stand_near(draw, talk, places):
    """Move the real axes to where a search finds the switch, unknown to the kernel."""
    reverse = talk.session._host.switches.least
    away = [draw.randint(0, 150_000_000) * (1 if reverse >> k & 1 else -1) for k in range(3)]
    kept = [place + way for place, way in zip(places, away, strict=True)]
    if draw.random() < 0.2:
        axis = draw.randrange(3)
        kept[axis] = places[axis]
    talk.session.wire("real_nm", kept)


def homes(seed):
    """Home twice, from elsewhere: the axes stand pull-off from their switches, to a step."""
    draw, talk = random.Random(seed), Talk(mill())
    inputs, places = machine_with(draw, talk)
    for _ in range(2):
        stand_near(draw, talk, places)
        talk.wait(50)
        talk.said.clear()
        modes = talk.ask("$G")
        if home(talk) != ["ok"]:
            raise Broken("homing has failed")
        off = round(inputs["pull_off"] * 1e6)
        for axis in range(3):
            sign = 1 if inputs["reverse"] >> axis & 1 else -1
            miss = talk.session.real_nm[axis] - places[axis] - sign * off
            if abs(miss) > STEP_NM:
                raise Broken(f"axis {axis} misses by {miss} nm")
            least, most = talk_travel(talk, axis)
            end = least if sign > 0 else most
            if talk.session.joints_nm[axis] != end + sign * off:
                raise Broken(f"axis {axis} is told at {talk.session.joints_nm[axis]}")
        if talk.ask("$G") != modes or talk.status()["state"] != "Idle":
            raise Broken("homing has changed modes")
        talk.check()


def talk_travel(talk, axis):
    """Return the travel of an axis [nm]."""
    each = talk.session._machine.pointer[0].axis[axis]
    return each.min_nm, each.max_nm


def probes(seed):
    """Probe a plate: what is told is where it is, to a step; misses and wrong starts are told."""
    draw, talk = random.Random(seed), Talk(mill())
    machine_with(draw, talk, wired=0, plate_nm=-draw.randint(10_000, 9_000_000))
    plate = talk.session._host.switches.plate_nm
    talk.said.clear()
    talk.ask("$X")
    slow = 0.8 * STEP_NM / (talk.session._host.switches.bounce + 1) * 0.06
    talk.ask("G21G91" + draw.choice(("", "G55", "G92Z3")))
    code, speed = draw.choice("23"), draw.uniform(0.3, 1) * min(slow, 200)
    talk.send(f"G38.{code}Z-10F{speed:.3f}\n".encode())
    at, ok = lines_of(talk)
    told = told_of(at, 1)
    if ok != "ok" or not -500 <= plate - told <= STEP_NM:
        raise Broken(f"{at}, and the plate is at {plate}")
    if talk.ask("$#")[-2] != at:
        raise Broken("$# tells another place")
    under = talk.session.joints_nm[2]
    if not told - 500 - way_nm(talk, speed) <= under <= told + 500:
        raise Broken(f"the tool went on to {under}")
    zero = draw.choice(("G10L20P1Z0", "G10 L2 P1 Z3", "G92Z0", "G43.1Z1", "G28.1", "G30.1"))
    if talk.ask(zero) != ["ok"] or talk.session.joints_nm[2] != under:
        raise Broken(f"{zero} goes on probing")
    talk.wait(50)
    talk.send(f"G38.{code}Z-1\n".encode())
    if lines_of(talk) != ["ALARM:4", "ok"]:
        raise Broken("a probe that touches must not go on")
    talk.ask("$X")
    talk.send(f"G38.4Z5F{speed:.3f}\n".encode())
    told = told_of(lines_of(talk)[0], 1)
    if not -500 <= told - plate <= STEP_NM:
        raise Broken(f"left at {told}, and the plate is at {plate}")
    talk.wait(50)
    talk.send(b"G38.3X3F900\nX-1\nG38.2X1\nX2\n")
    said = [lines_of(talk) for _ in range(4)]
    told_of(said[0][0], 0), told_of(said[1][0], 0)
    if said[2][1:] != ["ALARM:5", "ok"] or said[3] != ["error:9"]:
        raise Broken(f"{said}")
    talk.check()


def way_nm(talk, speed):
    """Return how far Z goes on from a speed [mm/min], by the formula of the stop."""
    axis, v = talk.session._machine.pointer[0].axis[2], speed / 60
    return 1e6 * v / 2 * max(1.5 * v / axis.a_max, (6 * v / axis.j_max) ** 0.5) + 1


def told_of(line, touched):
    """Return the Z of a report of a probe [nm]."""
    if not line.startswith("[PRB:") or not line.endswith(f":{touched}]"):
        raise Broken(f"{line!r} tells no probe")
    return round(float(line[5:-3].split(",")[2]) * 1e6)


def limits(seed):
    """Run into a limit, open a door, push the emergency stop, break a wire: all are told."""
    draw, talk = random.Random(seed), Talk(mill())
    kind = draw.choice(("limit", "door", "emergency", "wire", "none", "reset", "hold"))
    inputs, places = machine_with(draw, talk, place_nm=[60_000_000] * 3, least=0,
                                  seed=draw.randint(1, 10**9))  # fmt: skip
    talk.session._host.inputs.set.reverse, talk.session._host.inputs.set.limits = 0, 1
    talk.wait(50)
    talk.said.clear()
    talk.ask("$X")
    {"limit": _limit, "door": _door, "emergency": _emergency, "wire": _wire, "none": _none,
     "reset": _break_off, "hold": _break_off}[kind](draw, talk, kind)  # fmt: skip
    talk.check()


def _limit(draw, talk, _):
    feed = draw.uniform(100, 9000)
    talk.send(f"G21G91G1{draw.choice('XYZ')}90F{feed:.1f}\nX1\n".encode())
    talk.wait(2_000 + round(65 / feed * 60_000))
    over = max(talk.session.real_nm[:3]) - 60_000_000
    late = feed / 60 * 1e3 * (talk.session._host.switches.bounce + 1)  # nm that a bounce takes
    if "ALARM:1" not in talk.said or not 0 <= over <= way_nm(talk, feed) * 1.01 + late:
        raise Broken(f"{talk.said}, {over} nm beyond")
    talk.said.clear()
    if talk.ask("X-1") != ["error:9"] or "Pn" not in talk.status():
        raise Broken("a limit locks, and is told")
    talk.ask("$X")
    if talk.ask("$J=G91X-30Y-30Z-30F5000") != ["ok"]:
        raise Broken("no jog off the switch")
    talk.settle()
    if "Pn" in talk.status():
        raise Broken("the switch has not opened")


def _door(draw, talk, _):
    talk.ask("G21G91G1X50F1200")
    talk.wait(draw.randint(100, 1500))
    talk.session.wire("pushed", 1 << 19)
    talk.wait(3)
    talk.send(RESUME)
    talk.wait(1500)
    at = talk.session.joints_nm
    talk.send(RESUME)
    talk.wait(200)
    state = talk.status()
    moved = at != talk.session.joints_nm
    if not state["state"].startswith("Door:0") or state["Pn"] != "D" or moved:
        raise Broken(f"{state}")
    talk.session.wire("pushed", 0)
    talk.wait(20)
    talk.settle()
    if talk.session.joints_nm[0] != 50_000_000:
        raise Broken("a door loses nothing")


def _emergency(draw, talk, _):
    if draw.random() < 0.5:
        talk.ask("G21G91G1X50F1200")
    else:
        talk.send(b"$H\n")
    talk.wait(draw.randint(100, 1500))
    talk.said.clear()
    talk.session.wire("pushed", 1 << 20)
    talk.wait(1500)
    at = talk.session.joints_nm
    talk.wait(100)
    if "ALARM:10" not in talk.said or at != talk.session.joints_nm:
        raise Broken(f"{talk.said}")
    talk.session.wire("pushed", 0)
    talk.wait(50)
    talk.said.clear()
    if talk.ask("X1") != ["error:9"]:
        raise Broken("an emergency stop locks")


def _wire(draw, talk, _):
    axis = draw.randrange(3)
    talk.session.wire("broken", 1 << (9 + axis))
    said = home(talk)
    if said != ["ALARM:8", "ok"] or talk.status()["state"] != "Alarm":
        raise Broken(f"{said}")


def _none(draw, talk, _):
    talk.session.wire("wired", 7 & ~(1 << draw.randrange(3)))
    talk.session._host.inputs.set.seek = 9000.0
    said = home(talk)
    if said != ["ALARM:9", "ok"] or talk.status()["state"] != "Alarm":
        raise Broken(f"{said}")


def _break_off(draw, talk, kind):
    talk.send(b"$H\n")
    talk.wait(draw.randint(1, 4000))
    if talk.said:
        return
    talk.send(RESET if kind == "reset" else b"!")
    talk.wait(3000)
    last = "Grbl 1.1f ['$' for help]" if kind == "reset" else "ok"
    if talk.said[-1] == "ALARM:1":  # the brake has ended at the switch
        talk.said.pop()
    if talk.said[0] != "ALARM:6" or talk.said[-1] != last or talk.status()["state"] != "Alarm":
        raise Broken(f"{talk.said}")
    talk.said.clear()
    talk.ask("$X")
    if talk.ask(f"G91G1X{'-' if talk.session.joints_nm[0] > 0 else ''}1F900") != ["ok"]:
        raise Broken("nothing goes on")
    talk.settle()


def _tick(draw, talk):
    """Let a tick pass, under an operator's hands; nothing moves while the spindle is too slow."""
    switches, moved = talk.session._host.switches, talk.session.moving
    slow = switches.rpm != switches.rpm_wanted and switches.rpm_wanted != 0
    if draw.random() < 0.03:
        talk.send(draw.choice((HOLD, RESUME, RESUME)))
    talk.wait(1)
    if slow and switches.rpm != switches.rpm_wanted and talk.session.moving > moved:
        raise Broken(f"moves at {switches.rpm} of {switches.rpm_wanted} rpm")


def _do(draw, talk, line, happens=None, at=None):
    """Send a line and wait for its answer; in a tick of it a port is pushed."""
    talk.send(line.encode() + b"\n")
    for ticks in range(100_000):
        if ticks == at:
            talk.session.push(*happens)
        if talk.said:
            break
        _tick(draw, talk)
        if ticks % 50 == 0:
            talk.send(RESUME)
    if talk.said != ["ok"]:
        raise Broken(f"{line}: {talk.said}")
    talk.said.clear()


def _ask_input(draw, talk):
    """Wait for a port; return what #5399 has to be."""
    port, kind, comes = draw.randrange(8), draw.randrange(5), draw.random() < 0.6
    name, is_on = f"port{port}", draw.random() < 0.5
    if kind in (1, 2):
        is_on = kind == 2
    talk.session.push(name, is_on)
    talk.settle()
    line = f"M66P{port}L{kind}" + (f"Q{30 if comes else 0.2}" if kind else "")
    goes = comes and draw.randint(400, 800)
    _do(draw, talk, line, (name, not is_on), at=goes or None)
    if kind == 0:
        return int(is_on)
    high = kind in (1, 3)
    if kind > 2 and is_on == high:
        return int(high)
    return int(high) if comes else -1


def waits(seed):
    """Nothing moves before the spindle has its speed, whatever is sent; M66 has its answer."""
    draw = random.Random(seed)
    settings = {"spindle.waits": True, "spindle.a_max_rpm_s": draw.randint(1000, 20000)}
    machine = Machine.load("mill3", set={"path.slope": draw.choice(("jerk", "linear"))} | settings)
    talk = Talk(machine)
    bounce = draw.randint(0, 6)
    rate = settings["spindle.a_max_rpm_s"] * machine.pointer[0].period_s
    talk.session.connect({"homes": 0, "debounce": 25}, bounce=bounce, rpm_tick=rate)
    talk.said.clear()
    words = ("M3S{s}", "M4", "M5", "S{s}", "M3", "M8", "G4P0.05", "M4S{s}")
    for _ in range(12):
        x = draw.randint(-20, 20)
        kind = draw.random()
        if kind < 0.4:
            _do(draw, talk, draw.choice(words).format(s=draw.randint(10, 9000)))
        if kind > 0.7:
            answer = _ask_input(draw, talk)
            _do(draw, talk, f"G1X[{x}+#5399]F3000")
            x += answer
        else:
            _do(draw, talk, f"G{draw.choice('01')}X{x}F3000")
    for _ in range(300):
        _tick(draw, talk)
    talk.settle()
    if talk.session.joints_nm[0] != x * 1_000_000:
        raise Broken(f"at {talk.session.joints_nm}, not at X{x}")
    talk.check()


SEARCHES = {"homes": homes, "probes": probes, "limits": limits, "waits": waits}


if __name__ == "__main__":
    sys.exit(main(SEARCHES))
