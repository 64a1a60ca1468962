# SPDX-License-Identifier: MIT
"""bCNC in front of a served machine, by its own methods, which its buttons call.

    python bcnc.py PORT PROGRAM Y

It needs a display, and bCNC in the Python that runs it. Each step is told; the exit status is 0
where all have come about, with Y at the end of the program.
"""

import os
import sys
import time

from bCNC import __main__ as start  # finds bCNC's own modules

sys.path.insert(0, start.PRGPATH)
import Helpers  # noqa: E402, F401 - gives bCNC its words
import bmain  # noqa: E402
import Utils  # noqa: E402
from CNC import CNC  # noqa: E402

STEP_S = 60


class Operator:
    """Who stands in front of bCNC."""

    def __init__(self, port):
        Utils.iniUser = os.devnull
        self.app = bmain.Application(className="bCNC")
        self.app.open(port, 115200)

    def until(self, what, condition):
        """Let the window live until something has come about."""
        end = time.monotonic() + STEP_S
        while not condition():
            if time.monotonic() > end:
                told = {name: CNC.vars[name] for name in ("state", "mx", "my", "mz", "OvFeed")}
                raise SystemExit(f"not within {STEP_S} s: {what}: {told}")
            self.app.update()
            time.sleep(0.01)
        print(what, flush=True)

    def state(self, what, *names):
        """Wait for a state of the machine."""
        self.until(what, lambda: CNC.vars["state"].startswith(names))

    def home(self):
        """It is locked until it is homed."""
        self.state("locked", "Alarm")
        self.app.home()
        self.until("homed", lambda: CNC.vars["state"] == "Idle" and CNC.vars["mz"] > 40)

    def jog(self):
        """A jog that is cancelled by !, as bCNC's stop does."""
        self.app.mcontrol.jog("X-190")
        self.state("jogs", "Jog")
        self.app.feedHold()
        self.state("the jog is cancelled", "Idle")

    def probe(self):
        """A plate, and zeros where it is touched."""
        self.app.sendGCode("G21G90G53G0Z-38")
        self.app.sendGCode("G38.2Z-60F200")
        self.until("it touches", lambda: -40.1 < CNC.vars["prbz"] < -39.9)
        self.app.mcontrol._wcsSet("0", "0", "0")
        self.app.sendGCode("G0Z5")
        self.until("zeros are set", lambda: abs(CNC.vars["wz"] - 5) < 1e-3)

    def stream(self, program, end):
        """A program, overridden, held and gone on with."""
        self.app.load(program)
        self.app.run()
        self.state("runs", "Run")
        CNC.vars["_OvFeed"] = 120
        CNC.vars["_OvChanged"] = True
        self.until("overridden", lambda: CNC.vars["OvFeed"] == 120)
        self.app.feedHold()
        self.state("held", "Hold")
        self.app.resume()
        self.state("goes on", "Run")
        self.until("it has ended", lambda: not self.app.running and CNC.vars["state"] == "Idle"
                   and abs(CNC.vars["wy"] - end) < 1e-3)  # fmt: skip

    def reset(self):
        """A reset in motion."""
        self.app.sendGCode("G91G1X-30F600")
        self.state("runs", "Run")
        self.app.softReset()
        self.state("a reset", "Idle", "Alarm")
        self.app.unlock()
        self.state("unlocked", "Idle")


def main(port, program, end):
    """Do it all."""
    operator = Operator(port)
    operator.home()
    operator.jog()
    operator.probe()
    operator.stream(program, float(end))
    operator.reset()


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SystemExit as cause:
        print(cause, flush=True)
        os._exit(1)
    os._exit(0)  # bCNC's threads do not end
