# SPDX-License-Identifier: MIT
"""What a person or a script is told: traces, summaries, pictures, listings."""
