// SPDX-License-Identifier: MIT
// Queue of pointers. A message goes straight to the highest task that waits, so that the queue
// holds messages only while nobody does.
#include "os/kernel.h" // os_may_wait os_wait os_wake

os_status_t os_queue_create(os_queue_t *queue, void **slots, uint32_t capacity)
{
    if (!queue || !slots || capacity == 0) return OS_E_ARGUMENT;
    *queue = (os_queue_t){.slots = slots, .capacity = capacity};
    return OS_OK;
}

static void *take(os_queue_t *queue)
{
    void *const message = queue->slots[queue->first];
    queue->first = queue->first + 1 < queue->capacity ? queue->first + 1 : 0;
    queue->used--;
    return message;
}

static void put(os_queue_t *queue, void *message)
{
    const uint32_t room = queue->capacity - queue->first; // up to where it wraps
    const uint32_t last = queue->used < room ? queue->first + queue->used : queue->used - room;
    queue->slots[last] = message;
    queue->used++;
}

os_status_t os_queue_pend(os_queue_t *queue, uint32_t timeout, void **message_out)
{
    if (!queue || !message_out) return OS_E_ARGUMENT;
    if (timeout != OS_NO_WAIT && !os_may_wait()) return OS_E_CONTEXT;
    const uint32_t before = os_critical_enter();
    const int there = queue->used > 0;
    const int waits = !there && timeout != OS_NO_WAIT;
    if (there) *message_out = take(queue);
    if (waits) os_wait(&queue->waiting, timeout);
    os_critical_exit(before);
    if (!waits) return there ? OS_OK : OS_TIMED_OUT;
    const os_task_t *const self = os_kernel.running;
    if (self->result == OS_OK) *message_out = self->message;
    return self->result;
}

os_status_t os_queue_post(os_queue_t *queue, void *message)
{
    if (!queue) return OS_E_ARGUMENT;
    os_status_t status = OS_OK;
    const uint32_t before = os_critical_enter();
    if (queue->waiting) {
        os_task_t *const task = os_highest(queue->waiting);
        task->message = message;
        os_wake(task, OS_OK);
    } else if (queue->used < queue->capacity) {
        put(queue, message);
    } else {
        status = OS_FULL;
    }
    os_critical_exit(before);
    return status;
}
