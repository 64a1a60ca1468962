# SPDX-License-Identifier: MIT
"""``python -m pycnc``: the command line."""

from pycnc.cli import main

main()
