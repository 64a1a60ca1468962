# SPDX-License-Identifier: MIT
"""The NumPy dtypes lie in memory as the C compiler lays the records out."""

import subprocess

import numpy as np
import pytest
import targets

from pycnc import errors
from pycnc.kernel import records
from pycnc.kernel.bind import check, pointer

RECORDS = records.names()


def paths(dtype, before=""):
    """Yield every field of a dtype, nested ones as C names them, with offset and size."""
    for name, (field, offset, *_) in dtype.fields.items():
        yield before + name, offset, field.itemsize
        if field.fields:
            for inner, inner_offset, size in paths(field, f"{before}{name}."):
                yield inner, offset + inner_offset, size


@pytest.fixture(scope="module")
def compiled_layout(root, tool, tmp_path_factory):
    """Return {(record, field): (offset, size)} as a C program made from the headers prints it."""
    folder = tmp_path_factory.mktemp("layout")
    host = sorted(path.name for path in (root / "csrc" / "host").glob("*.h"))
    faces = [f"host/{name}" for name in host if not name.endswith("_math.h")]
    own = ("sim.h", "sim_build.h", "host_serve.h", "app/outcome.h", "board/exits.h")
    lines = [f'#include "{header}"' for header in ("nck/nck_tools.h", *faces, *own)]
    lines += ["#include <stdio.h>", "int main(void)", "{"]
    for record in RECORDS:
        lines.append(f'printf("{record} . 0 %zu\\n", sizeof({record}));')
        for field, _, _ in paths(records.dtype(record)):
            size = f"sizeof((({record} *)0)->{field})"
            lines.append(
                f'printf("{record} {field} %zu %zu\\n", offsetof({record}, {field}), {size});'
            )
    (folder / "layout.c").write_text("\n".join([*lines, "return 0;", "}"]))
    command = [tool("cc"), "-std=c99", f"-I{root / 'csrc'}", f"-I{root / 'firmware_sim'}"]
    command += [f"-D{macro}={value}" for macro, value in targets.capacities("host").items()]
    subprocess.run([*command, folder / "layout.c", "-o", folder / "layout"], check=True)
    output = subprocess.run([folder / "layout"], capture_output=True, text=True, check=True).stdout
    rows = (line.split() for line in output.splitlines())
    return {(record, field): (int(offset), int(size)) for record, field, offset, size in rows}


@pytest.mark.parametrize("record", RECORDS)
def test_every_field_lies_where_the_compiler_put_it(compiled_layout, record):
    dtype = records.dtype(record)
    expected = {field: place for (name, field), place in compiled_layout.items() if name == record}
    got = {field: (offset, size) for field, offset, size in paths(dtype)}
    assert got | {".": (0, dtype.itemsize)} == expected


def test_every_record_of_the_flow_is_there():
    flow = {"nck_block_t", "nck_seg_t", "nck_node_t", "nck_cell_t", "nck_pose_t", "nck_axes_t"}
    assert flow | {"nck_t", "nck_machine_t", "sim_row_t"} <= set(RECORDS)


def test_enumerations_carry_the_values_of_c():
    limit = records.enum("nck_limit_t")
    assert limit.FEED == 0
    assert limit.AXIS_V == 16
    assert records.enum("nck_block_kind_t")(2).name == "ARC"


@pytest.mark.parametrize(
    ("name", "cause"),
    [
        ("E_ARC_RADIUS", errors.ProgramError),
        ("E_ARGUMENT", errors.ArgumentError),
        ("E_MACHINE", errors.MachineError),
        ("E_STATE", errors.StateError),
        ("E_INTERNAL", errors.InternalError),
    ],
)
def test_each_error_status_raises_its_exception(name, cause):
    status = records.enum("nck_status_t")[name]
    with pytest.raises(cause) as caught:
        check(status)
    assert caught.value.status == status
    assert caught.value.id == name.removeprefix("E_").lower().replace("_", "-")


def test_good_and_not_now_are_returned():
    assert [check(status) for status in range(5)] == [0, 1, 2, 3, 4]


def test_an_array_of_the_wrong_item_size_is_refused():
    with pytest.raises(errors.ArgumentError):
        pointer("double", np.zeros(4, np.float32))


def test_joined_records_can_go_back_to_c():
    pieces = [np.zeros(2, records.dtype("nck_seg_t")), np.ones(1, records.dtype("nck_seg_t"))]
    joined = records.join("nck_seg_t", pieces)
    assert joined.dtype == records.dtype("nck_seg_t")
    assert joined["length"].tolist() == [0, 0, 1]
    pointer("nck_seg_t", joined)
