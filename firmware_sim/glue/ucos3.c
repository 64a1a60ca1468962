// SPDX-License-Identifier: MIT
// µC/OS-III under os.h. OS_CFG_MSG_POOL_SIZE must be as large as all queues together.
#include "glue/exceptions.h"
#include "glue/glue.h"

#include <os.h>

static OS_TCB tasks[GLUE_TASKS];
static OS_Q queues[GLUE_QUEUES];
static uint32_t task_count, queue_count;
static void switch_hook(void) { glue_switch(OSTCBHighRdyPtr->Prio); }

static glue_answer_t answer(OS_ERR error, OS_ERR not_now) {
    if (error == OS_ERR_NONE) return GLUE_DONE;
    return error == not_now ? GLUE_NOT_NOW : GLUE_REFUSED;
}

int glue_init(void) {
    OS_ERR error = OS_ERR_NONE;
    CPU_Init();
    OSInit(&error);
    OS_AppTimeTickHookPtr = glue_tick;
    OS_AppTaskSwHookPtr = switch_hook;
    return error == OS_ERR_NONE;
}
int glue_task_create(uint32_t priority, void (*entry)(void *user), void *user, void *stack,
                     size_t bytes) {
    OS_ERR error = OS_ERR_NONE;
    if (task_count == GLUE_TASKS) return 0;
    OSTaskCreate(&tasks[task_count++], (CPU_CHAR *)"task", entry, user, (OS_PRIO)priority, stack,
                 0u, bytes / sizeof(CPU_STK), 0u, 0u, NULL, OS_OPT_TASK_SAVE_FP, &error);
    return error == OS_ERR_NONE;
}
void glue_start(void) { OSStart(&(OS_ERR){OS_ERR_NONE}); }
void glue_clock_start(uint32_t cycles) { OS_CPU_SysTickInit(cycles); } // not before OSStart
glue_answer_t glue_delay(uint32_t ticks) {
    OS_ERR error = OS_ERR_NONE;
    OSTimeDly(ticks, OS_OPT_TIME_DLY, &error);
    return answer(error, OS_ERR_NONE);
}
void *glue_queue_create(void **slots, uint32_t capacity) {
    OS_ERR error = OS_ERR_NONE;
    if (!slots || queue_count == GLUE_QUEUES) return NULL; // the kernel's pool holds the messages
    OSQCreate(&queues[queue_count], (CPU_CHAR *)"queue", (OS_MSG_QTY)capacity, &error);
    return error == OS_ERR_NONE ? &queues[queue_count++] : NULL;
}
glue_answer_t glue_queue_pend(void *queue, uint32_t timeout, void **message_out) {
    OS_ERR error = OS_ERR_NONE;
    OS_MSG_SIZE size = 0u;
    const OS_OPT option = timeout == 0u ? OS_OPT_PEND_NON_BLOCKING : OS_OPT_PEND_BLOCKING;
    const OS_TICK wait = timeout == GLUE_FOREVER ? 0u : timeout; // 0: for ever
    void *const message = OSQPend(queue, wait, option, &size, NULL, &error);
    if (error == OS_ERR_NONE) *message_out = message;
    return answer(error, timeout == 0u ? OS_ERR_PEND_WOULD_BLOCK : OS_ERR_TIMEOUT);
}
glue_answer_t glue_queue_post(void *queue, void *message) {
    OS_ERR error = OS_ERR_NONE;
    OSQPost(queue, message, 0u, OS_OPT_POST_FIFO, &error);
    return answer(error, OS_ERR_Q_MAX);
}
