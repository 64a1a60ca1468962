# SPDX-License-Identifier: MIT
"""README's table of sizes says what the cross compiler measures."""

import importlib.util

import pytest


@pytest.fixture(scope="module")
def size_table(root, tool):
    """Return the module tests/size/table.py."""
    tool("arm-none-eabi-gcc")
    spec = importlib.util.spec_from_file_location("size_table", root / "tests/size/table.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_table_in_the_readme_is_true(root, size_table):
    _, written, _ = size_table.split_readme((root / "README.md").read_text(encoding="utf-8"))
    if size_table.compiler() not in written and "arm-none-eabi-gcc" in written:
        pytest.skip(f"the table was measured with another compiler than {size_table.compiler()}")
    assert written == size_table.table(), "renew it: python tests/size/table.py --write"


def test_the_core_has_no_data_on_a_target(size_table):
    for core in size_table.CORES.values():
        assert size_table.measure_flash(core)[1] == 0
