# SPDX-License-Identifier: MIT
"""A controller whose arithmetic gives other bits than the kernel was tested with does not run."""

import shlex
import subprocess
from pathlib import Path

import pytest

from pycnc import controller
from pycnc.errors import FirmwareError

STUB = "#include <stdint.h>\nuint32_t __wrap_nck_selftest(void) { return 0; }\n"
PROGRAM = "G21 G90\nG1 F600 X1\nM2\n"


@pytest.mark.thorough
def test_a_firmware_refuses_to_run_on_other_arithmetic(tmp_path):
    image = Path(controller._build("host"))
    (tmp_path / "stub.c").write_text(STUB)
    command = shlex.split((image.parent / "CMakeFiles/firmware.dir/link.txt").read_text())
    command[command.index("-o") + 1] = str(tmp_path / "firmware")
    command += ["-Wl,--wrap=nck_selftest", str(tmp_path / "stub.c")]
    subprocess.run(command, cwd=image.parent, check=True)
    assert controller.Controller("host", image).run(PROGRAM).state == "done"
    with pytest.raises(FirmwareError, match="its arithmetic gives other bits"):
        controller.Controller("host", tmp_path / "firmware").run(PROGRAM)
