# SPDX-License-Identifier: MIT
"""The firmware on µC/OS-II, µC/OS-III and FreeRTOS, built against a checkout of each.

Their sources are not here. tests/package/kernels has their published prototypes in their published
folders; a test makes a checkout of it by giving every prototype a body. The bodies can also be
calls of our own kernel under other names: an imitation that runs.
"""

import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from pycnc import firmware

ROOT = Path(__file__).resolve().parents[1]
KERNELS = ROOT / "tests" / "package" / "kernels"
GLUE = ROOT / "firmware_sim" / "glue"
TOOLCHAIN = ROOT / "firmware_sim" / "board" / "arm-none-eabi.cmake"
CMAKE = Path(sys.executable).with_name("cmake")
NINJA = Path(sys.executable).with_name("ninja")
PROTOTYPE = re.compile(r"^(?!typedef|#)(\w[\w ]*[ *])(\w+)(\([^;{]*\));", re.M)
OBJECT = re.compile(r"^extern ([^;]*);", re.M)
PORT = "Ports/ARM-Cortex-M/ARMv7-M"
# What a body must do for the glue to be reached by the linker as it is by the real kernel.
BODIES = {
    "OS_CPU_SysTickHandler": {
        "uC-OS2": "App_TimeTickHook();",
        "uC-OS3": "OS_AppTimeTickHookPtr();",
    },
    "OS_CPU_PendSVHandler": {"uC-OS2": "App_TaskSwHook();", "uC-OS3": "OS_AppTaskSwHookPtr();"},
    "xPortSysTickHandler": {"FreeRTOS-Kernel": "vApplicationTickHook();"},
    "vTaskSwitchContext": {"FreeRTOS-Kernel": "traceTASK_SWITCHED_IN();"},
}


