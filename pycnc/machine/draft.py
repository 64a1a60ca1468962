# SPDX-License-Identifier: MIT
"""A machine file that is being written: values with a comment each, in the order of the schema."""

import re
from decimal import Decimal

from pycnc.machine.control import NCKS
from pycnc.machine.quantity import TRAVEL_LIMIT
from pycnc.machine.schema import (
    AXES, Approach, Dialect, Kernel, Kinematics, LinearAxis, MachineFile, Path, RotaryAxis, Spindle,
    Times, position_key, unit_of,
)  # fmt: skip

JERK_RISE_S = Decimal("0.05")  # where nobody says: so long until the highest acceleration
OWN_DEFAULT = "not in the source: the control's own default"
_OF_LINE = re.compile(r"(\S+ )?line \d+: ")  # a comment that quotes one
_WIDTH = 98
_PLACES = ("start", "home.g28", "home.g30")
_DIGITS = 20  # before the point; six behind it are kept


class Draft:
    """Settings of a machine file.

    Attributes
    ----------
    values : dict
        Path to key → (value, comment).
    left : list of str
        What the source has that a machine file has no equal for, with its place.
    rest : list of str
        The same, as far as it does not look as if it had to do with motion.
    problems : list of (str, str)
        Key, and what is missing or wrong.
    """

    def __init__(self, description=""):
        self.values, self.left, self.rest, self.problems = {}, [], [], []
        if description:
            self.put("description", description)

    def put(self, key, value, comment=""):
        """Set a value; an earlier one of the key is replaced."""
        self.values[key] = (value, comment)

    def axis(self, letter, quantity, value, comment=""):
        """Set a limit of an axis: v_max, rapid, a_max, j_max, min or max [mm, deg, s]."""
        ends = {"v_max": "_s", "rapid": "_s", "a_max": "_s2", "j_max": "_s3"}
        key = f"axis.{letter}.{quantity}_{unit_of(letter)}{ends.get(quantity, '')}"
        is_free = quantity in ("min", "max") and abs(value) > TRAVEL_LIMIT
        self.put(key, "free" if is_free else value, comment)

    def homes(self, letter, place, comment):
        """Say where an axis stands once it is homed, if that is within its travel."""
        low, high = (self.limit(letter, end) for end in ("min", "max"))
        if (low is None or low <= place) and (high is None or place <= high):
            self.put(f"home.g28.{position_key(letter)}", place, comment)

    def limit(self, letter, quantity):
        """Return a limit of an axis; None if it is not set."""
        found = (
            value for key, (value, _) in self.values.items()
            if key.startswith(f"axis.{letter}.{quantity}_")
        )  # fmt: skip
        value = next(found, None)
        return None if value == "free" else value

    def complete(self, letters):
        """Fill in what follows: jerk, and a start within the travel. Tell what is missing."""
        is_read = not self.problems  # else what is missing may be what cannot be read
        for letter in letters:
            for quantity in ("v_max", "a_max"):
                if is_read and self.limit(letter, quantity) is None:
                    self.problems.append((f"axis.{letter}", f"no {quantity} for it in the file"))
            a_max = self.limit(letter, "a_max")
            if a_max is not None and self.limit(letter, "j_max") is None:
                rise = f"not in the source: all acceleration within {JERK_RISE_S} s"
                if self.values.get("control.kind", ("nck", ""))[0] not in NCKS:
                    rise += "; asked for where control.kind is nck"
                self.axis(letter, "j_max", (a_max if a_max > 0 else 1) / JERK_RISE_S, rise)
            self._stand_within(letter)

    def _stand_within(self, letter):
        low, high = (self.limit(letter, end) for end in ("min", "max"))
        place = 0 if high is None else min(high, 0)
        place = place if low is None else max(low, place)
        if place != 0:
            for key in (f"{table}.{position_key(letter)}" for table in _PLACES):
                self.values.setdefault(key, (place, "0 is outside of the travel"))

    def sourced(self, problems):
        """Return problems of keys, with what the values were made of; of each line the first.

        What is in no line follows from what is: it is told where nothing else is.
        """
        told, follows, lines = [], [], set()
        for key, words in problems:
            comment = self.values.get(key, ("", ""))[1]
            line = _OF_LINE.match(comment)
            row = key, f"{words}; {comment}" if comment else words
            if comment and line is None:
                follows.append(row)
            elif line is None or line[0] not in lines:
                told.append(row)
            lines.add(line and line[0])
        return told or follows

    def text(self, head=()):
        """Return the machine file; head: comment lines at its top."""
        lines = [f"# {line}".rstrip() for line in head]
        top = [key for key in self.values if "." not in key]
        lines += [_line(key, *self.values[key]) for key in top]
        for table in _tables(self.values):
            lines += ["", f"[{table}]"]
            keys = [key for key in self.values if key.rpartition(".")[0] == table]
            keys.sort(key=_rank)
            lines += [_line(key.rpartition(".")[2], *self.values[key]) for key in keys]
        for title, rows in (
            ("Without an equal here", self.left), ("Not about the motion of axes", self.rest),
        ):  # fmt: skip
            if rows:
                lines += ["", f"# {title}:", *(f"#   {row}" for row in rows)]
        return "\n".join([*lines, ""])


