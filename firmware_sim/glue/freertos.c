// SPDX-License-Identifier: MIT
// FreeRTOS under os.h, without a heap; its settings are in freertos/FreeRTOSConfig.h beside this.
#include "glue/glue.h"

#include <FreeRTOS.h>
#include <queue.h>
#include <task.h>

static StaticTask_t tasks[GLUE_TASKS], idle_task;
static StaticQueue_t queues[GLUE_QUEUES];
static StackType_t idle_stack[configMINIMAL_STACK_SIZE];
static uint32_t task_count, queue_count;

int glue_init(void) { return 1; }

int glue_task_create(uint32_t priority, void (*entry)(void *user), void *user, void *stack,
                     size_t bytes) {
    const uint32_t words = (uint32_t)(bytes / sizeof(StackType_t));
    if (task_count == GLUE_TASKS) return 0;
    return xTaskCreateStatic(entry, "task", words, user, GLUE_TURN(priority), stack,
                             &tasks[task_count++]) != NULL;
}

void glue_start(void) { vTaskStartScheduler(); }

// The scheduler has started SysTick at configTICK_RATE_HZ; from here on it counts so many cycles.
void glue_clock_start(uint32_t cycles) {
    *(volatile uint32_t *)0xe000e014u = cycles - 1u;
    *(volatile uint32_t *)0xe000e018u = 0u;
}

glue_answer_t glue_delay(uint32_t ticks) { vTaskDelay(ticks); return GLUE_DONE; }

void *glue_queue_create(void **slots, uint32_t capacity) {
    if (queue_count == GLUE_QUEUES) return NULL;
    return xQueueCreateStatic(capacity, sizeof(void *), (uint8_t *)slots, &queues[queue_count++]);
}

glue_answer_t glue_queue_pend(void *queue, uint32_t timeout, void **message_out) {
    const TickType_t wait = timeout == GLUE_FOREVER ? portMAX_DELAY : timeout;
    return xQueueReceive(queue, message_out, wait) == pdPASS ? GLUE_DONE : GLUE_NOT_NOW;
}

glue_answer_t glue_queue_post(void *queue, void *message) {
    BaseType_t sent = pdFALSE, is_higher_awake = pdFALSE;
    if (!xPortIsInsideInterrupt()) sent = xQueueSend(queue, &message, 0u);
    else sent = xQueueSendFromISR(queue, &message, &is_higher_awake);
    portYIELD_FROM_ISR(is_higher_awake);
    return sent == pdPASS ? GLUE_DONE : GLUE_NOT_NOW; // errQUEUE_FULL is all that it can be
}

void vApplicationTickHook(void) { glue_tick(); }

void vApplicationGetIdleTaskMemory(StaticTask_t **task, StackType_t **stack,
                                   configSTACK_DEPTH_TYPE *words) {
    *task = &idle_task;
    *stack = idle_stack;
    *words = configMINIMAL_STACK_SIZE;
}
