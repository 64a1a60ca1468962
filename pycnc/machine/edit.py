# SPDX-License-Identifier: MIT
"""Changed values in the text of a machine file, whose comments stay where they are."""

import re
import tomllib
from decimal import Decimal

_HEAD = re.compile(r"\s*\[\s*([^\[\]]+?)\s*\]\s*(#.*)?")
_PAIR = re.compile(r"(\s*([A-Za-z0-9_-]+)\s*=\s*)(\"[^\"\\]*\"|'[^']*'|[^\s#\"'{\[]+)(\s*(#.*)?)")


def shown(value):
    """Return a value as a machine file has it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    text = f"{Decimal(value):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def put(text, values):
    """Return the text of a file with other values.

    Parameters
    ----------
    text : str
        TOML.
    values : dict
        Path to key (``axis.x.v_max_mm_s``) → Decimal, bool or str.

    Raises
    ------
    ValueError
        A key is written in a way that this does not know, and the message has the key; or the text
        is no TOML.
    """
    try:
        tomllib.loads(text)
    except tomllib.TOMLDecodeError as cause:
        raise ValueError(f"is no TOML: {cause}") from None
    for key, value in values.items():
        changed = _put_one(text, key, value)
        if _parsed(changed) != _with(_parsed(text), key, value):
            raise ValueError(f"{key}: write it as a line of its own in [{key.rpartition('.')[0]}]")
        text = changed
    return text


def _put_one(text, key, value):
    table, _, leaf = key.rpartition(".")
    lines, at, last = text.split("\n"), "", None
    for number, line in enumerate(lines):
        head, pair = _HEAD.fullmatch(line), _PAIR.fullmatch(line)
        if head:
            at = re.sub(r"\s*\.\s*", ".", head[1]).replace('"', "")
        if at == table and line.strip() and not line.lstrip().startswith("#"):
            last = number
        if at == table and pair and pair[2] == leaf:
            lines[number] = f"{pair[1]}{shown(value)}{pair[4]}"
            return "\n".join(lines)
    if last is None:
        return f"{text.rstrip()}\n\n[{table}]\n{leaf} = {shown(value)}\n"
    lines.insert(last + 1, f"{leaf} = {shown(value)}")
    return "\n".join(lines)


def _parsed(text):
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except tomllib.TOMLDecodeError:
        return None


def _with(data, key, value):
    """Return parsed data with a value, the rest of them shared."""
    first, _, rest = key.partition(".")
    if not rest:
        return data | {first: value}
    table = data.get(first, {})
    return data | {first: _with(table, rest, value) if isinstance(table, dict) else None}
