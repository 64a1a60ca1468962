# SPDX-License-Identifier: MIT
"""A sender that means no good, against a machine with switches, in virtual time.

    python tests/controller/hostile_runs.py storms COUNT [FIRST]   all there is
    python tests/controller/hostile_runs.py doors COUNT [FIRST]    a door and holds at any moment

Whatever it sends: each line is answered once, a report comes within 20 ms and says where the
machine is, no axis leaves its travel or passes its speed, nothing moves at an alarm, in sleep or
behind an open door, and behind a reset the machine does what it is told.
"""

import random
import re
import sys

from serving_runs import HOLD, PATIENCE, RESET, RESUME, Broken, Talk, main
from test_serve_inputs import INPUTS, machine

TRAVEL_NM = (-150_000_000, 50_000_000)
REPORT_MOST = 20  # ticks until ? is answered
REST_MOST = 3000  # … and until the machine has braked
BOUNCE_MOST = 9  # … until a switch that has opened is open
BRAKE_MOST = 400  # … at the accelerations of its file
STATES = "Idle|Run|Hold:[01]|Jog|Alarm|Door:[0-3]|Check|Home|Sleep"
REPORT = re.compile(
    rf"<({STATES})\|[MW]Pos:(-?\d+\.\d+,){{2}}-?\d+\.\d+(\|Bf:\d+,\d+)?(\|Ln:\d+)?\|FS:\d+,\d+"
    r"(\|Pn:[A-Z]+)?(\|WCO:[-.,\d]+)?(\|Ov:\d+,\d+,\d+)?(\|A:[SCFM]+)?>"
)
NUMBERS = ("0", "1", "-1", "2.5", "-0.001", "99999999", "1e3", "", ".", "-", "200", "-150", "50",
           "0.0000001", "4294967296", "49.9999")  # fmt: skip
STILL = ("Alarm", "Sleep", "Check")


def _setting(draw):
    name = draw.choice((*range(0, 34), 100, 110, 111, 112, 113, 119, 120, 121, 122, 130, 131, 132,
                        200, 256, 4294967306))  # fmt: skip
    return f"${name}={draw.choice(NUMBERS)}"


def _word(draw, letters="XYZABCUVWIJKRFSTNPLQHDE#GM"):
    return draw.choice(letters) + draw.choice(NUMBERS)


def _jog(draw):
    kinds = (lambda: "G91X1F900", lambda: f"{_word(draw, 'XYZ')}F{draw.randint(1, 9000)}",
             lambda: "".join(_word(draw) for _ in range(draw.randint(0, 4))),
             lambda: f"G53X{draw.choice((-150, 50, 50.001, -150.001))}Y50Z-150F9000",
             lambda: "G20G91Y-.1F90", lambda: "G90G21X0F1000N7")  # fmt: skip
    return "$J=" + draw.choice(kinds)()


def _corner(draw):
    ends = [draw.choice((-150, 50, -150.001, 50.001)) for _ in range(3)]
    return "G53G0X{}Y{}Z{}".format(*ends)


LINES = (
    _setting, _jog, _corner,
    lambda draw: "".join(_word(draw) for _ in range(draw.randint(0, 6))),
    lambda draw: f"G1X{draw.uniform(-40, 40):.3f}Z{draw.uniform(-40, 40):.3f}F2000",
    lambda draw: f"G38.{draw.choice('2345')}Z{draw.choice((-45, 5, -60))}F{draw.choice((60, 999))}",
    lambda draw: draw.choice((
        "$H", "$X", "$", "$$", "$#", "$G", "$I", "$N", "$C", "$RST=*", "$RST=$", "$RST=#", "$SLP",
        "$N0=G1", "$HX", "$x", "$ G", "M6T1", "T99M6", "M0", "M1", "M2", "M30", "M60", "G20", "G21",
        "G91", "G90", "G4P0.05", "G4P-1", "G92X0Y0Z0", "G92.1", "G10L2P1X3", "G10L20P0Z0", "G28",
        "G30", "G28.1", "G43.1Z2", "G49", "G41D1", "G40", "M3S9000", "M4", "M5", "M7", "M8", "M9",
        "G93", "G94", "G95", "G55", "G54", "M98P1", "O1", "#1=3", "(MSG,hi)", "%", "/G1X1",
        "G81X1Z-1R1",
        "G2X9I4.5F900", "G17", "G18", "G64P0.1", "G61", "G80", "M62P1", "M66P1L3Q9", "G33Z1K1",
        "G76P1", "G96S100", "M48", "M49", "M110", "E1",
    )),
    lambda draw: "X" * draw.randint(70, 2000),
    lambda draw: "(" + "c" * draw.randint(0, 500) + draw.choice((")", "")),
)  # fmt: skip
WAYS = (
    lambda draw: f"$J=G91{draw.choice('XYZ')}{draw.choice((-1, 1)) * draw.randint(1, 30)}F3000",
    lambda draw: draw.choice(("M2", "$H", "G28", "G4P0.1", "G38.3X-20F900")),
    lambda draw: "$X",
)  # fmt: skip
SIGNALS = (b"?", b"!", b"~", b"\x84", b"\x85", b"\x90", b"\x91", b"\x92", b"\x95", b"\x97", b"\x99",
           b"\x9a", b"\x9e", b"\xa0", b"\xa1", b"\xff", b"\x80", b"\xc3\x9f")  # fmt: skip


