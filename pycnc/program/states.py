# SPDX-License-Identifier: MIT
"""What Klipper's SAVE_GCODE_STATE keeps and RESTORE_GCODE_STATE brings back, as plain words."""

import re

RESTORE = "RESTORE_GCODE_STATE"
_WORDS = re.compile(
    rb"(?im)^[ \t]*(?:(?P<way>G9[01])(?![\d.])|(?P<flow>M8[23])(?![\d.])"
    rb"|G[0-3](?![\d.])[^\n;]*?F[ \t]*(?P<feed>\d+\.?\d*)"
    rb"|(?P<verb>SAVE|RESTORE)_GCODE_STATE\b(?P<more>[^\n;]*))"
)
_NAME = re.compile(rb"(?i)\bNAME[ \t]*=[ \t]*(\S+)")
_MOVES = re.compile(rb"(?i)\bMOVE[ \t]*=[ \t]*[^0 \t]")
_BEGIN = {"way": b"G90", "flow": b"M82", "feed": b"1500"}  # as Klipper begins


def restored(text):
    """Return (text, places) with plain words for what RESTORE_GCODE_STATE brings back.

    Each stands in its line's place, as long as it was; places are those of the lines. One that
    moves, that was never saved or that needs two lines stays as it is.
    """
    if RESTORE.encode() not in text.upper():
        return text, []
    now, kept, places, parts, end = dict(_BEGIN), {}, [], [], 0
    for match in _WORDS.finditer(text):
        verb = (match["verb"] or b"").upper()
        if not verb:
            now |= {name: match[name].upper() for name in now if match[name]}
            continue
        name = _NAME.search(match["more"])
        name = name[1] if name else b"default"
        if verb == b"SAVE":
            kept[name] = dict(now)
            continue
        words = _words(now, kept.get(name), match["more"])
        if words is None or len(words) > len(match[0]):
            continue
        now = dict(kept[name])
        places.append(match.start())
        parts += [text[end : match.start()], words.ljust(len(match[0]))]
        end = match.end()
    return b"".join([*parts, text[end:]]), places


def _words(now, kept, more):
    """Return what brings a state back in one line; None: nothing does."""
    if kept is None or _MOVES.search(more):
        return None
    changed = {name: kept[name] for name in kept if kept[name] != now[name]}
    if "flow" in changed:
        return changed["flow"] if len(changed) == 1 else None
    feed = b"F" + changed["feed"] if "feed" in changed else b""
    return b" ".join(filter(None, (changed.get("way"), feed)))
