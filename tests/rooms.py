# SPDX-License-Identifier: MIT
"""How long `make room` takes after an edit of one file, and whether it tells a planted fault.

    .venv/bin/python tests/rooms.py            every room
    .venv/bin/python tests/rooms.py tick host  these

In every room one file is touched, and its tests must pass; then one fault is planted in it, and
they must fail. The file is put back, whatever happens. Prints a table; the exit status is the
number of rooms that are too slow or do not tell. Run it on a quiet computer.
"""

import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
MOST_S = 20.0


class Fault(NamedTuple):
    """What a careless hand makes of a line."""

    file: str
    was: str
    now: str


FAULTS = {
    "house": Fault("csrc/nck/base/status.c", "// SPDX-License-Identifier: MIT", "// Status."),
    "base": Fault("csrc/nck/base/link.c", "return NCK_CELL_MAX - used;",
                  "return NCK_CELL_MAX + 1 - used;"),
    "decode": Fault("csrc/nck/prep/1_decode/number/number.c", "    out->negative = *at == '-';",
                    "    out->negative = *at == '+';"),
    "toolcomp": Fault("csrc/nck/prep/2_toolcomp/shape.c",
                      "{ return self->sweep < 0.0 ? -1.0 : 1.0; }",
                      "{ return self->sweep < 0.0 ? 1.0 : -1.0; }"),
    "smooth": Fault("csrc/nck/prep/3_smooth/control.c", "3.0 * nck_spline_moment(t)",
                    "2.0 * nck_spline_moment(t)"),
    "lookahead": Fault("csrc/nck/prep/4_lookahead/limit_math.h",
                       "{ return x_lim / nck_fabs(c); }", "{ return 1.1 * x_lim / nck_fabs(c); }"),
    "slope": Fault("csrc/nck/prep/5_slope/ramp_math.h", "    return (vv1 - vv0) / (2.0 * length);",
                   "    return (vv1 - vv0) / (1.9 * length);"),
    "tick": Fault("csrc/nck/tick/7_transform/transform.c", "    if (rest > 0.5) return n + 1;",
                  "    if (rest > 0.5) return n;"),
    "kernel": Fault("csrc/nck/nck.c", "    if (nck_link_owner(&nck->link) == NCK_LINK_PREP) "
                    "return 1;\n", "    if (nck_link_owner(&nck->link) == NCK_LINK_PREP) "
                    "return 0;\n"),
    "host": Fault("csrc/host/grade_math.h", "    return nck_sqrt(v * v + step);",
                  "    return nck_sqrt(v * v + 1.1 * step);"),
    "opencl": Fault("opencl/envelope.cl", "    return known ? 0 : DOUBT_OVERLAP;",
                    "    return known ? DOUBT_OVERLAP : 0;"),
    "machine": Fault("pycnc/machine/effect.py", "    return \"\"\n", "    return \"none\"\n"),
    "cli": Fault("pycnc/cli/timing.py", '_TIMES = ("cut", "rapid",', '_TIMES = ("rapid", "cut",'),
    "report": Fault("pycnc/report/page.py", '.replace("<", "\\\\u003c")', ""),
    "controller": Fault("firmware_sim/app/number.c", "return letter - 'a' + 10;",
                        "return letter - 'a' + 9;"),
    "linuxcnc": Fault("adapters/linuxcnc/bounds.c", "    return sqrt(sum);", "    return sum;"),
    "package": Fault("cmake/amalgamate.py", "#undef {name}", "#undef X{name}"),
}  # fmt: skip


def run_room(room):
    """Return (whether the room's tests pass, seconds)."""
    began = time.monotonic()
    done = subprocess.run(["make", "room", f"R={room}"], cwd=ROOT, capture_output=True)
    return done.returncode == 0, time.monotonic() - began


@contextmanager
def kept(path):
    """Put a file back as it was."""
    text = path.read_text(encoding="utf-8")
    try:
        yield text
    finally:
        path.write_text(text, encoding="utf-8")


def try_room(room):
    """Return (passes after an edit, seconds, tells the fault, seconds)."""
    fault = FAULTS[room]
    path = ROOT / fault.file
    with kept(path) as text:
        if text.count(fault.was) != 1:
            raise SystemExit(f"{fault.file} has no line that can be spoilt so: {fault.was}")
        path.write_text(text + "\n", encoding="utf-8")
        good, edit_s = run_room(room)
        path.write_text(text.replace(fault.was, fault.now), encoding="utf-8")
        silent, fault_s = run_room(room)
    return good, edit_s, not silent, fault_s


def main():
    """Try rooms; print the table."""
    failed = 0
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # not without putting the file back
    print("| room | after an edit s | a fault in | told | after s |\n|---|---:|---|---|---:|")
    for room in sys.argv[1:] or FAULTS:
        run_room(room)  # what is built the first time
        good, edit_s, told, fault_s = try_room(room)
        failed += not (good and told and max(edit_s, fault_s) <= MOST_S)
        passes = f"{edit_s:.0f}" if good else "FAILS"
        said = "yes" if told else "NO"
        print(f"| {room} | {passes} | `{FAULTS[room].file}` | {said} | {fault_s:.0f} |", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
