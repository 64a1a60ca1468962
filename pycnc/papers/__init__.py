# SPDX-License-Identifier: MIT
"""The experiments of Cao et al. 2014 and Keinert et al. 2014: arrays, and the figures of them."""
