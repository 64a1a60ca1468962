# SPDX-License-Identifier: MIT
"""Sessions with a machine that speaks grbl's protocol, in virtual time.

    python tests/controller/serving_runs.py streams COUNT [FIRST]   random programs, streamed
    python tests/controller/serving_runs.py jogs COUNT [FIRST]      jogs, cancelled at any moment
    python tests/controller/serving_runs.py bytes COUNT [FIRST]     bytes at random
    python tests/controller/serving_runs.py brakes COUNT [FIRST]    holds at any moment
    python tests/controller/serving_runs.py modes COUNT [FIRST]     modes at the tool, by line
    python tests/controller/serving_runs.py resets COUNT [FIRST]    resets at any moment
    python tests/controller/serving_runs.py returns COUNT [FIRST]   from outside of the travel

A session in a file is text, a step a line: ``> G1 X5`` sends a line, ``= 18`` bytes in hexadecimal,
``. 200`` lets ticks pass; ``< ok`` is what is said next, where … stands for anything. What
``pycnc serve --record`` writes is one, too (pycnc/controller/recording.py).
"""

import random
import re
import sys

import pycnc
from pycnc.kernel.bind import ffi, lib
from pycnc.kernel.session import Session
from pycnc.machine import Machine

RING = 127
MICRON_NM = 1000  # what a report counts by
PATIENCE = 400_000  # ticks without an answer
SLOPES = ("jerk", "jerk", "optimal")
HOLD, RESUME, RESET, CANCEL = b"!", b"~", b"\x18", b"\x85"
OVERRIDES = b"\x90\x91\x92\x93\x94\x95\x96\x97\x99\x9a"


class Broken(AssertionError):
    """A session is not as it must be."""


def mill(**changes):
    """Return the machine of the sessions, whose plans are soon made."""
    return Machine.load("mill3", dialect="grbl", set={"path.slope": "jerk"} | changes)


