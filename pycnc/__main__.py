# SPDX-License-Identifier: MIT
"""``pycnc`` and ``python -m pycnc``: the command line.

An interrupt from the keyboard ends it without a word. While modules are loaded, before a verb and
behind it, that is the system's doing: Python would tell where it was, or lose it. Verbs hear it
themselves (`cli.door`), for they may have something to put in order.
"""

import os
import signal
import sys

if signal.getsignal(signal.SIGINT) is signal.default_int_handler:  # else it is to be ignored
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def main():
    """Enter from the console script."""
    # No verb multiplies large matrices: threads for that would only take their time to start.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # Nor does any use a plug-in of pydantic's, which takes as long to look for as to load.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    try:
        from pycnc.cli import main as enter

        enter()
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)


if __name__ == "__main__":
    main()
