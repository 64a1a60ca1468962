# SPDX-License-Identifier: MIT
"""The classical S-shape over whole programs (Cao et al. 2014, section 8): acceleration is zero at
every junction, and so many blocks of look-ahead are seen. Theory and costs: ``docs/papers.md``."""

from pycnc import errors
from pycnc.kernel.bind import check, ffi, lib, pointer
from pycnc.kernel.records import join, room
from pycnc.planning.whole import Motion, Simulation, records_of

__all__ = ["SShape", "Simulation", "of_text"]

_OF_HOPS = {
    "hops": "nck_host_hop_t", "length": "double", "v_cap": "double", "a_max": "double",
    "j_max": "double", "block": "uint32_t",
}  # fmt: skip


class SShape(Motion):
    """A path planned by the classical S-shape.

    Parameters
    ----------
    segs, nodes : numpy.ndarray
        Of dtypes ``nck_seg_t`` and ``nck_node_t``, as the slope jerk has them.
    machine : Machine
    outputs : numpy.ndarray, optional
        Of dtype ``nck_output_t``: what the path hands over on its way.
    lookahead : int, optional
        Blocks with motion that are seen behind the one in work, beyond which rest is assumed; 0:
        a stop at every block. Without it as many as the machine's ``path.lookahead_blocks`` says.

    Attributes
    ----------
    hops : numpy.ndarray
        Of dtype ``nck_host_hop_t``: what is passed from one place without acceleration to the next.
    length, v_cap, a_max, j_max : numpy.ndarray
        Of every hop [mm, mm/s, mm/s², mm/s³].
    v_node, v : numpy.ndarray
        At every end of a hop, one more than there are: cap and speed [mm/s].

    Raises
    ------
    ArgumentError
        If the look-ahead is negative, or the plan does not fit into memory.
    """

    def __init__(self, segs, nodes, machine, outputs=None, *, lookahead=None):
        super().__init__(segs, machine, outputs)
        self.nodes = join("nck_node_t", [nodes])
        self._plan = plan = ffi.new("nck_host_sshape_t *")
        plan.segs, plan.seg_count = pointer("nck_seg_t", self.segs), len(self.segs)
        plan.nodes, plan.node_count = pointer("nck_node_t", self.nodes), len(self.nodes)
        plan.lookahead = min(_lookahead(machine, lookahead, len(self.nodes)), len(self.nodes))
        made = {name: self._make(name, kind, len(self.nodes)) for name, kind in _OF_HOPS.items()}
        made |= {name: self._make(name, "double", len(self.nodes) + 1) for name in ("v_node", "v")}
        check(lib.nck_host_sshape_plan(plan))
        for name, array in made.items():
            count = int(plan.hop_count) + (name not in _OF_HOPS)
            setattr(self, name, array[:count])

    def _make(self, name, kind, count):
        array = room(name, count, kind, "plan the program in parts")
        setattr(self._plan, name, pointer(kind, array))
        return array

    def _walk(self):
        walk = ffi.new("nck_host_sshape_walk_t *")
        walk.plan = self._plan
        return "nck_host_sshape_next", walk

    def __repr__(self):
        return f"<SShape: {len(self.hops):,} hops over {len(self.segs):,} segs>"


def _lookahead(machine, asked, every):
    """Return how many blocks are seen behind the one in work; `every`: all of them."""
    if asked is None:
        blocks = machine.settings.path.lookahead_blocks
        return blocks - 1 if blocks else every
    if asked < 0:
        raise errors.ArgumentError(f"lookahead is {asked}, must not be negative", id="lookahead")
    return int(asked)


def of_text(text, machine, *, lookahead=None, threads=False, progress=None):
    """Plan a whole NC text by the classical S-shape.

    Parameters
    ----------
    text : bytes
        Without errors.
    machine : Machine
        Of the slope jerk, whose budget at junctions it keeps to.
    lookahead : int, optional
        As for `SShape`.
    threads : bool
        As for `kernel.Planner`: of the exact plan alone.
    progress : callable, optional
        Called with (bytes used, bytes of the text).

    Returns
    -------
    sshape : SShape
    exact : numpy.void
        Of dtype ``nck_host_totals_t``: the same program planned by the slope jerk.
    """
    (segs, nodes, outputs), exact = records_of(
        text, machine, ("seg", "node", "output"), threads=threads, progress=progress
    )
    return SShape(segs, nodes, machine, outputs, lookahead=lookahead), exact