# What the functions of a kernel do in its imitation, in calls of own_os_…; parameters as published.
OWN_QUEUES = """
#include <own/own_kernel.h>
static own_os_queue_t queues[8];
static uint32_t queue_count;
static uint32_t wait_of(uint32_t timeout) { return timeout == 0u ? OS_FOREVER : timeout; }
"""
OWN_SWITCH = """
static void tick(void *user) {{ (void)user; {tick}(); }}
static const own_os_hooks_t hooks = {{tick, NULL, NULL}};
static {task} next_task;
void *imitation_switch(void *context, const void *stack);
void *imitation_switch(void *context, const void *stack) {{
    void *const next = own_os_switch(context, stack);
    if (!own_os_kernel.running) return next;
    {switch};
    return next;
}}
"""
SYSTICK = "*(volatile uint32_t *)0xe000e014u = cnts - 1u; *(volatile uint32_t *)0xe000e018u = 0u;"
OWN_UCOS2 = {
    "": OWN_SWITCH.format(
        tick="App_TimeTickHook",
        task="OS_TCB",
        switch="next_task.OSTCBPrio = (INT8U)own_os_kernel.running->name;"
        " OSTCBHighRdy = &next_task; App_TaskSwHook()",
    ),
    "OSInit": "own_os_init(&hooks);",
    "OSStart": "(void)own_os_start(1u << 24);",
    "OSTaskCreateExt": "(void)ptos, (void)id, (void)pext, (void)opt;"
    ' return (INT8U)(own_os_task_create(prio, "task", task, p_arg, (void *)pbos, stk_size / 2u)'
    " != OS_OK);",
    "OSTimeDly": "(void)own_os_delay(ticks);",
    "OSQCreate": "own_os_queue_t *const queue = &queues[queue_count++];"
    " return own_os_queue_create(queue, start, size) == OS_OK ? (void *)queue : NULL;",
    "OSQAccept": "void *message = NULL;"
    " *perr = own_os_queue_pend((void *)pevent, 0u, &message) != OS_OK; return message;",
    "OSQPend": "void *message = NULL; *perr ="
    " own_os_queue_pend((void *)pevent, wait_of(timeout), &message) != OS_OK; return message;",
    "OSQPost": "return own_os_queue_post((void *)pevent, pmsg) != OS_OK;",
    "OS_CPU_SysTickInit": SYSTICK,
}
OWN_UCOS3 = {
    "": OWN_SWITCH.format(
        tick="OS_AppTimeTickHookPtr",
        task="OS_TCB",
        switch="next_task.Prio = (OS_PRIO)own_os_kernel.running->name;"
        " OSTCBHighRdyPtr = &next_task; OS_AppTaskSwHookPtr()",
    )
    + "static void *pool[8][16];\n",
    "CPU_Init": "",
    "OSInit": "own_os_init(&hooks); *p_err = OS_ERR_NONE;",
    "OSStart": "(void)own_os_start(1u << 24); *p_err = OS_ERR_NONE;",
    "OSTaskCreate": "(void)p_tcb, (void)stk_limit, (void)q_size, (void)time_quanta, (void)p_ext,"
    " (void)opt; *p_err = (OS_ERR)(own_os_task_create(prio, p_name, p_task, p_arg,"
    " (void *)p_stk_base, stk_size / 2u) != OS_OK);",
    "OSTimeDly": "(void)opt; (void)own_os_delay(dly); *p_err = OS_ERR_NONE;",
    "OSQCreate": "(void)p_name; p_q->Entries = (OS_MSG_QTY)queue_count++; *p_err = (OS_ERR)("
    "own_os_queue_create(&queues[p_q->Entries], pool[p_q->Entries], max_qty) != OS_OK);",
    "OSQPend": "void *message = NULL; (void)p_msg_size, (void)p_ts;"
    " const uint32_t wait = opt == OS_OPT_PEND_NON_BLOCKING ? 0u : wait_of(timeout); *p_err ="
    " (OS_ERR)(own_os_queue_pend(&queues[p_q->Entries], wait, &message) != OS_OK);"
    " return message;",
    "OSQPost": "(void)msg_size, (void)opt;"
    " *p_err = (OS_ERR)(own_os_queue_post(&queues[p_q->Entries], p_void) != OS_OK);",
    "OS_CPU_SysTickInit": SYSTICK,
}
OWN_TASKS = {
    "": OWN_SWITCH.format(
        tick="vApplicationTickHook",
        task="struct tskTaskControlBlock",
        switch="next_task.uxPriority = GLUE_TURN(own_os_kernel.running->name);"
        " pxCurrentTCB = &next_task; traceTASK_SWITCHED_IN()",
    ),
    "xTaskCreateStatic": "if (own_os_kernel.ready == 0u) own_os_init(&hooks);"
    " return own_os_task_create(GLUE_TURN(uxPriority), pcName, pxTaskCode, pvParameters,"
    " (void *)puxStackBuffer, uxStackDepth / 2u) == OS_OK ? (void *)pxTaskBuffer : NULL;",
    "vTaskStartScheduler": "(void)own_os_start(1u << 24);",
    "vTaskDelay": "(void)own_os_delay(xTicksToDelay);",
    "xPortIsInsideInterrupt": "return own_os_port_in_interrupt();",
    "xQueueGenericCreateStatic": "(void)uxItemSize, (void)ucQueueType, (void)pxStaticQueue;"
    " own_os_queue_t *const queue = &queues[queue_count++];"
    " (void)own_os_queue_create(queue, (void *)pucQueueStorage, uxQueueLength);"
    " return (void *)queue;",
    "xQueueGenericSend": "(void)xTicksToWait, (void)xCopyPosition;"
    " return own_os_queue_post((void *)xQueue, *(void *const *)pvItemToQueue) == OS_OK;",
    "xQueueGenericSendFromISR": "(void)xCopyPosition, (void)pxHigherPriorityTaskWoken;"
    " return own_os_queue_post((void *)xQueue, *(void *const *)pvItemToQueue) == OS_OK;",
    "xQueueReceive": "return own_os_queue_pend((void *)xQueue, xTicksToWait, pvBuffer) == OS_OK;",
}


@dataclass(frozen=True)
class Kernel:
    """Option and folder of a kernel; its sources, each with the header that it implements."""

    option: str
    folder: str
    sources: tuple
    calls: tuple  # of its functions, some that the image must end up calling
    own: dict  # what the imitation's functions do; "": what stands before them in the first source
    own_file: str  # of its sources, the one that takes our own kernel in

    def __str__(self):
        return self.folder


