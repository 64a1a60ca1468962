# SPDX-License-Identifier: MIT
"""``pycnc`` and ``python -m pycnc``: the command line.

An interrupt from the keyboard ends it without a word, also while its modules are still loaded.
"""

import os
import signal
import sys


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
