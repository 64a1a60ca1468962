// SPDX-License-Identifier: MIT
// µC/OS-II under os.h. OS_MAX_EVENTS and OS_MAX_QS must be at least GLUE_QUEUES.
#include "glue/exceptions.h"
#include "glue/glue.h"

#include <ucos_ii.h>

int glue_init(void) { OSInit(); return 1; }

int glue_task_create(uint32_t priority, void (*entry)(void *user), void *user, void *stack,
                     size_t bytes) {
    OS_STK *const base = stack;
    const INT32U words = (INT32U)(bytes / sizeof *base);
    return OSTaskCreateExt(entry, user, &base[words - 1u], (INT8U)priority, (INT16U)priority, base,
                           words, NULL, OS_TASK_OPT_SAVE_FP) == OS_ERR_NONE;
}

void glue_start(void) { OSStart(); }

void glue_clock_start(uint32_t cycles) { OS_CPU_SysTickInit(cycles); } // not before OSStart

glue_answer_t glue_delay(uint32_t ticks) { OSTimeDly(ticks); return GLUE_DONE; }

void *glue_queue_create(void **slots, uint32_t capacity) {
    return OSQCreate(slots, (INT16U)capacity);
}

glue_answer_t glue_queue_pend(void *queue, uint32_t timeout, void **message_out) {
    INT8U error = OS_ERR_NONE;
    void *message = NULL;
    if (timeout == 0u) message = OSQAccept(queue, &error);
    else message = OSQPend(queue, timeout == GLUE_FOREVER ? 0u : timeout, &error); // 0: for ever
    if (error == OS_ERR_TIMEOUT || error == OS_ERR_Q_EMPTY) return GLUE_NOT_NOW;
    if (error == OS_ERR_NONE) *message_out = message;
    return error == OS_ERR_NONE ? GLUE_DONE : GLUE_REFUSED;
}

glue_answer_t glue_queue_post(void *queue, void *message) {
    const INT8U error = OSQPost(queue, message);
    if (error == OS_ERR_NONE) return GLUE_DONE;
    return error == OS_ERR_Q_FULL ? GLUE_NOT_NOW : GLUE_REFUSED;
}

void App_TimeTickHook(void) { glue_tick(); }
void App_TaskSwHook(void) { glue_switch(OSTCBHighRdy->OSTCBPrio); }
void App_TaskCreateHook(OS_TCB *task) { (void)task; }
void App_TaskDelHook(OS_TCB *task) { (void)task; }
void App_TaskReturnHook(OS_TCB *task) { (void)task; }
void App_TCBInitHook(OS_TCB *task) { (void)task; }
void App_TaskIdleHook(void) {}
void App_TaskStatHook(void) {}