CHECKOUTS = (
    Kernel(
        "UCOS2_DIR",
        "uC-OS2",
        (
            ("uC-OS2/Source/ucos_ii.c", "uC-OS2/Source/ucos_ii.h", "<ucos_ii.h>"),
            (f"uC-OS2/{PORT}/os_cpu_c.c", f"uC-OS2/{PORT}/GNU/os_cpu.h", "<ucos_ii.h>"),
            (f"uC-OS2/{PORT}/GNU/os_cpu_a.S", None, None),
            (f"uC-OS2/{PORT}/GNU/os_dbg.c", None, None),
        ),
        ("OSTaskCreateExt", "OSStart", "OSQPend", "OSQPost", "OSTimeDly", "OS_CPU_SysTickInit"),
        OWN_UCOS2,
        f"uC-OS2/{PORT}/GNU/os_dbg.c",
    ),
    Kernel(
        "UCOS3_DIR",
        "uC-OS3",
        (
            ("uC-OS3/Source/os_core.c", "uC-OS3/Source/os.h", "<os.h>"),
            (f"uC-OS3/{PORT}/os_cpu_c.c", f"uC-OS3/{PORT}/GNU/os_cpu.h", "<os.h>"),
            (f"uC-OS3/{PORT}/GNU/os_cpu_a.S", None, None),
            ("uC-CPU/cpu_core.c", "uC-CPU/cpu_core.h", "<cpu_core.h>"),
            ("uC-CPU/ARM-Cortex-M/ARMv7-M/cpu_c.c", None, None),
            ("uC-CPU/ARM-Cortex-M/ARMv7-M/GNU/cpu_a.s", None, None),
            ("uC-LIB/lib_mem.c", None, None),
        ),
        ("OSTaskCreate", "OSStart", "OSQPend", "OSQPost", "OSTimeDly", "OS_CPU_SysTickInit"),
        OWN_UCOS3,
        "uC-CPU/ARM-Cortex-M/ARMv7-M/cpu_c.c",
    ),
    Kernel(
        "FREERTOS_DIR",
        "FreeRTOS-Kernel",
        (
            ("FreeRTOS-Kernel/tasks.c", "FreeRTOS-Kernel/include/task.h", "<task.h>"),
            ("FreeRTOS-Kernel/queue.c", "FreeRTOS-Kernel/include/queue.h", "<queue.h>"),
            ("FreeRTOS-Kernel/list.c", None, None),
            (
                "FreeRTOS-Kernel/portable/GCC/ARM_CM7/r0p1/port.c",
                "FreeRTOS-Kernel/portable/GCC/ARM_CM7/r0p1/portmacro.h",
                "<task.h>",
            ),
        ),
        ("xTaskCreateStatic", "vTaskStartScheduler", "xQueueReceive", "vTaskDelay"),
        OWN_TASKS,
        "FreeRTOS-Kernel/list.c",
    ),
)


