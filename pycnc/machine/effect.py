# SPDX-License-Identifier: MIT
"""Which changes of a machine change nothing: `--set` of what this machine does not use."""

import itertools

from pycnc.machine import Machine
from pycnc.machine.control import NCKS
from pycnc.machine.schema import AXES

_DECIDING = ("path.slope", "dialect.base")  # by these it goes whether others have an effect

_JERK = {"path.j_max_mm_s3"} | {f"axis.{letter}.j_max_{unit}_s3" for letter in AXES
                                for unit in ("mm", "deg")}  # fmt: skip

_NCK_ALONE = {"path.slope", "path.lookahead_blocks"}

_PLANNED = {
    "grades": "grades are planned under the linear slope on the exact path",
    "sshape": "the S-shape is planned under the limits of the slope jerk on the exact path",
}


def idle_changes(machine, plan="exact"):
    """Yield (change as it was asked for, why it has no effect).

    Parameters
    ----------
    machine : Machine
        With its changes.
    plan : {"exact", "grades", "sshape"}
        How it is going to be planned.

    A change to what is in force already is none of these: it is as it was asked for.
    """
    asked = [(key, value) for key, value, source in machine.changes if source == "--set"]
    for place, (key, value) in enumerate(asked):
        later = [number for name, number in asked[place + 1 :] if name == key]
        reason = f"{key}={later[-1]} comes behind it" if later else idle(machine, key, plan)
        if reason:
            yield f"{key}={str(value).replace('E+', 'e')}", reason


def idle_keys(machine, axes):
    """Yield (key, why) of the settings of a grid that change nothing at any of its points.

    Parameters
    ----------
    machine : Machine
    axes : dict
        Key → values.
    """
    deciding = [key for key in _DECIDING if key in axes]
    for key, values in axes.items():
        reasons = set()
        for point in itertools.product(*(axes[each] for each in deciding)):
            settings = {key: values[0]} | dict(zip(deciding, point, strict=True))
            changed = Machine.load(machine, set=[f"{k}={v}" for k, v in settings.items()])
            reasons.add(idle(changed, key, "exact"))
        if all(reasons):
            yield key, reasons.pop()


def idle(machine, key, plan="exact"):
    """Return why a change of a key has no effect on a machine; empty if it has one."""
    settings = machine.settings
    if plan in _PLANNED and key in ("path.slope", "path.tolerance_mm"):
        return _PLANNED[plan]
    kind = settings.control.kind
    if kind not in NCKS and plan == "exact" and key in _JERK | _NCK_ALONE:
        return f"{kind} plans without it; control.kind=nck does with it"
    if key in _JERK and settings.path.slope == "linear" and plan != "sshape":
        return "the linear slope tells jerk and does not limit it; path.slope=jerk does"
    if key == "path.tolerance_mm" and kind in NCKS and plan == "exact":
        return _unheeded(settings.path)
    return _unread(settings, key)


def _unheeded(path):
    """Return why nothing is smoothed within a tolerance; empty if there is none, or all is."""
    if path.slope == "optimal" or path.tolerance_mm == 0:
        return ""
    return f"under the slope {path.slope} the path is exact; path.slope=optimal smooths"


def _unread(settings, key):
    """Return why nobody reads a key of such a machine; empty if somebody does."""
    if key == "dialect.system" and settings.dialect.base not in ("fanuc", "auto"):
        return f"only dialect.base=fanuc has it (is {settings.dialect.base})"
    return "only lists of machines show it" if key == "description" else ""
