// SPDX-License-Identifier: MIT
// µC/OS-II under os.h. OS_CPU_HOOKS_EN, OS_APP_HOOKS_EN, OS_TASK_SW_HOOK_EN and
// OS_TIME_TICK_HOOK_EN must be 1; OS_MAX_EVENTS and OS_MAX_QS at least GLUE_QUEUES.
#include "glue/glue.h"

#include <ucos_ii.h>

// A branch, not a call: the port's handler reads the exception's return address from LR.
__attribute__((naked)) void PendSV_Handler(void) { __asm__ volatile("b OS_CPU_PendSVHandler"); }
void SysTick_Handler(void) { OS_CPU_SysTickHandler(); }

void glue_init(void) { OSInit(); }

int glue_task_create(uint32_t priority, void (*entry)(void *user), void *user, void *stack,
                     size_t bytes) {
    OS_STK *const base = stack;
    const INT32U words = (INT32U)(bytes / sizeof *base);
    return OSTaskCreateExt(entry, user, &base[words - 1u], (INT8U)priority, (INT16U)priority, base,
                           words, NULL, OS_TASK_OPT_SAVE_FP) == OS_ERR_NONE;
}

void glue_start(void) { OSStart(); }

void glue_clock_start(uint32_t cycles) { OS_CPU_SysTickInit(cycles); } // not before OSStart

void glue_delay(uint32_t ticks) { OSTimeDly(ticks); }

void *glue_queue_create(void **slots, uint32_t capacity) {
    return OSQCreate(slots, (INT16U)capacity);
}

int glue_queue_pend(void *queue, uint32_t timeout, void **message_out) {
    INT8U error = OS_ERR_NONE;
    void *message = NULL;
    if (timeout == 0u) message = OSQAccept(queue, &error);
    else message = OSQPend(queue, timeout == GLUE_FOREVER ? 0u : timeout, &error); // 0: for ever
    if (error == OS_ERR_NONE) *message_out = message;
    return error == OS_ERR_NONE;
}

int glue_queue_post(void *queue, void *message) { return OSQPost(queue, message) == OS_ERR_NONE; }

void App_TimeTickHook(void) { glue_tick(); }
void App_TaskSwHook(void) { glue_switch(OSTCBHighRdy->OSTCBPrio); }
void App_TaskCreateHook(OS_TCB *task) { (void)task; }
void App_TaskDelHook(OS_TCB *task) { (void)task; }
void App_TaskReturnHook(OS_TCB *task) { (void)task; }
void App_TCBInitHook(OS_TCB *task) { (void)task; }
void App_TaskIdleHook(void) {}
void App_TaskStatHook(void) {}