def call(*command):
    """Run a command; return what it prints, or fail with its words."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        pytest.fail(f"{command}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


def implemented(header, include, folder, own=None, is_first=False):
    """Return C text that defines what a header declares, but for the application's hooks.

    With own, {name: body}, the functions work; of the port's only those are defined that it names.
    """
    text = re.sub(r"//[^\n]*", "", header.read_text(encoding="utf-8"))
    lines = ["#include <FreeRTOS.h>"] if folder == "FreeRTOS-Kernel" else []
    lines += [f"#include {include}"]
    if "TaskHandle_t" in text and include == "<task.h>":
        lines += ["struct tskTaskControlBlock { UBaseType_t uxPriority; };"]
        lines += ["struct tskTaskControlBlock *volatile pxCurrentTCB;"]
    lines += [f"{declared};" for declared in OBJECT.findall(text)]
    if own:
        lines.append(OWN_QUEUES if include != "<cpu_core.h>" else "")
        lines.append(own[""] if is_first else "")
    for result, name, parameters in PROTOTYPE.findall(text):
        if result.startswith("extern") or name.startswith(("App_", "vApplication")):
            continue
        body = BODIES.get(name, {}).get(folder, "") + " for (;;) {}"
        if own is None or name in own:
            lines.append(f"{result}{name}{parameters} {{ {own[name] if own else body} }}")
    return "\n".join(lines) + "\n"


def check_out(kernel, folder, own=None):
    """Make a checkout of a kernel in a folder; return its path."""
    shutil.copytree(KERNELS, folder, dirs_exist_ok=True)
    ports = folder / "FreeRTOS-Kernel" / "portable" / "GCC"
    shutil.copytree(ports / "ARM_CM4F", ports / "ARM_CM7" / "r0p1")
    for source, header, include in kernel.sources:
        text = "\n"
        if header:
            is_first = source == kernel.sources[0][0]
            text = implemented(folder / header, include, kernel.folder, own, is_first)
        (folder / source).parent.mkdir(parents=True, exist_ok=True)
        (folder / source).write_text(text, encoding="utf-8")
    return folder / kernel.folder


def imitate(kernel, folder):
    """Make a checkout of a kernel that runs: our own under other names; return its path."""
    checkout = check_out(kernel, folder, kernel.own)
    includes = "include" if kernel.folder == "FreeRTOS-Kernel" else "Source"
    own = checkout / includes / "own"
    own.mkdir()
    room = ROOT / "firmware_sim" / "os"
    for file in [*room.glob("*.[ch]"), room / "port" / "cortex_m" / "port.c"]:
        text = file.read_text(encoding="utf-8").replace('#include "os/', '#include "own_')
        text = re.sub(r"\bos_", "own_os_", text)
        text = re.sub(r"\bOS_H\b", "OWN_OS_H", text)
        text = re.sub(r"\bpaint = \w+", "paint = 0xa5a5a5a5a5a5a5a5u", text)  # what the glue seeks
        if kernel.folder != "FreeRTOS-Kernel":
            text = re.sub(r"\b(PendSV|SysTick)_Handler\b", r"OS_CPU_\1Handler", text)
        if file.name == "port.c":
            text = re.sub(r"(?<!\*)\bown_os_switch\(", "imitation_switch(", text)
            text = text.replace('"own_port.h"', '"own_port.h"\nvoid *imitation_switch();')
        (own / f"own_{file.name}").write_text(text, encoding="utf-8")
    sources = ("os.c", "queue.c", "mutex.c", "sem.c", "port.c")
    parts = "".join(f"#include <own/own_{name}>\n" for name in sources)
    (folder / kernel.own_file).write_text(parts, encoding="utf-8")
    return checkout


@pytest.fixture(scope="module")
def build_folder(tmp_path_factory):
    """Return the folder of all builds here: only os and the image differ from one to the next."""
    return tmp_path_factory.mktemp("build")


def build(target, kernel, checkout, folder):
    """Build a target for a Cortex-M7 on a checkout; return the finished process."""
    configure = [CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}"]
    configure += [f"--toolchain={TOOLCHAIN}", "-DNCK_CORE=m7", "-DNCK_FIRMWARE=ON"]
    configure += [f"-D{other.option}=" for other in CHECKOUTS if other != kernel]
    done = subprocess.run(
        [*configure, f"-D{kernel.option}={checkout}"], capture_output=True, text=True
    )
    if done.returncode != 0:
        return done
    command = [CMAKE, "--build", folder, "--target", target]
    return subprocess.run(command, capture_output=True, text=True)


@pytest.mark.parametrize("kernel", CHECKOUTS, ids=str)
def test_the_app_is_built_on_a_checkout_of_the_kernel(kernel, build_folder, tool, tmp_path):
    tool("arm-none-eabi-gcc")
    done = build("firmware", kernel, check_out(kernel, tmp_path), build_folder)
    assert done.returncode == 0, done.stdout + done.stderr
    image = build_folder / "firmware_sim" / "app" / "firmware.elf"
    symbols = set(re.findall(r" \w (\w+)$", call(tool("arm-none-eabi-nm"), image), re.M))
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
    image = build_folder / "firmware_sim" / "app" / "firmware.elf"
    return firmware.Controller("m7", shutil.copy(image, checkout))


def test_the_app_does_the_same_on_the_glue_as_on_our_own_kernel(glued):
    own = firmware.open("m7").run(PROGRAM)
    outcome = glued.run(PROGRAM)
    assert (outcome.state, outcome.hash) == ("done", own.hash)
    assert (outcome.overruns, outcome.underruns) == (0, 0)
    assert outcome.joints_nm == own.joints_nm
    assert set(outcome.load) == set(own.load)
    assert all(0 < share < 1 for share in outcome.load.values()), outcome.load
    assert sum(outcome.load.values()) <= 1
    assert all(left > 0 for left in outcome.stack_left.values()), outcome.stack_left


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