class Talk:
    """A session, and the lines that it has said."""

    def __init__(self, machine=None, session=None):
        self.session = session or Session(machine or mill())
        self._part, self.said = b"", []
        self.listen()

    def listen(self):
        """Take what was said."""
        *lines, self._part = (self._part + self.session.take()).split(b"\r\n")
        self.said += [line.decode("ascii") for line in lines if line]

    def send(self, data):
        """Hand over bytes, letting time pass where they find no room."""
        for _ in range(PATIENCE):
            data = data[self.session.receive(data) :]
            if not data:
                return
            self.wait(1)
        raise Broken("no room for what is sent")

    def wait(self, ticks):
        """Let ticks pass."""
        self.session.run(ticks)
        self.listen()

    def next(self):
        """Return what is said next."""
        if self.comes():
            return self.said.pop(0)
        raise Broken("nothing is said")

    def comes(self, patience=20_000):
        """Return whether something is said within so many ticks."""
        for _ in range(patience // 10):
            if self.said:
                return True
            self.wait(10)
        return False

    def ask(self, line):
        """Return what is said to a line, to its ok or error."""
        self.send(line.encode() + b"\n")
        answers = [self.next()]
        while not re.match(r"ok|error:", answers[-1]):
            answers.append(self.next())
        return answers

    def status(self):
        """Return the fields of a status report by their names."""
        self.send(b"?")
        while not any(said.startswith("<") for said in self.said):
            self.wait(1)
        at = next(k for k, said in enumerate(self.said) if said.startswith("<"))
        words = self.said.pop(at).strip("<>").split("|")
        return {"state": words[0]} | dict(word.split(":") for word in words[1:])

    def zero(self):
        """Return the zero of the work for the next line, as a report tells it."""
        modal = ffi.new("nck_modal_t *")
        lib.nck_modal(self.session._nck, modal)
        return ",".join(f"{nm / 1e6:.3f}" for nm in modal.origin_nm[0:3])

    def settle(self, patience=PATIENCE):
        """Wait until the machine is idle, going on where it is held."""
        for _ in range(patience // 50):
            state = self.status()["state"]
            if state == "Idle":
                return
            if state.startswith(("Hold", "Door")):
                self.send(RESUME)
            self.wait(50)
        raise Broken(f"not at rest: {self.status()}")

    def check(self):
        """Hold what must always hold."""
        if self.session.broken:
            raise Broken(f"invariants of rooms {self.session.broken:#x}")
        if self.session.speed_most > 1 + 1e-6:
            raise Broken(f"{self.session.speed_most} of an axis' speed")


EVENTS = {
    "+": lambda session: session.join(), "-": lambda session: session.part(),
    "*": lambda session, name, pushed: session.push(name, pushed == "1"),
}  # fmt: skip


def play(text, machine=None, session=None):
    """Play a session in text; raise Broken with its line where it is not as written."""
    talk = Talk(machine, session)
    for number, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.partition(" ")
        if kind == ">":
            talk.send(rest.encode() + b"\n")
        elif kind == "=":
            talk.send(bytes.fromhex(rest))
        elif kind == ".":
            for ticks in rest.split():
                talk.wait(int(ticks))
        elif kind in EVENTS:
            EVENTS[kind](talk.session, *rest.split())
        elif kind == "<":
            said = talk.next() if talk.comes() else "nothing"
            if not re.fullmatch(".*".join(map(re.escape, rest.split("…"))), said):
                raise Broken(f"line {number}: {rest!r} was to be said, not {said!r}")
        elif line and kind != "#":
            raise Broken(f"line {number}: no step")
    talk.wait(100)
    if talk.said:
        raise Broken(f"said besides: {talk.said}")
    talk.check()
    return talk


def program(draw):
    """Return a random program as lines, and which of them are wrong: {number: error}."""
    lines, wrong = ["G21G90", f"G1F{draw.randint(300, 4000)}"], {}
    kinds = {
        "line": lambda: f"G1X{draw.uniform(0, 60):.3f}Y{draw.uniform(0, 60):.3f}",
        "modal": lambda: f"G1\nX{draw.uniform(0, 60):.3f}",
        "named": lambda: f"N{draw.randint(1, 99999)} G1 Z{draw.uniform(-5, 5):.2f}",
        "rapid": lambda: f"g0 x{draw.uniform(0, 60):.2f} (fast) y{draw.uniform(0, 60):.2f}",
        "step": lambda: f"G91G1X{draw.uniform(-3, 3):.3f}\nG90",
        "inch": lambda: f"G20G1X{draw.uniform(0, 2):.4f}Y1\nG21",
        "arc": lambda: f"G{draw.choice('23')}X{draw.uniform(0, 60):.2f}Y{draw.uniform(0, 60):.2f}"
                       f"R{draw.uniform(60, 90):.1f}",
        "feed": lambda: f"F{draw.randint(200, 5000)}",
        "dwell": lambda: f"G4P{draw.uniform(0.0, 0.1):.2f}",
        "switch": lambda: draw.choice(("M3S1000", "M5", "M8", "M9", "S500", "", "; only words")),
        "offset": lambda: draw.choice(("G54", "G55", "G10L2P1X1Y0Z0", "G92X3\nG92.1", "G28.1")),
    }  # fmt: skip
    errors = {"G1Q1": 36, "G1X99999999": 2, "G999": 20, "X1X2": 25, "M3M4": 21, "G2X1": 35,
              "G1X" + "1" * 90: 11, "$99=1": 8, "M3S2000G1X1Q5": 36, "G10L2P1X9G2X1R0.01": 25}
    for _ in range(draw.randint(20, 120)):
        lines += kinds[draw.choice([*kinds])]().split("\n")
        if draw.random() < 0.1:
            text = draw.choice([*errors])
            wrong[len(lines)] = errors[text]
            lines.append(text)
    return lines, wrong


def _answers(talk):
    """Yield the answers among what was said, leaving reports out."""
    while talk.said:
        said = talk.said.pop(0)
        if said == "ok" or said.startswith("error:"):
            yield said
        elif not said.startswith(("<", "[MSG:")):
            raise Broken(f"{said!r} is no answer")


OFTEN = ((0.02, HOLD), (0.05, RESUME), (0.08, OVERRIDES), (0.16, b"?"), (0.162, b"\x84"))


def operate(talk, draw, chances=OFTEN):
    """Do something that an operator may, at a random moment; one of several overrides."""
    kind = draw.random()
    wanted = next((what for most, what in chances if kind < most), None)
    if wanted is OVERRIDES:
        wanted = bytes([draw.choice(OVERRIDES)])
    if wanted is not None:
        talk.send(wanted)


def stream(lines, draw, talk):
    """Send lines as many at once as the ring holds; return the answers."""
    lengths, answers, at, quiet, moving = [], [], 0, 0, 0
    while len(answers) < len(lines):
        while at < len(lines) and sum(lengths) + len(lines[at]) + 1 <= RING:
            data = lines[at].encode() + b"\n"
            if talk.session.receive(data) != len(data) or talk.session.waiting:
                raise Broken(f"line {at + 1} finds no room, though it was counted")
            lengths.append(len(data))
            at += 1
        operate(talk, draw)
        talk.wait(draw.choice((1, 2, 5, 20, 60)))
        before, moved = len(answers), moving
        answers += _answers(talk)
        del lengths[: len(answers) - before]
        moving = talk.session.moving
        quiet = 0 if len(answers) > before or moving > moved else quiet + 1
        if quiet > 500:
            talk.send(RESUME)
        if quiet > 5000:
            raise Broken(f"line {len(answers) + 1} is not answered: {lines[len(answers)]!r}")
    return answers


def end_of(lines, machine):
    """Return where a program ends when it is run [nm]."""
    done = pycnc.run("\n".join([*lines, "M2", ""]), machine=machine)
    return tuple(int(done.columns[f"joint_{k}_nm"][-1]) for k in range(3))


def streams(seed, session=None):
    """Stream a random program with random commands; hold every promise."""
    draw, machine = random.Random(seed), mill()
    lines, wrong = program(draw)
    talk = Talk(machine, session)
    talk.said.clear()
    answers = stream(lines, draw, talk)
    expected = [f"error:{wrong[k]}" if k in wrong else "ok" for k in range(len(lines))]
    for number, (got, want) in enumerate(zip(answers, expected, strict=True), 1):
        if got != want and not (want == "error:8" and got == "error:3"):
            raise Broken(f"line {number} {lines[number - 1]!r}: {got}, not {want}")
    talk.settle()
    talk.check()
    good = [line for k, line in enumerate(lines) if k not in wrong]
    where = end_of(good, machine)
    if talk.session.joints_nm != where:
        raise Broken(f"the end is at {talk.session.joints_nm}, not at {where}")


def jogs(seed):
    """Start jogs and cancel them at any moment; the machine rests where its report says."""
    draw, talk = random.Random(seed), Talk()
    talk.said.clear()
    modes = talk.ask("G90G20F7")[0] and talk.ask("$G")
    for _ in range(20):
        words = f"X{draw.uniform(-20, 20):.2f}Y{draw.uniform(-20, 20):.2f}F{draw.randint(50, 6000)}"
        lines = [f"$J=G91G21{words}"] * draw.choice((1, 1, 1, 3))
        for line in lines:
            talk.send(line.encode() + b"\n")
            talk.wait(draw.choice((0, 1, 30, 200)))
        talk.send(draw.choice((CANCEL, HOLD)))
        talk.wait(draw.choice((0, 5, 300)))
        talk.settle(20_000)
        answers = [said for said in talk.said if not said.startswith("<")]
        talk.said.clear()
        if answers != ["ok"] * len(lines):
            raise Broken(f"{lines}: {answers}")
        report, moving = talk.status(), talk.session.moving
        talk.wait(200)
        at = [float(word) * 1e6 for word in report["MPos"].split(",")]
        off = max(abs(told - nm) for told, nm in zip(at, talk.session.joints_nm, strict=True))
        if moving != talk.session.moving or off > MICRON_NM / 2 + 1e-3:
            raise Broken(f"reported at rest at {at}, moves to {talk.session.joints_nm}")
        if talk.ask("$G") != modes:
            raise Broken(f"a jog has changed the modes: {modes}")
        talk.check()


def modes(seed):
    """Ask for the modes at the tool at any moment: they are what its line has left."""
    draw = random.Random(seed)
    machine = mill(**{"path.slope": draw.choice(("jerk", "linear", "optimal"))})
    talk, decoded, known = Talk(machine), Talk(machine), {}
    lines, _ = program(draw)
    decoded.said.clear()
    decoded.ask("$C")
    for number, line in enumerate(lines, 1):
        decoded.send(f"N{number}{line}\n".encode())
        decoded.next()
        known[number] = decoded.ask("$G")[0].split(" T")[0], decoded.zero()
    talk.said.clear()
    waits = [f"N{number}{line}\n" for number, line in enumerate(lines, 1)]
    at, behind = 0, 0
    while waits or talk.status()["state"] != "Idle":
        if waits and talk.session.receive(waits[0].encode()):
            waits.pop(0)
        operate(talk, draw)
        talk.wait(draw.choice((1, 20, 90)))
        talk.said.clear()
        talk.send(b"\x83")
        report = talk.status()
        at = int(report.get("Ln", at))
        if report["state"].startswith(("Hold", "Door")):
            talk.send(RESUME)
        told = next(said for said in talk.said if said.startswith("[GC"))
        if report["FS"].startswith("0,") or at == 0:
            continue  # at rest the next lines may be in force
        behind += talk.zero() != known[at][1]
        if told.split(" T")[0] != known[at][0] or report.get("WCO", known[at][1]) != known[at][1]:
            raise Broken(f"line {at} {lines[at - 1]!r}: {told}, {report}, not {known[at]}")
    if behind:
        raise Broken(f"the work's zero is ahead of the tool {behind} times")


RESET_MOST = 1500  # ticks until a reset has braked from whatever, and said so


def resets(seed):
    """Reset at any moment, in a dwell and a wait too: it brakes, says so, and knows where it is."""
    draw = random.Random(seed)
    talk = Talk(mill(**{"path.slope": draw.choice(SLOPES)}))
    lines, _ = program(draw)
    rests = (f"G4P{draw.uniform(0, 90):.1f}", "M0", "M6", "$J=G91X9F500", "$C", "$SLP", "M30")
    for _ in range(3):
        lines.insert(draw.randrange(len(lines)), draw.choice(rests))
    talk.session.receive("\n".join([*lines, ""]).encode())
    for _ in range(4):
        talk.wait(draw.randint(0, 8000))
        operate(talk, draw)
        talk.said.clear()
        talk.send(RESET)
        for _ in range(RESET_MOST // 10):
            talk.wait(10)
            if any(said.startswith("Grbl 1.1") for said in talk.said):
                break
        else:
            raise Broken(f"no banner in {RESET_MOST} ticks: {talk.status()}")
        talk.said.clear()
        moving, report = talk.session.moving, talk.status()
        told = [float(word) * 1e6 for word in report["MPos"].split(",")]
        at = talk.session.joints_nm
        off = max(abs(word - nm) for word, nm in zip(told, at, strict=True))
        if report["state"] != "Idle" or off > MICRON_NM / 2 + 1e-3:
            raise Broken(f"{report} at {at}")
        talk.wait(200)
        if moving != talk.session.moving:
            raise Broken("it moves behind a reset")
        talk.check()
        talk.session.receive("\n".join([*draw.sample(lines, 9), ""]).encode())


PIECES = (
    b"G1", b"G0", b"G2", b"G91", b"G4P0", b"X1", b"Y-2.5", b"R9", b"F900", b"M3", b"S9", b"N7",
    b"$J=G91X1F900", b"$G", b"$#", b"$$", b"$I", b"$N", b"$X", b"$10=1", b"$13=1", b"$H", b"(",
    b")", b";", b"/", b"%", b"\xc3\x84", b"\xc2\x90", b"\xe2\x82\xac", b"\xff", b"\x90",
    b"\x9d", b"\xa0", b"\x84", b"\x85", b"!", b"~", b"?", b" ", b"#1=2", b"[", b"G92X0", b"M0",
    b"G54", b"\t", b"\0", b"o1 if", b"M98P1", b"e", b"$C", b"G10L2P1X0", b"M30", b"G20",
)  # fmt: skip


def noise(draw, pieces):
    """Return bytes without a reset: half of them words, the rest at random."""
    data = b""
    for _ in range(pieces):
        kind = draw.random()
        if kind < 0.6:
            data += draw.choice(PIECES)
        elif kind < 0.85:
            data += draw.choice((b"\n", b"\n", b"\r\n", b"\r"))
        else:
            data += bytes([draw.choice([k for k in range(256) if k != 0x18])])
    return data


def bytes_at_random(seed):
    """Send noise: nothing breaks, and behind a reset the machine answers as ever."""
    draw, talk = random.Random(seed), Talk()
    for _ in range(8):
        data = noise(draw, draw.randint(1, 80))
        if talk.session.receive(data) != len(data):
            raise Broken("no room for a few bytes")
        talk.wait(draw.choice((0, 3, 100, 1000)))
        talk.check()
        if draw.random() < 0.5:
            continue
        talk.send(RESET)
        talk.wait(3000)
        while talk.said and not talk.said[-1].startswith("Grbl 1.1"):
            talk.said.pop()
        if not talk.said:
            raise Broken("no banner behind a reset")
        talk.said.clear()
        if talk.ask("G21G91G1X0.5F900") != ["ok"]:
            raise Broken("no answer behind a reset")
        talk.settle(5000)
    talk.check()


BRAKE_MOST_S = 0.015  # from ! to the first tick that is slower


def brakes(seed):
    """Hold at a random moment: the tool is slower within 15 ms, and rests on its path."""
    draw = random.Random(seed)
    talk = Talk(mill(**{"path.slope": draw.choice(SLOPES)}))
    feed = draw.uniform(300, 6000)
    way = f"X{draw.uniform(60, 200):.2f}Y{draw.uniform(-80, 80):.2f}"
    talk.send(f"G21G91G1{way}F{feed:.0f}\n".encode())
    talk.wait(draw.randint(400, 600))
    before = talk.session.shown()["speed"]
    talk.send(HOLD)
    for ticks in range(1, 200):
        talk.wait(1)
        now = talk.session.shown()["speed"]
        if now < before * (1 - 1e-9):
            break
        before = now
    if ticks * 1e-3 > BRAKE_MOST_S:
        raise Broken(f"braking began {ticks} ms behind !")
    talk.wait(2000)
    if not talk.status()["state"].startswith("Hold:0"):
        raise Broken("held, and not at rest")
    talk.settle()
    talk.check()
    return ticks


def _place(draw, least, most, at):
    """Return a place that lies somewhere about the travel and where the axis stands."""
    kinds = (lambda: draw.uniform(least, most), lambda: draw.choice((least, most, at)),
             lambda: at + draw.uniform(-30, 30), lambda: draw.uniform(least - 60, most + 60),
             lambda: at + draw.choice((0.001, -0.001)))  # fmt: skip
    return round(draw.choice(kinds)(), 3)


def _may_go(least, most, at, to):
    """Return whether an axis may go straight from a place to another."""
    return least <= to <= most or most < to <= at or at <= to < least


def returns(seed):
    """Stand outside of the travel: ways nearer are taken, others not, none leads further out."""
    draw = random.Random(seed)
    talk = Talk(mill(**{"path.slope": draw.choice(("jerk", "linear", "optimal"))}))
    axes = [lib.nck_machine_of(talk.session._nck).axis[k] for k in range(3)]
    travel = [(axis.min_nm / 1e6, axis.max_nm / 1e6) for axis in axes]
    at = [_place(draw, *ends, draw.choice(ends)) for ends in travel]
    talk.said.clear()
    for line in ("$20=0", "G21G90F5000", "G53G0X{}Y{}Z{}".format(*at)):
        talk.ask(line)
    talk.settle()
    talk.ask("$20=1")
    for _ in range(12):
        named = draw.sample(range(3), draw.randint(1, 3))
        to = [_place(draw, *travel[k], at[k]) if k in named else at[k] for k in range(3)]
        words = "".join(f"{'XYZ'[k]}{to[k]:.3f}" for k in named)
        line = draw.choice(("$J=G53{}F4000", "G53G0{}", "G53G1{}", "G2{}R200"))
        may = all(_may_go(*travel[k], at[k], to[k]) for k in named)
        answer = talk.ask(line.format(words))[-1]
        if "R" not in line and answer != ("ok" if may else "error:15"):
            raise Broken(f"{line.format(words)} from {at}: {answer}")
        beyond = [(min(least, at[k]), max(most, at[k])) for k, (least, most) in enumerate(travel)]
        while talk.status()["state"] != "Idle":
            for (least, most), nm in zip(beyond, talk.session.joints_nm, strict=True):
                if not least * 1e6 - 1 <= nm <= most * 1e6 + 1:
                    raise Broken(f"{line.format(words)} from {at} leads to {nm}")
        at = [nm / 1e6 for nm in talk.session.joints_nm]
    talk.check()


SEARCHES = {"streams": streams, "jogs": jogs, "bytes": bytes_at_random, "brakes": brakes,
            "modes": modes, "resets": resets, "returns": returns}  # fmt: skip


def main(searches):
    """Try so many seeds; tell those that break something."""
    search, count = searches[sys.argv[1]], int(sys.argv[2])
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    broken = 0
    for seed in range(first, first + count):
        try:
            search(seed)
        except Broken as cause:
            broken += 1
            print(f"{sys.argv[1]} {seed}: {cause}", flush=True)
    print(f"{count} {sys.argv[1]} from {first}, {broken} broken")
    return broken > 0


if __name__ == "__main__":
    sys.exit(main(SEARCHES))
