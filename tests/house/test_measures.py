# SPDX-License-Identifier: MIT
"""The figures of the house get no worse; measures.py prints them."""

import re

import house
import measures
import pytest


@pytest.fixture(scope="module")
def told():
    return dict(measures.figures())


def test_no_part_needs_one_that_needs_it(told):
    graphs = {what: figure for what, figure in told.items() if "arrows back" in what}
    assert len(graphs) == 5
    assert {what: figure for what, figure in graphs.items() if not figure.endswith("/ 0")} == {}


def test_a_ring_has_arrows_back_and_shares_a_floor():
    ring = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}}
    assert measures.floors(ring) == (3, 2)
    assert measures.floors(ring | {"c": set()}) == (4, 0)


def test_the_door_is_small_and_told(told):
    functions = told["nck.h: functions / lines behind the preprocessor"].partition(" ")[0]
    assert int(functions) <= 24
    assert told["nck.h: documented each by itself"] == "100%"


def test_functions_of_python_take_little_and_do_little(told):
    assert told["Python: functions with more than 6 parameters"] == "0"
    assert measures.broken(measures.tangled) == []


def test_the_glossary_is_short_and_a_word_of_it_is_of_one_room():
    words = measures.glossary()
    assert len(words) == len(set(words)) <= 50
    rooms = {word: measures.rooms_of(word) for word in words}
    assert rooms["plan"] == {"5_slope"}
    several = {word for word, found in rooms.items() if len(found) > 1}
    assert several == {"contour"}  # one thing: room 1 reads it, room 2 goes beside it


def test_the_pages_grow_no_longer(told):
    every, running = told["words of docs and DESIGN: all / running text"].split(" / ")
    assert int(every.replace(",", "")) <= 42_500
    assert int(running.replace(",", "")) <= 24_000


def test_what_one_place_calls_has_a_reason(told):
    once, without, every = measures.called_once()
    assert once / every <= 0.62 and without / every <= 0.31, "a helper of one caller has a reason"
    assert int(told["lines of csrc/nck"].replace(",", "")) <= 40_127


def test_a_joint_is_an_axis_drive_and_nothing_else():
    prep = [name for name in house.CORE if "/prep/" in name]
    word = re.compile(r"(?<![A-Za-z])joints?(?!_nm)(?![a-z])", re.I)
    assert [name for name in prep if word.search(house.read(name))] == []


def test_a_speed_squared_is_vv_and_nothing_else():
    other = re.compile(r"\bw_(cap|start|end|feed|most|in|out)\b|\bw = v²")
    ours = [name for name in house.SOURCES + house.PAGES if not name.startswith("tests/house/")]
    assert [name for name in ours if other.search(house.read(name))] == []


def test_no_rule_stands_in_two_files():
    double = measures.doubles()
    assert [names for names in double if "5_slope" not in names[0]] == []
    assert len(double) <= 1  # end_of: a node's end
