# SPDX-License-Identifier: MIT
"""``python -m pycnc.cli``."""

from pycnc.cli import main

main()
