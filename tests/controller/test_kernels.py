# SPDX-License-Identifier: MIT
"""The firmware on µC/OS-II, µC/OS-III and FreeRTOS, built against a checkout of each and run on
imitations of them (imitated_kernels.py)."""

import json
import re
import shlex
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from firmware_runs import is_safe, long_way, mill, run_in
from imitated_kernels import CHECKOUTS, ROOT, check_out, imitate

from pycnc import controller

GLUE = ROOT / "firmware_sim" / "glue"
TOOLCHAIN = ROOT / "firmware_sim" / "board" / "arm-none-eabi.cmake"
CMAKE = Path(sys.executable).with_name("cmake")
NINJA = Path(sys.executable).with_name("ninja")
FP_ARCH = {"m4f": "VFPv4-D16", "m7": "FPv5/FP-D16 for ARMv8"}


def call(*command):
    """Run a command; return what it prints, or fail with its words."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        pytest.fail(f"{command}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


@pytest.fixture(scope="module")
def build_folder(tmp_path_factory):
    """Return the folder of all builds here: only os and the image differ from one to the next."""
    return tmp_path_factory.mktemp("build")


def image(folder, core="m7"):
    """Return the image that build has made."""
    return folder / core / "firmware_sim" / "app" / "firmware.elf"


def build(target, kernel, checkout, folder, core="m7", settings=""):
    """Build a target on a checkout, with a folder of settings or none; return the process."""
    folder = folder / core
    configure = [CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}"]
    configure += [f"--toolchain={TOOLCHAIN}", f"-DNCK_CORE={core}", "-DNCK_FIRMWARE=ON",
                  "-DNCK_CAPACITIES=FULL"]  # fmt: skip
    configure += [f"-D{other.option}=" for other in CHECKOUTS if other != kernel]
    configure += [f"-D{kernel.option}={checkout}", f"-DNCK_KERNEL_CONFIG_DIR={settings}"]
    done = subprocess.run(configure, capture_output=True, text=True)
    if done.returncode != 0:
        return done
    command = [CMAKE, "--build", folder, "--target", target]
    return subprocess.run(command, capture_output=True, text=True)


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("kernel", CHECKOUTS, ids=str)
def test_the_app_is_built_on_a_checkout_of_the_kernel(kernel, build_folder, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    done = build("firmware", kernel, check_out(kernel, tmp_path), build_folder)
    assert done.returncode == 0, done.stdout + done.stderr
    listed = call(tool("arm-none-eabi-nm"), image(build_folder))
    symbols = set(re.findall(r" \w (\w+)$", listed, re.M))
    assert set(kernel.calls) <= symbols
    assert {"app_tick", "nck_tick", "glue_tick", "os_start"} <= symbols
    assert not {"os_switch", "os_port_start"} & symbols, "our own kernel is in the image"


def test_a_kernel_with_another_prototype_is_noticed(build_folder, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    kernel = CHECKOUTS[0]
    checkout = check_out(kernel, tmp_path)
    header = checkout / "Source" / "ucos_ii.h"
    text = header.read_text(encoding="utf-8")
    header.write_text(text.replace("(void **start, INT16U size)", "(INT16U size, void **start)"))
    done = build("os", kernel, checkout, build_folder)
    assert done.returncode != 0
    assert "OSQCreate" in done.stdout


# What the documented command finds in a checkout


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("core", ["m4f", "m7"])
@pytest.mark.parametrize("kernel", CHECKOUTS[:2], ids=str)
def test_assembler_files_are_for_the_same_core_as_the_others(
    kernel, core, build_folder, tool, tmp_path
):
    readelf = tool("arm-none-eabi-readelf")
    shutil.rmtree(build_folder / core, ignore_errors=True)
    done = build("kernel", kernel, check_out(kernel, tmp_path), build_folder, core)
    assert done.returncode == 0, done.stdout + done.stderr
    found = {}
    for binary in (build_folder / core).rglob("kernel.dir/**/*.obj"):
        attributes = call(readelf, "-A", binary)
        found[binary.name] = re.findall(r"Tag_(?:CPU_arch|FP_arch): .*", attributes)
    assert any(name.lower().endswith(".s.obj") for name in found)
    (common,) = {tuple(tags) for tags in found.values()}
    assert common == ("Tag_CPU_arch: v7E-M", f"Tag_FP_arch: {FP_ARCH[core]}")


def macros(kernel, checkout, folder, header, names, settings=""):
    """Return what macros say in a header as the kernel's files include it, by their name."""
    assert build("kernel", kernel, checkout, folder, settings=settings).returncode == 0
    listed = json.loads((folder / "m7" / "compile_commands.json").read_text(encoding="utf-8"))
    (command,) = {each["command"] for each in listed if each["file"].endswith("os_cpu_c.c")}
    words = [word for word in shlex.split(command)[1:] if word.startswith(("-I", "-m"))]
    probe = folder / "probe.c"
    probe.write_text(f"#include <{header}>\n" + "".join(f"= {name} = {name}\n" for name in names))
    text = call("arm-none-eabi-gcc", *words, "-E", "-P", probe)
    return re.findall(r"^= .* = (.*)$", text, re.M)


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize("with_template", [True, False])
def test_a_template_of_ucos2_says_what_it_knows_and_the_glue_the_rest(
    with_template, build_folder, tool, tmp_path
):
    tool("arm-none-eabi-gcc")
    checkout = check_out(CHECKOUTS[0], tmp_path)
    template = checkout / "Cfg" / "Template" / "app_cfg.h"
    assert "CPU_CFG" not in template.read_text()
    if not with_template:
        template.unlink()
    names = ("CPU_CFG_NVIC_PRIO_BITS", "OS_TASK_TMR_PRIO")
    said = macros(CHECKOUTS[0], checkout, build_folder, "app_cfg.h", names)
    assert said == ["3u", "(OS_LOWEST_PRIO - 2u)"]


