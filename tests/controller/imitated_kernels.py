# SPDX-License-Identifier: MIT
"""Checkouts of µC/OS-II, µC/OS-III and FreeRTOS for tests, made of their published prototypes.

Their sources are not here. tests/package/kernels has their published prototypes and templates in
their published folders; a checkout of one gives every prototype a body. The bodies can also be
calls of our own kernel under other names: an imitation that runs, and that has the real one's
manners where a firmware can fall over them.
"""

import re
import shutil
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KERNELS = ROOT / "tests" / "package" / "project" / "kernels"
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
# Interrupts have a stack of their own: here one that tells when it was too small.
OWN_STACK = """
static void give_stack({word} *stack, uint32_t words) {{
    for (uint32_t k = 0; k < words; k++) stack[k] = 0x600dcafeu;
    OS_CPU_ExceptStkBase = stack + words;
}}
static void look_at_stack(const {word} *stack) {{
    for (int k = 0; k < 4; k++) if (stack[k] != 0x600dcafeu) __builtin_trap();
}}
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
    "": OWN_STACK.format(word="OS_STK")
    + OWN_SWITCH.format(
        tick="App_TimeTickHook",
        task="OS_TCB",
        switch="look_at_stack(OS_CPU_ExceptStk);"
        " next_task.OSTCBPrio = (INT8U)own_os_kernel.running->name;"
        " OSTCBHighRdy = &next_task; App_TaskSwHook()",
    ),
    "OSInit": "own_os_init(&hooks); give_stack(OS_CPU_ExceptStk, OS_CPU_EXCEPT_STK_SIZE);",
    "OSStart": "(void)own_os_start(1u << 24);",
    "OSTaskCreateExt": "(void)ptos, (void)id, (void)pext, (void)opt;"
    ' return (INT8U)(own_os_task_create(prio, "task", task, p_arg, (void *)pbos, stk_size / 2u)'
    " != OS_OK);",
    "OSTimeDly": "(void)own_os_delay(ticks);",
    "OSQCreate": "own_os_queue_t *const queue = &queues[queue_count++];"
    " return own_os_queue_create(queue, start, size) == OS_OK ? (void *)queue : NULL;",
    "OSQAccept": "void *message = NULL;"
    " *perr = own_os_queue_pend((void *)pevent, 0u, &message) != OS_OK ? OS_ERR_Q_EMPTY : 0u;"
    " return message;",
    "OSQPend": "void *message = NULL; *perr ="
    " own_os_queue_pend((void *)pevent, wait_of(timeout), &message) != OS_OK ? OS_ERR_TIMEOUT : 0u;"
    " return message;",
    "OSQPost": "return own_os_queue_post((void *)pevent, pmsg) != OS_OK ? OS_ERR_Q_FULL : 0u;",
    "OS_CPU_SysTickInit": SYSTICK,
}
# Which calls need a kernel that runs, if the settings want that looked at.
REFUSE = (
    "\n#if OS_CFG_INVALID_OS_CALLS_CHK_EN > 0u\n"
    "if (own_os_kernel.phase != OS_PHASE_RUNNING) {{ *p_err = OS_ERR_OS_NOT_RUNNING; return{}; }}\n"
    "#endif\n"
)
OWN_UCOS3 = {
    "": OWN_STACK.format(word="CPU_STK")
    + OWN_SWITCH.format(
        tick="OS_AppTimeTickHookPtr",
        task="OS_TCB",
        switch="look_at_stack(OSCfg_ISRStk);"
        " next_task.Prio = (OS_PRIO)own_os_kernel.running->name;"
        " OSTCBHighRdyPtr = &next_task; OS_AppTaskSwHookPtr()",
    )
    + "static void *pool[8][16];\n",
    "CPU_Init": "",
    "OSInit": "own_os_init(&hooks); give_stack(OSCfg_ISRStk, OS_CFG_ISR_STK_SIZE);"
    " *p_err = OS_ERR_NONE;",
    "OSStart": "(void)own_os_start(1u << 24); *p_err = OS_ERR_NONE;",
    "OSTaskCreate": "(void)p_tcb, (void)stk_limit, (void)q_size, (void)time_quanta, (void)p_ext,"
    " (void)opt; *p_err = (OS_ERR)(own_os_task_create(prio, p_name, p_task, p_arg,"
    " (void *)p_stk_base, stk_size / 2u) != OS_OK);",
    "OSTimeDly": REFUSE.format("")
    + "(void)opt; (void)own_os_delay(dly); *p_err = OS_ERR_NONE;",
    "OSQCreate": "(void)p_name; p_q->Entries = (OS_MSG_QTY)queue_count++; *p_err = (OS_ERR)("
    "own_os_queue_create(&queues[p_q->Entries], pool[p_q->Entries], max_qty) != OS_OK);",
    "OSQPend": REFUSE.format(" NULL")
    + "void *message = NULL; (void)p_msg_size, (void)p_ts;"
    " const int looks = opt == OS_OPT_PEND_NON_BLOCKING;"
    " *p_err = OS_ERR_NONE;"
    " const uint32_t wait = looks ? 0u : wait_of(timeout);"
    " if (own_os_queue_pend(&queues[p_q->Entries], wait, &message) != OS_OK)"
    " *p_err = looks ? OS_ERR_PEND_WOULD_BLOCK : OS_ERR_TIMEOUT;"
    " return message;",
    "OSQPost": REFUSE.format("")
    + "(void)msg_size, (void)opt; *p_err ="
    " own_os_queue_post(&queues[p_q->Entries], p_void) != OS_OK ? OS_ERR_Q_MAX : OS_ERR_NONE;",
    "OS_CPU_SysTickInit": SYSTICK,
}
# The main stack is given to interrupts from its start on, whoever has frames there; a check counts
# the priority bits that the processor has.
OWN_START = """
__attribute__((naked)) void imitation_main_stack(void);
void imitation_main_stack(void) {
    __asm__ volatile("ldr r0, =0xe000ed08\\n ldr r0, [r0]\\n ldr r0, [r0]\\n msr msp, r0\\n bx lr");
}
static void check_priority_bits(void) {
#if configASSERT_DEFINED && defined(configPRIO_BITS)
    volatile uint8_t *const first = (volatile uint8_t *)0xe000e400u;
    const uint8_t before = *first;
    *first = 0xffu;
    configASSERT(__builtin_popcount(*first) == configPRIO_BITS);
    *first = before;
#endif
}
"""
OWN_TASKS = {
    "": OWN_START
    + OWN_SWITCH.format(
        tick="vApplicationTickHook",
        task="struct tskTaskControlBlock",
        switch="next_task.uxPriority = GLUE_TURN(own_os_kernel.running->name);"
        " pxCurrentTCB = &next_task; traceTASK_SWITCHED_IN()",
    ),
    "xTaskCreateStatic": "if (own_os_kernel.ready == 0u) own_os_init(&hooks);"
    " return own_os_task_create(GLUE_TURN(uxPriority), pcName, pxTaskCode, pvParameters,"
    " (void *)puxStackBuffer, uxStackDepth / 2u) == OS_OK ? (void *)pxTaskBuffer : NULL;",
    "vTaskStartScheduler": "check_priority_bits(); (void)own_os_start(1u << 24);",
    "vTaskDelay": "const own_os_status_t done = own_os_delay(xTicksToDelay); (void)done;"
    " configASSERT(done == OS_OK);",
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
    if include == "<ucos_ii.h>" and is_first:
        lines += ["#if OS_TMR_EN > 0u", "const INT8U timer_priority = OS_TASK_TMR_PRIO;", "#endif"]
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
        if (folder / source).exists():
            continue
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
            start = '        "movs r0, #2'
            assert text.count(start) == 1
            text = text.replace(start, '        "bl imitation_main_stack\\n"\n' + start)
        (own / f"own_{file.name}").write_text(text, encoding="utf-8")
    sources = ("os.c", "queue.c", "mutex.c", "sem.c", "port.c")
    parts = "".join(f"#include <own/own_{name}>\n" for name in sources)
    (folder / kernel.own_file).write_text(parts, encoding="utf-8")
    return checkout


