# SPDX-License-Identifier: MIT
"""Real senders in front of a served machine: each connects, homes, jogs, probes, streams, resets.

    python tests/controller/real_senders.py cncjs

The sender is installed into build/senders by its own package manager, and its server runs there.
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

from test_serve_inputs import AXIS

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = Path(__file__).parent / "senders"
CNCJS = "cncjs@1.11.5"
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


def cncjs(folder):
    """Install and run CNCjs without its page; return the exit status of the script."""
    modules, secret, port = folder / "node_modules", folder / ".cncrc", folder / "port"
    if not (modules / "cncjs").exists():
        install = ["npm", "install", "--ignore-scripts", "--no-audit", "--no-fund", CNCJS]
        subprocess.run(install, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    (folder / "mill.toml").write_text(MACHINE, encoding="utf-8")
    home = os.environ | {"HOME": str(folder), "NODE_PATH": str(modules)}
    serve = [sys.executable, "-m", "pycnc", "serve", "-m", "mill.toml", "--pty", str(port)]
    server = [str(modules / ".bin" / "cncjs"), "--port", "8123", "--host", "127.0.0.1"]
    with (
        subprocess.Popen(serve, cwd=folder) as machine,
        subprocess.Popen(server, cwd=folder, env=home, stdout=subprocess.DEVNULL) as sender,
    ):
        try:
            _until(port.is_symlink, "a machine is there")
            words = _until(lambda: secret.exists() and secret.read_text(), "CNCjs is there")
            node = ["node", str(SCRIPTS / "cncjs.js"), "http://127.0.0.1:8123"]
            node += [json.loads(words)["secret"], str(port)]
            return subprocess.run(node, env=home).returncode
        finally:
            sender.terminate()
            machine.terminate()


def main(name):
    """Run a sender's script."""
    folder = ROOT / "build" / "senders" / name
    folder.mkdir(parents=True, exist_ok=True)
    return {"cncjs": cncjs}[name](folder)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
