# SPDX-License-Identifier: MIT
"""Tables of a file: what each key takes, its default and its meaning.

    what the file says ─▶ Table.take ─▶ settings, and everything that is wrong at once

A kind of value has ``take(value, key, problems)``: it returns the value as settings have it, and
adds (path to key, what is wrong) to the problems. ``words()`` tells what it takes.
"""

import difflib
import re
from decimal import Decimal

REQUIRED = object()  # the default of a key that must be there


def plain(number):
    """Return a number without an exponent."""
    return f"{Decimal(number):f}"


def _outside(number, low, high):
    """Return what is wrong with a number that has a range; high None: no upper end."""
    if number < low:
        return f"must be {plain(low)} at least"
    if high is not None and number > high:
        return f"must be {plain(high)} at most"
    return ""


class Number:
    """An exact number within a range; free: or the word "free", which settings have as None."""

    def __init__(self, low, high, free=False):
        self.low, self.high, self._free = low, high, free

    def take(self, value, key, problems):
        """Return the number as a Decimal."""
        if self._free and value in (None, "free"):
            return None
        if isinstance(value, bool) or not isinstance(value, int | float | Decimal):
            problems.append((key, f"must be a number (is {value!r})"))
            return None
        number = Decimal(str(value)) if isinstance(value, float) else Decimal(value)
        wrong = (
            _outside(number, self.low, self.high)
            if number.is_finite()
            else "must be a finite number"
        )
        if wrong:
            problems.append((key, f"{wrong} (is {value})"))
        return number

    def words(self):
        """Return what it takes."""
        return "number"


class Whole:
    """A whole number within a range."""

    def __init__(self, low, high=None):
        self.low, self.high = low, high

    def take(self, value, key, problems):
        """Return the number."""
        wrong = (
            "must be a whole number" if type(value) is not int
            else _outside(value, self.low, self.high)
        )  # fmt: skip
        if wrong:
            problems.append((key, f"{wrong} (is {value})"))
        return value

    def words(self):
        """Return what it takes."""
        return "whole number"


class Choice:
    """One of several words or numbers."""

    def __init__(self, *options):
        self.options = options

    def take(self, value, key, problems):
        """Return the word or number."""
        if not any(type(value) is type(option) and value == option for option in self.options):
            *first, last = map(repr, self.options)
            problems.append((key, f"must be {', '.join(first)} or {last} (is {value!r})"))
        return value

    def words(self):
        """Return what it takes."""
        return ", ".join(f"`{option}`" for option in self.options)


class Plain:
    """A value of one of Python's types, as it is; words: what it takes."""

    def __init__(self, type_, words, wrong):
        self._type, self._words, self._wrong = type_, words, wrong

    def take(self, value, key, problems):
        """Return the value."""
        if type(value) is not self._type:
            problems.append((key, f"{self._wrong} (is {value!r})"))
        return value

    def words(self):
        """Return what it takes."""
        return self._words


FLAG = Plain(bool, "true, false", "must be true or false")
TEXT = Plain(str, "text", "must be text")


class Numbered:
    """Tables of one kind, each under its number."""

    def __init__(self, table):
        self._table = table

    def take(self, value, key, problems):
        """Return name → table."""
        if not isinstance(value, dict):
            problems.append((key, "must be a table"))
            return {}
        return {
            name: self._table.take(each, f"{key}.{name}", problems) for name, each in value.items()
        }

    def words(self):
        """Return what it takes."""
        return "tables"


class Key:
    """A key of a table.

    Parameters
    ----------
    kind : Number, Whole, Choice, Plain, Numbered or a class of tables
        What it takes.
    default : optional
        Without it the key must be there. None: it may be absent.
    description : str
        One or two sentences for people.
    """

    def __init__(self, kind, default=REQUIRED, *, description):
        self.kind, self.default, self.description = kind, default, description

    @property
    def is_required(self):
        """Whether the key must be there."""
        return self.default is REQUIRED


class Table:
    """A table of the file: a class attribute is a `Key`, an instance has the values.

    Attributes
    ----------
    KEYS : dict
        Name → key, in the order of the description.
    """

    KEYS = {}  # noqa: RUF012

    def __init_subclass__(cls):
        own = {name: key for name, key in vars(cls).items() if isinstance(key, Key)}
        cls.KEYS = cls.KEYS | own

    def __init__(self, **values):
        defaults = {name: key.default for name, key in self.KEYS.items()}
        self.__dict__.update(defaults | values)

    def __setattr__(self, name, value):
        raise AttributeError(f"settings do not change: {name}")

    def __eq__(self, other):
        return type(self) is type(other) and vars(self) == vars(other)

    def __repr__(self):
        values = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.KEYS)
        return f"{type(self).__name__}({values})"

    @classmethod
    def take(cls, value, key, problems):
        """Return the table of what a file says; None if something in it is wrong."""
        if not isinstance(value, dict):
            problems.append((key, "must be a table"))
            return None
        before, found, known = f"{key}." if key else "", len(problems), {}
        for name, each in cls.KEYS.items():
            if name not in value:
                if each.is_required:
                    problems.append((before + name, "is missing"))
            elif value[name] is None and each.default is None:
                known[name] = None
            else:
                known[name] = each.kind.take(value[name], before + name, problems)
        problems += [(before + name, cls._unknown(name)) for name in value if name not in cls.KEYS]
        if len(problems) > found:
            return None
        table = cls(**known)
        if wrong := table.wrong():
            problems.append((key, wrong))
        return table

    @classmethod
    def _unknown(cls, name):
        """Say which keys there are, the nearest alone if one is near."""
        allowed = {_bare(each): each for each in cls.KEYS}
        near = difflib.get_close_matches(_bare(name), allowed, n=1, cutoff=0.7)
        if near:
            return f"unknown key; did you mean {allowed[near[0]]}?"
        return f"unknown key; allowed: {', '.join(allowed.values())}"

    @classmethod
    def words(cls):
        """Return what it takes."""
        return "table"

    def wrong(self):
        """Return what is wrong with the table as a whole; empty if nothing is."""
        return ""

    def as_dict(self):
        """Return name → value, tables as dicts."""
        return {name: _as_dict(getattr(self, name)) for name in self.KEYS}


def _as_dict(value):
    if isinstance(value, Table):
        return value.as_dict()
    if isinstance(value, dict):
        return {name: _as_dict(each) for name, each in value.items()}
    return value


def _bare(key):
    """Return a key without its unit and its underscores: amax is a_max_mm_s2."""
    return re.sub(r"_(mm|deg|ms)(_.*)?$", "", key).replace("_", "").lower()
