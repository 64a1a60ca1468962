// SPDX-License-Identifier: MIT
// Semaphore: a count, and who waits for it. What is given goes to the highest task that waits, so
// that the count is above zero only while nobody does.
#include "os/kernel.h" // os_may_wait os_wait os_wake

os_status_t os_sem_create(os_sem_t *sem, uint32_t count)
{
    if (!sem) return OS_E_ARGUMENT;
    *sem = (os_sem_t){.count = count};
    return OS_OK;
}

os_status_t os_sem_pend(os_sem_t *sem, uint32_t timeout)
{
    if (!sem) return OS_E_ARGUMENT;
    if (timeout != OS_NO_WAIT && !os_may_wait()) return OS_E_CONTEXT;
    const uint32_t before = os_critical_enter();
    const int there = sem->count > 0;
    const int waits = !there && timeout != OS_NO_WAIT;
    if (there) sem->count--;
    if (waits) os_wait(&sem->waiting, timeout);
    os_critical_exit(before);
    if (waits) return os_kernel.running->result;
    return there ? OS_OK : OS_TIMED_OUT;
}

os_status_t os_sem_post(os_sem_t *sem)
{
    if (!sem) return OS_E_ARGUMENT;
    os_status_t status = OS_OK;
    const uint32_t before = os_critical_enter();
    if (sem->waiting) os_wake(os_highest(sem->waiting), OS_OK);
    else if (sem->count < UINT32_MAX) sem->count++;
    else status = OS_E_COUNT;
    os_critical_exit(before);
    return status;
}