@pytest.mark.thorough
def test_what_a_users_own_settings_say_holds(build_folder, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    own = tmp_path / "own"
    own.mkdir()
    (own / "app_cfg.h").write_text(
        "#define CPU_CFG_NVIC_PRIO_BITS 4u\n#define OS_TASK_TMR_PRIO 40u\n"
    )
    (own / "cpu_cfg.h").write_text(
        "#define CPU_CFG_NVIC_PRIO_BITS 4u\n#define CPU_CFG_KA_IPL_BOUNDARY 5u\n"
    )
    names = ("CPU_CFG_NVIC_PRIO_BITS", "OS_TASK_TMR_PRIO", "CPU_CFG_KA_IPL_BOUNDARY")
    checkout = check_out(CHECKOUTS[0], tmp_path / "two")
    said = macros(CHECKOUTS[0], checkout, build_folder, "app_cfg.h", names, own)
    assert said == ["4u", "40u", "1u"]
    checkout = check_out(CHECKOUTS[1], tmp_path / "three")
    said = macros(CHECKOUTS[1], checkout, build_folder, "cpu_cfg.h", names[::2], own)
    assert said == ["4u", "5u"]


@pytest.mark.sample(quick=1)
@pytest.mark.parametrize(
    ("kernel", "hook"),
    [(CHECKOUTS[0], "OS_TIME_TICK_HOOK_EN"), (CHECKOUTS[1], "OS_CFG_APP_HOOKS_EN")],
    ids=str,
)
def test_settings_without_a_tick_do_not_build(kernel, hook, build_folder, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    checkout = check_out(kernel, tmp_path)
    template = checkout / "Cfg" / "Template" / "os_cfg.h"
    template.write_text(template.read_text().replace(f"{hook} 1u", f"{hook} 0u"))
    done = build("os", kernel, checkout, build_folder)
    assert done.returncode != 0
    assert f"{hook} must be 1" in done.stdout


# The kernels, imitated, under the emulator


PROGRAM = "G21 G90 G61\nS800 M3\nG1 F3000 X20\nG3 X30 Y10 J10\nG1 Y25 Z-3\nM5\nM2\n"


@pytest.fixture(scope="module", params=CHECKOUTS, ids=str)
def glued(request, build_folder, tool, tmp_path_factory):
    """Return the controller whose app runs on the glue and an imitated kernel."""
    tool("arm-none-eabi-gcc")
    tool("qemu-system-arm")
    checkout = imitate(request.param, tmp_path_factory.mktemp("imitation"))
    done = build("firmware", request.param, checkout, build_folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return controller.Controller("m7", shutil.copy(image(build_folder), checkout))


@pytest.mark.thorough
@pytest.mark.sample(1, of="glued")
def test_the_app_does_the_same_on_the_glue_as_on_our_own_kernel(glued):
    own = controller.open("m7").run(PROGRAM)
    outcome = glued.run(PROGRAM)
    assert (outcome.state, outcome.hash) == ("done", own.hash)
    assert (outcome.overruns, outcome.underruns) == (0, 0)
    assert outcome.joints_nm == own.joints_nm
    assert set(outcome.load) == set(own.load)
    assert all(0 < share < 1 for share in outcome.load.values()), outcome.load
    assert sum(outcome.load.values()) <= 1
    assert all(left > 0 for left in outcome.stack_left.values()), outcome.stack_left


@pytest.mark.thorough
@pytest.mark.sample(1, of="glued")
@pytest.mark.parametrize(
    ("command", "state"),
    [
        ((100, "abort"), "aborted"),
        ((100, "tick_work", 30_000, 1), "fault_overrun"),
        ((100, "stack_work", 5), "fault_stack"),
    ],
    ids=lambda value: value[1] if isinstance(value, tuple) else value,
)
def test_faults_end_in_the_same_states_on_the_glue(glued, command, state):
    assert glued.run(PROGRAM, commands=[command]).state == state


@pytest.mark.thorough
@pytest.mark.sample(1, of="glued")
@pytest.mark.parametrize(
    ("command", "cause"),
    [((100, "trap", 5), "usage fault"), ((100, "masked_work", 5, 4_000_000_000), "watchdog")],
    ids=lambda value: value[1] if isinstance(value, tuple) else value,
)
def test_handlers_and_the_watchdog_make_safe_on_the_glue_too(glued, command, cause, tmp_path):
    found, changes = run_in(tmp_path, glued, "S800 M3\nM8\n" + PROGRAM, [command])
    assert found == cause
    assert is_safe(changes)


# A call that the kernel refuses after so many ticks, by what it says then.
REFUSALS = {
    "uC-OS2": ("OSQPend", "if (own_os_time() > 200u) { *perr = 99u; return NULL; }"),
    "uC-OS3": ("OSTimeDly", "if (own_os_time() > 200u) { *p_err = OS_ERR_SCHED_LOCKED; return; }"),
    "FreeRTOS-Kernel": ("vTaskDelay", "configASSERT(own_os_time() <= 200u);"),
}


@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("kernel", CHECKOUTS, ids=str)
def test_a_call_that_the_kernel_refuses_ends_in_the_safe_state(
    kernel, build_folder, tool, tmp_path
):
    tool("arm-none-eabi-gcc"), tool("qemu-system-arm")
    name, refusal = REFUSALS[kernel.folder]
    own = {**kernel.own, name: f"{refusal} {kernel.own[name]}"}
    checkout = imitate(replace(kernel, own=own), tmp_path)
    done = build("firmware", kernel, checkout, build_folder)
    assert done.returncode == 0, done.stdout + done.stderr
    chosen = controller.Controller("m7", image(build_folder))
    cause, changes = run_in(tmp_path, chosen, "S800 M3\nM8\n" + long_way())
    assert cause == "its operating system refused a call"
    assert is_safe(changes)


# The tick of a core without doubles, writing a trace: the deepest that there is.
@pytest.mark.thorough
@pytest.mark.sample(1)
@pytest.mark.parametrize("kernel", CHECKOUTS[:2], ids=str)
def test_the_stack_that_the_kernel_gives_to_interrupts_is_large_enough(
    kernel, build_folder, tool, tmp_path
):
    tool("arm-none-eabi-gcc"), tool("qemu-system-arm")
    done = build("firmware", kernel, imitate(kernel, tmp_path), build_folder, "m4f")
    assert done.returncode == 0, done.stdout + done.stderr
    chosen = controller.Controller("m4f", image(build_folder, "m4f"))
    text = PROGRAM.replace("G61", "G64 P0.01")
    assert chosen.run(text, mill("linear"), trace=True).state == "done"


@pytest.mark.sample(quick=2)
@pytest.mark.parametrize(
    "source",
    [GLUE / "os.c", *sorted((ROOT / "firmware_sim" / "examples").glob("*.c"))],
    ids=lambda path: path.name,
)
def test_clang_has_no_warning_for_a_cortex_m(source, tool):
    command = [tool("clang-19"), "--target=thumbv7em-none-eabihf", "-mcpu=cortex-m7", "-std=c99"]
    command += "-Wall -Wextra -Wpedantic -Werror -Wconversion -Wdouble-promotion -Wshadow".split()
    command += "-Wundef -Wvla -Wstrict-prototypes -Wmissing-prototypes -fsyntax-only".split()
    library = Path(call(tool("arm-none-eabi-gcc"), "-print-file-name=libc.a").strip())
    headers = library.parents[1] / "include"
    command += [f"-isystem{headers}", f"-I{ROOT / 'csrc'}", f"-I{ROOT / 'firmware_sim'}", source]
    call(*command)


@pytest.mark.parametrize("name", ["ucos2.c", "ucos3.c", "freertos.c"])
def test_a_glue_file_has_at_most_sixty_lines(name):
    assert len((GLUE / name).read_text(encoding="utf-8").splitlines()) <= 60