class Storm:
    """One machine and what has come over it."""

    lines = LINES

    def __init__(self, seed):
        self.draw = random.Random(seed)
        slope = self.draw.choice(("jerk", "jerk", "linear", "optimal"))
        self.talk = Talk(machine(INPUTS, **{"path.slope": slope}))
        self.session = self.talk.session
        self.open, self.sent, self.answers, self.trace = False, 0, 0, []
        self.asked_at, self.homed = None, False
        if self.draw.random() < 0.6:
            self.sent += 1
            self.roams = self.draw.random() < 0.5
            self.send(b"$H\n" if self.roams else b"$X\n")

    def send(self, data):
        self.trace.append(data)
        for ticks in range(1, PATIENCE):
            data = data[self.session.receive(data) :]
            self.wait(1)
            if not data:
                return
            self.trace.pop()
            if ticks % REST_MOST == 0:  # held, and the ring is full
                self.close()
                self.session.receive(RESUME)
        raise Broken("no room for what is sent")

    def close(self):
        """Close the door."""
        self.open = False
        self.session.push("door", False)

    def wait(self, ticks):
        """Let time pass, and hold what always holds."""
        self.trace.append(ticks)
        self.talk.wait(ticks)
        self.talk.check()
        while self.talk.said:
            said = self.talk.said.pop(0)
            self.trace.append(said)
            self.hear(said)
        self.stay()

    def stay(self):
        """Soft limits hold at every place, until they are set off or homing knows better."""
        if not self.roams and self.is_out():
            raise Broken(f"out of the travel: {self.session.joints_nm}")

    def is_out(self):
        least, most = TRAVEL_NM
        return not all(least <= at <= most for at in self.session.joints_nm)

    def hear(self, said):
        if re.fullmatch(r"ok|error:\d+", said):
            self.answers += 1
            if self.answers > self.sent:
                raise Broken(f"an answer too many: {said}")
        elif said.startswith("<"):
            if not REPORT.fullmatch(said):
                raise Broken(f"{said!r} is no report")
            self.reports += 1
        elif said.startswith("Grbl 1.1"):
            self.banners += 1
        elif said == "ALARM:1":
            self.roams = True  # a limit's switch stops where it can
        elif not re.match(r"ALARM:\d+$|\[.*\]$|\$\d+=[\d.]+$|\$N[01]=$", said):
            raise Broken(f"{said!r} is nothing that is said")

    reports = banners = roams = 0

    def report(self):
        """Ask; return the report, which must come soon and be true at rest."""
        before, moved = self.reports, self.session.moving
        self.send(b"?")
        for _ in range(REPORT_MOST):
            if self.reports > before:
                break
            self.wait(1)
        else:
            raise Broken(f"no report in {REPORT_MOST} ms")
        text = next(said for said in reversed(self.trace) if str(said).startswith("<"))
        if "MPos" in text and moved == self.session.moving:
            words = re.search(r"MPos:([-.,\d]+)", text)[1].split(",")
            unit, most = (25.4e6, 1271) if "." == words[0][-5] else (1e6, 501)  # $13=1: inches
            for told, nm in zip(words, self.session.joints_nm, strict=True):
                if abs(float(told) * unit - nm) > most:
                    raise Broken(f"{text} at {self.session.joints_nm}")
        return REPORT.fullmatch(text)[1]

    def still(self, state):
        """What must not move does not."""
        if state not in STILL and not (self.open and state.startswith("Door")):
            return
        self.wait(REST_MOST)
        moved = self.session.moving
        self.wait(200)
        if moved != self.session.moving and self.report() == state:
            raise Broken(f"moves in {state}")

    def piece(self):
        """Send a line, with signals anywhere in it."""
        draw = self.draw
        data = draw.choice(self.lines)(draw).encode()
        if draw.random() < 0.3:
            at = draw.randint(0, len(data))
            data = data[:at] + draw.choice(SIGNALS) + data[at:]
        self.sent += 1
        line = re.sub(rb"[^!-~]|[?!~]", b"", data)  # as the machine reads it
        self.roams = self.roams or re.search(rb"\$(20=|H)", line) is not None
        self.send(data + b"\n")

    def act(self):
        draw = self.draw
        kind = draw.random()
        if kind < 0.6:
            self.piece()
        elif kind < 0.8:
            self.send(draw.choice(SIGNALS))
        elif kind < 0.84:
            self.swing()
        elif kind < 0.85:
            self.stop()
        elif kind < 0.87:
            self.still(self.report())
        elif kind < 0.89:
            self.reset()
        elif kind < 0.9:
            self.cable()
        self.wait(draw.choice((0, 1, 3, 30, 300, 2000)))

    def swing(self):
        """Open the door, or close it."""
        self.open = not self.open
        self.trace.append(f"door {self.open}")
        self.session.push("door", self.open)

    def stop(self):
        """Push the emergency stop, and pull it out again."""
        self.trace.append("emergency")
        self.session.push("emergency", True)
        self.wait(self.draw.choice((1, 50)))
        self.session.push("emergency", False)

    def reset(self):
        """Reset: a banner comes, and answers no more than were due."""
        before, roams = self.banners, self.roams
        self.roams = True  # a switch that its brake meets stops where it can, and tells no alarm
        self.send(RESET)
        self.wait_for(lambda: self.banners > before, "no banner behind a reset")
        self.roams = roams or self.is_out()
        self.sent = self.answers

    def cable(self):
        """Pull the cable and plug it in."""
        self.trace.append("cable")
        self.session.part()
        self.wait(self.draw.choice((0, 5, 1500)))
        self.sent = self.answers
        self.session.join()
        self.wait(5)
        self.wait(REST_MOST)
        self.sent = self.answers

    def wait_for(self, condition, words, patience=400):
        for _ in range(patience):
            if condition():
                return
            self.wait(50)
            del self.trace[-1:]
        raise Broken(words)

    def end(self):
        """All lines are answered; a reset makes a machine of it again."""
        self.close()
        for _ in range(2000):
            if self.answers == self.sent:
                break
            moving = self.session.moving
            self.send(RESUME)
            self.wait(100)
            del self.trace[-3:]
        else:
            if moving == self.session.moving:  # else it is on a long way, or a slow one
                raise Broken(f"{self.answers} answers to {self.sent} lines, {self.report()}")
        self.wait(500)
        self.reset()
        self.sent += 3
        self.send(b"$X\n$111=600\n$121=500\n")
        self.wait(50)
        if self.report() != "Idle":
            raise Broken(f"{self.report()} behind reset and $X")
        self.sent += 2
        self.send(b"G21G94G90G49G92.1\nG53G1Y-50F600\n")
        self.wait_for(lambda: self.report() == "Idle", "a way of 20 s takes too long", 1000)
        there = self.session.joints_nm
        if there[1] != -50_000_000 or self.answers != self.sent:
            raise Broken(f"goes to {there}")


