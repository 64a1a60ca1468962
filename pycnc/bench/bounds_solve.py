# SPDX-License-Identifier: MIT
"""What both bounds share: the limits, a motion that was found, and the problem handed to IPOPT.

IPOPT (Wächter and Biegler, "On the implementation of an interior-point filter line-search algorithm
for large-scale nonlinear programming", Mathematical Programming 106, 2006) finds a motion that no
small change makes faster. That is a local optimum: another motion may be faster still.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pycnc import extras

SAMPLE_S = 1e-3  # between the places that a found motion is checked at: what a drive sees
EXACT = 1e3  # what joins pieces weighs more than limits: its errors add up along the motion
OPTIONS = {
    "print_time": False,
    "ipopt.print_level": 0,
    "ipopt.sb": "yes",  # no banner
    "ipopt.tol": 1e-7,
    "ipopt.constr_viol_tol": 1e-9,
    "ipopt.max_iter": 600,
    "ipopt.mu_init": 1e-3,  # begin near the motion that is given
    "ipopt.bound_push": 1e-4,
    "ipopt.bound_frac": 1e-4,
}


@dataclass
class Limits:
    """Of every axis: v [mm/s], a [mm/s²], j [mm/s³], each (D,); `feed`: of the tool [mm/s]."""

    v: np.ndarray
    a: np.ndarray
    j: np.ndarray
    feed: float


@dataclass
class Seen:
    """A motion that is known: where the search begins.

    Attributes
    ----------
    t : numpy.ndarray
        (m,) times [s], from 0 to the end.
    s : numpy.ndarray
        (m,) path coordinate [mm].
    places : numpy.ndarray
        (m, D) places [mm].
    corners_s : numpy.ndarray
        When it passes each of the program's points [s].
    """

    t: np.ndarray
    s: np.ndarray
    places: np.ndarray
    corners_s: np.ndarray


@dataclass
class Motion:
    """A motion that was found: its time [s], the place at any times, and what IPOPT says of it."""

    time_s: float
    places: Callable
    status: str

    @property
    def is_solved(self):
        """Whether IPOPT found an optimum."""
        return self.status in ("Solve_Succeeded", "Solved_To_Acceptable_Level")


def shares(motion, limits):
    """Return the largest share of v, a and j that a motion takes, by its samples' differences.

    A difference is a mean of the derivative, so it never tells more than there is.

    Parameters
    ----------
    motion : Motion
    limits : Limits

    Returns
    -------
    tuple of float
        Of v (an axis or the feed), a and j; 1 is at the limit.
    """
    count = max(8, int(np.ceil(motion.time_s / SAMPLE_S)))
    step = motion.time_s / count
    places = motion.places(np.linspace(0, motion.time_s, count + 1))
    rest = np.ones((3, 1))
    places = np.concatenate([rest * places[0], places, rest * places[-1]])
    found, change = [], places
    for limit in (limits.v, limits.a, limits.j):
        change = np.diff(change, axis=0) / step
        found.append(float(np.max(np.abs(change) / limit)))
    speed = np.linalg.norm(np.diff(places, axis=0), axis=1).max() / step
    return max(found[0], float(speed / limits.feed)), found[1], found[2]


def stretched(motion, limits):
    """Return the time of a motion slowed down throughout until it keeps every limit [s].

    Between its nodes a found motion may pass a limit by a little. At 1/k of the speed v, a and j
    are 1/k, 1/k² and 1/k³.
    """
    v, a, j = shares(motion, limits)
    return motion.time_s * max(1.0, v, a ** (1 / 2), j ** (1 / 3))


def states(h, j):
    """Return q, v and a, each (n, …), at the begin of pieces of constant jerk, from rest at 0.

    h : (n,) durations [s]; j : (n, …) jerk.
    """
    x = h.reshape(-1, *[1] * (j.ndim - 1))

    def sums(change):
        return np.cumsum(np.concatenate([0 * change[:1], change]), axis=0)[:-1]

    a = sums(j * x)
    v = sums(x * (a + j * x / 2))
    return sums(x * (v + x * (a / 2 + x * j / 6))), v, a


class Problem:
    """Unknowns and what must hold of them, gathered piece by piece."""

    def __init__(self):
        self.ca = extras.need("casadi")
        self._unknown, self._guess, self._range = [], [], []
        self._held, self._bounds = [], []

    def unknown(self, guess, low, high):
        """Return as many unknowns as there are guesses, in columns.

        guess : (n, k); low, high : anything that broadcasts to it. A unit near 1 is good.
        """
        guess = np.asarray(guess, float)
        some = self.ca.SX.sym("x", *guess.shape)
        low, high = (np.broadcast_to(np.asarray(x, float), guess.shape) for x in (low, high))
        self._unknown.append(self.ca.vec(some))
        self._guess.append(np.clip(guess, low, high).flatten("F"))
        self._range.append((low.flatten("F"), high.flatten("F")))
        return some

    def hold(self, terms, low, high):
        """Keep each of some terms between two bounds."""
        terms = self.ca.vec(terms)
        self._held.append(terms)
        self._bounds.append([np.broadcast_to(float(x), terms.shape[0]) for x in (low, high)])

    def solve(self, cost, wanted):
        """Return the values of `wanted` where `cost` is least, and IPOPT's word for how it ended.

        Returns
        -------
        values : list of numpy.ndarray
        status : str
        """
        unknown = self.ca.vertcat(*self._unknown)
        solver = self.ca.nlpsol(
            "bound", "ipopt", {"x": unknown, "f": cost, "g": self.ca.vertcat(*self._held)}, OPTIONS
        )
        low, high = (np.concatenate(each) for each in zip(*self._range, strict=True))
        least, most = (np.concatenate(each) for each in zip(*self._bounds, strict=True))
        found = solver(
            x0=np.concatenate(self._guess), lbx=low, ubx=high, lbg=least, ubg=most
        )["x"]
        values = self.ca.Function("values", [unknown], wanted)(found)
        values = values if isinstance(values, list | tuple) else [values]
        return [np.array(each) for each in values], solver.stats()["return_status"]
