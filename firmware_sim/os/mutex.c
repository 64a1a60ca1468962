// SPDX-License-Identifier: MIT
// Mutex with the immediate ceiling protocol (L. Sha, R. Rajkumar, J. P. Lehoczky: Priority
// Inheritance Protocols, 1990, as it is commonly simplified): the owner runs at the ceiling from
// the first moment, so that no other user of the mutex can even start, nor any task between them.
#include "os/kernel.h" // os_move os_wait os_wake
#include "os/port.h"   // os_port_in_interrupt

os_status_t os_mutex_create(os_mutex_t *mutex, uint32_t ceiling)
{
    if (!mutex) return OS_E_ARGUMENT;
    if (os_port_in_interrupt()) return OS_E_CONTEXT;
    if (ceiling >= OS_PRIORITY_IDLE) return OS_E_PRIORITY;
    const uint32_t before = os_critical_enter();
    const int taken = os_kernel.task[ceiling].entry || (os_kernel.ceilings & os_bit(ceiling));
    if (!taken) os_kernel.ceilings |= os_bit(ceiling);
    os_critical_exit(before);
    if (taken) return OS_E_PRIORITY;
    *mutex = (os_mutex_t){.ceiling = ceiling, .owner = OS_PRIORITIES};
    return OS_OK;
}

static void own(os_mutex_t *mutex, os_task_t *task)
{
    mutex->owner = task->name;
    mutex->before = task->priority;
    mutex->previous = task->mutex;
    task->mutex = mutex;
    if (mutex->ceiling < task->priority) os_move(task, mutex->ceiling);
}

os_status_t os_mutex_pend(os_mutex_t *mutex, uint32_t timeout)
{
    if (!mutex) return OS_E_ARGUMENT;
    if (!os_may_wait()) return OS_E_CONTEXT;
    os_task_t *const self = os_kernel.running;
    if (self->name < mutex->ceiling) return OS_E_CEILING;
    if (mutex->owner == self->name) return OS_E_OWNER;
    const uint32_t before = os_critical_enter();
    const int there = mutex->owner == OS_PRIORITIES;
    const int waits = !there && timeout != OS_NO_WAIT;
    if (there) own(mutex, self);
    if (waits) os_wait(&mutex->waiting, timeout);
    os_critical_exit(before);
    if (waits) return self->result;
    return there ? OS_OK : OS_TIMED_OUT;
}

os_status_t os_mutex_post(os_mutex_t *mutex)
{
    if (!mutex) return OS_E_ARGUMENT;
    if (!os_may_wait()) return OS_E_CONTEXT;
    os_task_t *const self = os_kernel.running;
    if (self->mutex != mutex) return OS_E_OWNER;
    const uint32_t before = os_critical_enter();
    self->mutex = mutex->previous;
    if (self->priority != mutex->before) os_move(self, mutex->before);
    mutex->owner = OS_PRIORITIES;
    if (mutex->waiting) {
        os_task_t *const next = os_highest(mutex->waiting);
        os_wake(next, OS_OK);
        own(mutex, next);
    }
    os_critical_exit(before);
    return OS_OK;
}