class Doors(Storm):
    """A door that opens at any moment: a brake later nothing moves until it is closed and ~ comes.

    So it is behind !. What ends it besides: a reset, and an alarm, which holds in its place.
    """

    lines = (*LINES[1:], *LINES[4:6], *WAYS, *WAYS, *WAYS)  # no slower brakes
    rests_at = None  # ticks of the session from which on nothing moves
    swung = 0  # … and when the door was
    begun = 0  # … the wait in work

    def swing(self):
        super().swing()
        self.swung = self.session.ticks
        if self.open:
            self.rests_at = self.rests_at or self.session.ticks + BRAKE_MOST
        elif not self.report().startswith("Door"):
            self.rests_at = None

    def hold(self):
        """Hold; what is cancelled by it, as a jog is, is not held behind its brake."""
        self.send(HOLD)
        self.wait(BRAKE_MOST)
        if self.report().startswith("Hold"):
            self.rests_at = self.rests_at or self.session.ticks

    def close(self):
        super().close()
        self.rests_at = None

    def send(self, data):
        since = self.session.ticks - self.swung
        if RESUME in data and (not self.open or since < BOUNCE_MOST):
            self.rests_at = self.session.ticks + BRAKE_MOST if self.open else None
        super().send(data)

    def hear(self, said):
        super().hear(said)
        if "Unlocked" in said and self.open and self.begun - self.swung > BOUNCE_MOST:
            raise Broken("unlocked while the door is open")
        if re.match("ALARM|Grbl", said) and not self.open:
            self.rests_at = None

    def wait(self, ticks):
        self.begun = self.session.ticks
        left = max(0, (self.rests_at or 0) - self.begun)
        if left > 0:
            super().wait(min(left, ticks))
        moved = self.session.moving
        if ticks > left:
            super().wait(ticks - left)
        if self.rests_at and self.session.moving > moved:
            raise Broken("moves behind a door")

    def act(self):
        draw = self.draw
        each = (self.piece, self.swing, self.stop, self.reset, self.cable,
                self.hold, lambda: self.send(draw.choice(SIGNALS)))  # fmt: skip
        draw.choices(each, (60, 20, 0.5, 2, 1, 4, 9))[0]()
        self.wait(draw.choice((0, 1, 3, 30, 100, 500)))
        if self.rests_at and draw.random() < 0.1:
            self.go_on()

    def go_on(self):
        """Close the door, and go on."""
        if self.open:
            self.swing()
        self.wait(BOUNCE_MOST)
        self.send(RESUME)


def storms(seed):
    """One storm."""
    come_over(Storm(seed))


def doors(seed):
    """One door."""
    come_over(Doors(seed))


def come_over(storm):
    """Let it come, and end."""
    try:
        for _ in range(storm.draw.randint(5, 60)):
            storm.act()
        storm.end()
    except Broken as cause:
        raise Broken(f"{cause}\n    {storm.trace[-40:]}") from None


if __name__ == "__main__":
    sys.exit(main({"storms": storms, "doors": doors}))
