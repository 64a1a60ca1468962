# SPDX-License-Identifier: MIT
"""What stands in for LinuxCNC's screen in a run without one: homes, runs a program, ends.

A copy of it runs in LinuxCNC's Python, as the DISPLAY of the INI file that live.py writes.
"""

import json
import os
import subprocess
import sys
import time

import linuxcnc

POLL_S = 0.01
SETTLE_S = 0.3
REST_S = 20.0  # by then the axes rest, whatever they did

command, status, messages = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def told():
    """Pass LinuxCNC's messages on."""
    while message := messages.poll():
        print("message:", message[1].strip(), file=sys.stderr, flush=True)


def until(holds, limit_s):
    """Wait; return whether it came to hold in time."""
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        status.poll()
        told()
        if holds():
            return True
        time.sleep(POLL_S)
    return False


def is_idle():
    """Return whether the program has ended, or was refused, and the axes are at rest."""
    done = status.state in (linuxcnc.RCS_DONE, linuxcnc.RCS_ERROR) and status.inpos
    return status.interp_state == linuxcnc.INTERP_IDLE and done


def hal(*words):
    """Give a command to HAL."""
    subprocess.run(["halcmd", *words], check=True)


def switch_on():
    """Machine on, homed, in automatic mode."""
    for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
        command.state(state)
        command.wait_complete()
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete()
    command.teleop_enable(0)
    command.wait_complete()
    command.home(-1)
    until(lambda: all(status.homed[: status.joints]), 10)
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete()


def set_mode(mode):
    """Change the mode of operation, where the axes are at rest."""
    until(lambda: status.inpos, REST_S)
    command.mode(mode)
    command.wait_complete()


def run():
    """Begin the program."""
    set_mode(linuxcnc.MODE_MANUAL)
    command.teleop_enable(0)
    command.wait_complete()
    set_mode(linuxcnc.MODE_AUTO)
    command.auto(linuxcnc.AUTO_RUN, 0)


def mdi(text):
    """Execute a block."""
    set_mode(linuxcnc.MODE_MDI)
    command.mdi(text)
    if not until(is_idle, REST_S):
        print("late: MDI", file=sys.stderr, flush=True)


def jog(axis, velocity, for_s):
    """Jog an axis, and let it rest."""
    set_mode(linuxcnc.MODE_MANUAL)
    command.teleop_enable(1)
    command.wait_complete()
    command.jog(linuxcnc.JOG_CONTINUOUS, False, axis, velocity)
    time.sleep(for_s)
    command.jog(linuxcnc.JOG_STOP, False, axis)
    time.sleep(SETTLE_S)


def abort():
    """Abort, and wait for the rest."""
    command.abort()
    if not until(lambda: status.inpos and status.interp_state == linuxcnc.INTERP_IDLE, REST_S):
        print("late: abort", file=sys.stderr, flush=True)


WORDS = {
    "hold": lambda: hal("sets", "hold", "1"),
    "go on": lambda: hal("sets", "hold", "0"),
    "mark": lambda: hal("sets", "mark", "1"),
    "set": lambda pin, value: hal("setp", pin, value),
    "show": lambda pins: hal("show", "pin", pins),
    "pause": lambda: command.auto(linuxcnc.AUTO_PAUSE),
    "resume": lambda: command.auto(linuxcnc.AUTO_RESUME),
    "step": lambda: command.auto(linuxcnc.AUTO_STEP),
    "override": lambda share: command.feedrate(share),
    "rapids": lambda share: command.rapidrate(share),
    "abort": abort, "mdi": mdi, "jog": jog, "run": run,
}  # fmt: skip


def main():
    """Run what LIVE says."""
    asked = json.loads(os.environ["LIVE"])
    switch_on()
    with open(asked["log"], "w", encoding="ascii") as log:
        sampler = subprocess.Popen(["halsampler", "-t"], stdout=log)
        hal("setp", "sampler.0.enable", "1")
        command.program_open(asked["program"])
        command.wait_complete()
        command.auto(linuxcnc.AUTO_RUN, 0)
        time.sleep(SETTLE_S)
        for after_s, word, *given in asked["script"]:
            time.sleep(after_s)
            WORDS[word](*given)
        done = until(is_idle, asked["limit_s"])
        time.sleep(SETTLE_S)
        told()
        hal("setp", "sampler.0.enable", "0")
        time.sleep(SETTLE_S)
        sampler.terminate()
        sampler.wait()
    refused = status.state == linuxcnc.RCS_ERROR
    print("end" if done and not refused else "late", file=sys.stderr, flush=True)


main()
