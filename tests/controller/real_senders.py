# SPDX-License-Identifier: MIT
"""Real senders in front of a served machine: each connects, homes, jogs, probes, streams, resets.

    python tests/controller/real_senders.py cncjs
    python tests/controller/real_senders.py bcnc     on a display that nobody sees

The sender is installed into build/senders by its own package manager, and runs there. What else it
needs comes with `make campaign`; without it the script ends with a line that names it.
"""

import contextlib
import importlib.util
import json
import math
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from test_serve_inputs import AXIS

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = Path(__file__).parent / "senders"
CNCJS, BCNC = "cncjs@1.11.5", "bCNC==0.9.16"
NEEDS = {"cncjs": {"node": "nodejs", "npm": "npm"}, "bcnc": {"xvfb-run": "xvfb", "xauth": "xauth"}}
LINES = 400
AXES = "".join(f"[axis.{letter}]\n{AXIS}" for letter in "xyz")
MACHINE = f"""[path]
slope = "jerk"
[dialect]
base = "grbl"
{AXES}
[inputs]
seek_mm_min = 3000
feed_mm_min = 600
plate_mm = -40
[inputs.x]
[inputs.y]
[inputs.z]
"""


def _until(found, words, seconds=60):
    for _ in range(seconds * 10):
        value = found()
        if value:
            return value
        time.sleep(0.1)
    raise SystemExit(f"not within {seconds} s: {words}")


@contextlib.contextmanager
def served(folder, port):
    """Serve a machine with switches at a pseudo-terminal, to which `port` leads."""
    (folder / "mill.toml").write_text(MACHINE, encoding="utf-8")
    command = [sys.executable, "-m", "pycnc", "serve", "-m", "mill.toml", "--pty", str(port)]
    with subprocess.Popen(command, cwd=folder) as machine:
        try:
            _until(port.is_symlink, "a machine is there")
            yield
        finally:
            machine.terminate()


def cncjs(folder):
    """Install and run CNCjs without its page; return the exit status of the script."""
    modules, secret, port = folder / "node_modules", folder / ".cncrc", folder / "port"
    if not (modules / "cncjs").exists():
        install = ["npm", "install", "--ignore-scripts", "--no-audit", "--no-fund", CNCJS]
        subprocess.run(install, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    home = os.environ | {"HOME": str(folder), "NODE_PATH": str(modules)}
    server = [str(modules / ".bin" / "cncjs"), "--port", "8123", "--host", "127.0.0.1"]
    with (
        served(folder, port),
        subprocess.Popen(server, cwd=folder, env=home, stdout=subprocess.DEVNULL) as sender,
    ):
        try:
            words = _until(lambda: secret.exists() and secret.read_text(), "CNCjs is there")
            node = ["node", str(SCRIPTS / "cncjs.js"), "http://127.0.0.1:8123"]
            node += [json.loads(words)["secret"], str(port)]
            return subprocess.run(node, env=home).returncode
        finally:
            sender.terminate()


def bcnc(folder):
    """Install and run bCNC on a display that nobody sees; return the script's exit status."""
    python, port, job = folder / "venv" / "bin" / "python", folder / "port", folder / "job.nc"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", folder / "venv"], check=True)
        subprocess.run([python, "-m", "pip", "install", "-q", BCNC], check=True)
    lines = [f"G1X{10 * math.cos(k / 9) - 10:.3f}Y{-k / 20:.3f}" for k in range(1, LINES + 1)]
    job.write_text("\n".join(["G21G90G94", "G1F1500", *lines, ""]), encoding="utf-8")
    with served(folder, port):
        script = [str(python), str(SCRIPTS / "bcnc.py"), str(port), str(job), str(-LINES / 20)]
        home = os.environ | {"HOME": str(folder)}
        return subprocess.run(["xvfb-run", "-a", *script], env=home).returncode


def main(name):
    """Run a sender's script."""
    missing = [package for tool, package in NEEDS[name].items() if not shutil.which(tool)]
    if name == "bcnc" and importlib.util.find_spec("tkinter") is None:
        missing.append("python3-tk")
    if missing:
        raise SystemExit(f"{name} is not tried: please install {' '.join(missing)}")
    folder = ROOT / "build" / "senders" / name
    folder.mkdir(parents=True, exist_ok=True)
    return {"cncjs": cncjs, "bcnc": bcnc}[name](folder)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
