# SPDX-License-Identifier: MIT
"""What a machine file is measured in: tables without unknown keys, numbers within their ranges."""

from datetime import datetime
from decimal import Decimal
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, Strict

from pycnc.kernel.records import quantity_range

TRAVEL_LIMIT = 1_000_000  # mm or degrees: a position beyond a kilometre is a mistake


def number(value):
    """Let numbers pass and nothing that only looks like one."""
    if isinstance(value, bool) or not isinstance(value, int | float | Decimal):
        raise ValueError("must be a number")
    return value


def _travel(value):
    return None if value is None or value == "free" else number(value)


def _digits(value):
    """Let digits pass, as text or as a whole number."""
    text = str(value) if isinstance(value, str | int) and not isinstance(value, bool) else ""
    if not isinstance(value, str | int) or not set(text) <= set("123456789"):
        raise ValueError("must be digits 1 to 9, as in 25")
    return text


def _clock(value):
    """Let a date and a time of day pass, as text or as TOML has them."""
    if value is None:
        return None
    try:
        when = value if isinstance(value, datetime) else datetime.fromisoformat(value)
    except (TypeError, ValueError):
        when = None
    if when is None or when.tzinfo is not None:
        raise ValueError("must be a date and a time of day, as in 2030-12-31 23:59:59")
    return when.isoformat(" ", "seconds")


Number = Annotated[Decimal, Strict(False)]


def within(quantity, units=1):
    """Return the type of a number with the kernel's range; units: the file's in one of its."""
    low, high = ((end * units).normalize() for end in quantity_range(quantity))
    return Annotated[Number, Field(ge=low, le=high), BeforeValidator(number)]


Period = within("period", 1000)
Speed = within("speed")
SpeedPerMinute = within("speed", 60)
Acceleration = within("acceleration")
Jerk = within("jerk")
Error = within("error")
Size = within("size")
Feed = within("feed")
Rotation = within("rotation")
Leads = Annotated[Number, Field(ge=0, le=10), BeforeValidator(number)]
Unit = Annotated[Number, Field(ge=0, le=1), BeforeValidator(number)]
Seconds = Annotated[Number, Field(ge=0, le=3600), BeforeValidator(number)]
Coordinate = Annotated[Number, Field(ge=-TRAVEL_LIMIT, le=TRAVEL_LIMIT), BeforeValidator(number)]
Switches = Annotated[str, BeforeValidator(_digits)]
Clock = Annotated[str | None, BeforeValidator(_clock)]
Travel = Annotated[
    Annotated[Number, Field(ge=-TRAVEL_LIMIT, le=TRAVEL_LIMIT)] | None, BeforeValidator(_travel)
]


class Table(BaseModel):
    """A table of the file: keys it does not know are errors, numbers are finite."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)
