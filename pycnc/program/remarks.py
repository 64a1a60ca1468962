# SPDX-License-Identifier: MIT
"""What a program of LinuxCNC's language says to its operator: (MSG, …), (DEBUG, …), (PRINT, …);
what one of Fanuc's puts out: DPRNT[…], BPRNT[…].

They are found in the text. Numbers that DEBUG and PRINT put in are those of a run: a copy of the
text is decoded that hands each of them over where it is said. A line that no run comes to is told,
too, as it is written.
"""

import re
from typing import NamedTuple

from pycnc import kernel
from pycnc.kernel.bind import lib

_SPEAKS = re.compile(rb"\([ \t]*(MSG|DEBUG|PRINT)[ \t]*,([^()\n]*)\)", re.I)
_PUTS_OUT = re.compile(rb"^[ \t]*(?:/\d?[ \t]*)?(?:N *\d+[ \t]*)?([DB]PRNT[ \t]*\[[^\n(;]*)",
                       re.I | re.M)  # fmt: skip
_COMMENT = re.compile(rb"\([^()\n]*\)|;[^\n]*")
_FLOW = re.compile(rb"[ \t]*(/\d?)?[ \t]*(N *\d+)?[ \t]*O", re.I)  # says nothing, as there
_SETS = re.compile(rb"#\s*(\d+|<[^>]*>|\[)[^=(;]*=")
_FORM = re.compile(r"%(d|f|\.\df|(?=\.))|#(\d+|<[^>]*>)")
_DECIMALS = 6
_LAST_PARAMETER = 5602


class _Remark(NamedTuple):
    """A remark, and where it stands; number: its line, from 1."""

    number: int
    column: int
    kind: bytes
    said: str

    @property
    def parameters(self):
        """Return the parameters that it names, in their order."""
        return [] if self.kind == b"MSG" else [m[2] for m in _FORM.finditer(self.said) if m[2]]

    def words(self, values):
        """Return what is shown with the values of the parameters, as LinuxCNC writes them."""
        values, form = iter(values), f".{_DECIMALS}f"

        def shown(match):
            nonlocal form
            if match[2]:
                value = next(values)
                return "######" if value is None else format(value, form)
            form = {"d": ".0f", "f": ".4f"}.get(match[1], match[1]) or form
            return ""

        return self.said if self.kind == b"MSG" else _FORM.sub(shown, self.said)


def found(text, machine, last):
    """Yield (line, column, words) of what a program says, up to a line; 0: to its end.

    Of several comments of a line the last one counts, as in LinuxCNC.
    """
    if machine.settings.dialect.base == "fanuc":
        yield from _put_out(text, last)
    if machine.settings.dialect.base != "linuxcnc":
        return
    remarks = list(_remarks(text, machine, last))
    values = _values(text, machine, remarks)
    for remark in remarks:
        yield remark.number, remark.column, _told(remark, values.get(remark.number))


def _put_out(text, last):
    number, seen = 1, 0
    for match in _PUTS_OUT.finditer(text):
        number += text.count(b"\n", seen, match.start(1))
        seen = match.start(1)
        if last and number > last:
            return
        said = match[1].strip().decode("utf-8", errors="replace")
        yield number, 1, f"puts out what moves nothing: {said}"


def _remarks(text, machine, last):
    number, seen = 1, 0
    for remark in _SPEAKS.finditer(text):
        number += text.count(b"\n", seen, remark.start())
        seen = remark.start()
        if last and number > last:
            return
        begin, end = text.rfind(b"\n", 0, seen) + 1, text.find(b"\n", seen)
        line = text[begin : end if end >= 0 else len(text)]
        skipped = machine.settings.dialect.block_skip and line.lstrip().startswith(b"/")
        *_, comment = _COMMENT.finditer(line)  # the remark itself is one, or in one
        if not skipped and begin + comment.start() == seen and not _FLOW.match(line):
            said = remark[2].strip().decode("utf-8", errors="replace")
            yield _Remark(number, seen - begin + 1, remark[1].upper(), said)


def _told(remark, runs):
    """Return the words of a finding. runs: values of each time; None: it names none."""
    if not remark.parameters:
        return f"says: {remark.words(())}"
    if not runs:  # the text has an error before it, or nothing leads there
        return f"says, with the numbers that hold then: {remark.said}"
    first, last = (remark.words(run) for run in (runs[0], runs[-1]))
    more = f" (and {len(runs) - 1:,} times more, the last one: {last})" if len(runs) > 1 else ""
    return f"says: {first}{more}"


def _values(text, machine, remarks):
    """Return {line: the values of each run, None for what has none} of remarks with numbers."""
    asking = [each for each in remarks if each.parameters]
    if not asking:
        return {}
    copy, places = _with_questions(text, asking)
    runs = {remark.number: [] for remark in asking}
    for blocks, _, _ in kernel.decode(copy, machine):
        for output in blocks[blocks["kind"] == lib.NCK_BLOCK_OUTPUT]["output"]:
            number, index, count = places.get(int(output["line"]), (0, 0, 0))
            if count:
                runs[number].append([None] * count)
            elif number:
                runs[number][-1][index] = float(output["value"])
    return runs


def _with_questions(text, asking):
    """Return the text with lines that ask for the numbers of remarks before or behind them, and
    {line: (that of the remark, which number, or how many there are)} of those."""
    of = {remark.number: remark for remark in asking}
    copy, places = [], {}
    for number, line in enumerate(text.split(b"\n"), 1):
        remark = of.get(number)
        behind = remark and _SETS.search(_COMMENT.sub(b"", line))  # what it sets holds already
        copy += [line] if behind or not remark else []
        if remark:
            skip = re.match(rb"[ \t]*(/\d?)?", line)[1] or b""
            copy.append(skip + b"M68 E0 Q0")
            places[len(copy)] = number, 0, len(remark.parameters)
            for index, name in enumerate(remark.parameters):
                copy += _question(skip, name, f"<-asks {number} {index}>")
                places[len(copy) - (not name.isdigit())] = number, index, 0
        copy += [line] if remark and not behind else []
    return b"\n".join(copy), places


def _question(skip, name, label):
    """Return the lines that hand a parameter over if there is one."""
    ask = skip + f"M68 E0 Q[#{name}]".encode()
    if name.isdigit():
        return [ask if int(name) <= _LAST_PARAMETER else b""]
    there = f"o{label} if [EXISTS[#{name}]]".encode()
    return [there, ask, f"o{label} endif".encode()]