def _tables(values):
    """Return the tables that values are in, in the order of the description."""
    found = list(dict.fromkeys(key.rpartition(".")[0] for key in values if "." in key))
    order = list(MachineFile.model_fields)
    axes = list(AXES)

    def place(table):
        first, _, rest = table.partition(".")
        return order.index(first), axes.index(rest) if rest in axes else len(axes), rest

    return sorted(found, key=place)


def _rank(key):
    """Return where a key of an axis stands; the others stay in their order."""
    names = list(LinearAxis.model_fields)
    leaf = key.rpartition(".")[2].replace("deg", "mm")
    return names.index(leaf) if leaf in names else 0


def _line(key, value, comment):
    told = f"{key} = {_toml(value)}"
    return f"{told} # {comment}" if comment else told


def _toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{"".join(c if c.isprintable() else " " for c in escaped)}"'
    number = Decimal(value)
    if number.adjusted() > _DIGITS:  # out of every range, as is told of it later
        return f"{number:e}"
    rounded = number.quantize(Decimal("1e-6")).normalize()
    return f"{rounded:f}"


def commented(letters, limits, dialect, description):
    """Return a whole machine file to begin with: every key with its meaning, defaults commented.

    Parameters
    ----------
    letters : str
        Axes, such as "xyz".
    limits : dict
        v_max [mm/s or deg/s], a_max, j_max, and ``travel``: letter → (min, max).
    dialect : str
    description : str
        One line for people.
    """
    draft = Draft()
    draft.put("description", description)
    for letter in letters:
        for quantity in ("v_max", "a_max", "j_max"):
            draft.axis(letter, quantity, limits[quantity])
        for end, value in zip(("min", "max"), limits["travel"].get(letter, ()), strict=False):
            draft.axis(letter, end, value)
    draft.put("dialect.base", dialect)
    if sorted(letters) == ["x", "z"]:
        draft.put("kinematics.type", "lathe_xz")
        draft.put("dialect.diameter", True)
        draft.put("dialect.plane", 18)
    draft.complete(letters)
    return "\n".join(_pages(draft, letters))


def _pages(draft, letters):
    yield "# A machine file: docs/machine.md has all keys. Lines that begin with # are defaults."
    yield f"{_line('description', *draft.values['description'])}  # one line for people"
    tables = [("kernel", Kernel), ("path", Path)]
    tables += [(f"axis.{letter}", RotaryAxis if unit_of(letter) == "deg"
                else LinearAxis) for letter in letters]  # fmt: skip
    tables += [("kinematics", Kinematics), ("spindle", Spindle),
               ("times", Times), ("dialect", Dialect),
               ("approach", Approach)]  # fmt: skip
    for name, table in tables:
        yield from ("", f"[{name}]")
        for key, field in table.model_fields.items():
            yield from _explained(draft, f"{name}.{key}", field)
    for table in _tables(draft.values):
        if table.startswith(("start", "home")):
            yield from ("", f"[{table}]")
            keys = (key for key in draft.values if key.rpartition(".")[0] == table)
            yield from (_line(key.rpartition(".")[2], *draft.values[key]) for key in keys)
    yield ""


def _explained(draft, path, field):
    """Yield the meaning of a key, and its value, or its default as a comment."""
    key = path.rpartition(".")[2]
    words, line = field.description.split(), "#"
    for word in words:
        if len(line) + 1 + len(word) > _WIDTH:
            yield line
            line = "#"
        line += f" {word}"
    yield line
    if path in draft.values:
        yield _line(key, *draft.values[path])
    elif field.default is None or field.is_required():
        yield f"# {key} ="
    else:
        yield f"# {_line(key, field.default, '')}"
