# SPDX-License-Identifier: MIT
"""Planning without executing: whole programs, envelopes, grades; and what their numbers mean."""
