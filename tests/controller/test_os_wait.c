// SPDX-License-Identifier: MIT
// The small kernel's semaphores and mutexes, the same on the host and on a target.
#include "os_check.h"

#include <stdint.h> // UINT32_MAX

static os_sem_t sem;
static os_mutex_t mutex, outer;
static os_queue_t queue;
static void *slots[3];
static os_status_t statuses[12];
static uint32_t times[12];

// Semaphores -------------------------------------------------------------------------------------

static void take_by_timeouts(void *user)
{
    (void)user;
    static const uint32_t timeouts[] = {OS_NO_WAIT, 1, 5, 40};
    os_delay(1);
    for (uint32_t k = 0; k < 4; k++) {
        const uint32_t from = os_time();
        statuses[k] = os_sem_pend(&sem, timeouts[k]);
        times[k] = os_time() - from;
    }
    os_stop();
}

static void a_wait_ends_at_its_timeout(check_t *check)
{
    begin();
    CHECK_INT(check, os_sem_create(&sem, 0), OS_OK);
    (void)add(4, take_by_timeouts);
    run(check);
    static const uint32_t want[] = {0, 1, 5, 40};
    for (uint32_t k = 0; k < 4; k++) {
        CHECK_INT(check, statuses[k], OS_TIMED_OUT);
        CHECK_INT(check, times[k], want[k]);
    }
    CHECK_INT(check, sem.waiting, 0);
}

static void what_was_posted_is_there(check_t *check)
{
    begin();
    CHECK_INT(check, os_sem_create(&sem, 1), OS_OK);
    CHECK_INT(check, os_sem_post(&sem), OS_OK);
    CHECK_INT(check, os_sem_pend(&sem, OS_NO_WAIT), OS_OK);
    CHECK_INT(check, os_sem_pend(&sem, OS_NO_WAIT), OS_OK);
    CHECK_INT(check, os_sem_pend(&sem, OS_NO_WAIT), OS_TIMED_OUT);
    CHECK_INT(check, os_sem_pend(&sem, 1), OS_E_CONTEXT);
    CHECK_INT(check, os_sem_create(&sem, UINT32_MAX), OS_OK);
    CHECK_INT(check, os_sem_post(&sem), OS_E_COUNT);
    CHECK_INT(check, os_sem_create(NULL, 0), OS_E_ARGUMENT);
    CHECK_INT(check, os_sem_pend(NULL, 0), OS_E_ARGUMENT);
    CHECK_INT(check, os_sem_post(NULL), OS_E_ARGUMENT);
}

static void take_and_note(char letter)
{
    if (os_sem_pend(&sem, OS_FOREVER) == OS_OK) note(letter);
}

static void take_a(void *user) { (void)user; take_and_note('a'); }
static void take_b(void *user) { (void)user; take_and_note('b'); }
static void take_c(void *user) { (void)user; take_and_note('c'); }

static void post_three(void *user)
{
    (void)user;
    os_delay(2);
    for (int k = 0; k < 3; k++) {
        (void)os_sem_post(&sem);
        note('-');
    }
    os_stop();
}

static void the_highest_that_waits_is_served_first(check_t *check)
{
    begin();
    (void)os_sem_create(&sem, 0);
    (void)add(8, take_c);
    (void)add(6, take_b);
    (void)add(5, take_a);
    (void)add(1, post_three); // above all: it is not preempted by whom it wakes
    run(check);
    CHECK_TRACE(check, "---");
    begin();
    (void)os_sem_create(&sem, 0);
    (void)add(8, take_c);
    (void)add(6, take_b);
    (void)add(5, take_a);
    (void)add(14, post_three); // below all
    run(check);
    CHECK_TRACE(check, "a-b-c-");
}

static uint32_t posted_at, taken_at;

static void post_at_tick_6(void)
{
    if (stage.ticks != 6) return;
    posted_at = os_time();
    (void)os_sem_post(&sem);
}

static void take_within_6(void *user)
{
    (void)user;
    statuses[0] = os_sem_pend(&sem, 6);
    taken_at = os_time();
    statuses[1] = os_sem_pend(&sem, 6);
    os_stop();
}

static void an_interrupt_posts_in_the_last_moment(check_t *check)
{
    begin();
    (void)os_sem_create(&sem, 0);
    stage.on_tick = post_at_tick_6;
    (void)add(4, take_within_6);
    run(check);
    CHECK_INT(check, posted_at, 6);
    CHECK_INT(check, taken_at, 6);
    CHECK_INT(check, statuses[0], OS_OK);
    CHECK_INT(check, statuses[1], OS_TIMED_OUT);
    CHECK_INT(check, sem.count, 0);
    CHECK_INT(check, os_time(), 12);
}

static void wait_in_an_interrupt(void)
{
    void *message;
    statuses[0] = os_sem_pend(&sem, 1);
    statuses[1] = os_sem_pend(&sem, OS_NO_WAIT);
    statuses[2] = os_sem_pend(&sem, OS_NO_WAIT);
    statuses[3] = os_queue_pend(&queue, 1, &message);
    statuses[4] = os_queue_pend(&queue, OS_NO_WAIT, &message);
    statuses[5] = os_mutex_pend(&mutex, OS_NO_WAIT);
    statuses[6] = os_mutex_post(&mutex);
    statuses[7] = os_mutex_create(&mutex, 2);
    os_stop();
}

static void an_interrupt_looks_but_does_not_wait(check_t *check)
{
    begin();
    (void)os_sem_create(&sem, 1);
    (void)os_queue_create(&queue, slots, 3);
    (void)os_mutex_create(&mutex, 1);
    stage.on_tick = wait_in_an_interrupt;
    run(check);
    static const os_status_t want[] = {OS_E_CONTEXT, OS_OK,        OS_TIMED_OUT, OS_E_CONTEXT,
                                       OS_TIMED_OUT, OS_E_CONTEXT, OS_E_CONTEXT, OS_E_CONTEXT};
    for (uint32_t k = 0; k < 8; k++) CHECK_INT(check, statuses[k], want[k]);
}

// Mutexes ----------------------------------------------------------------------------------------

enum { REGION_TICKS = 2, MIDDLE_TICKS = 20 };
static int uses_mutex;

static void lock(void)
{
    (void)(uses_mutex ? os_mutex_pend(&mutex, OS_FOREVER) : os_sem_pend(&sem, OS_FOREVER));
}

static void unlock(void) { (void)(uses_mutex ? os_mutex_post(&mutex) : os_sem_post(&sem)); }

static void low_with_a_region(void *user)
{
    (void)user;
    lock();
    note('L');
    be_busy(REGION_TICKS);
    note('l');
    unlock();
    os_delay(OS_FOREVER);
}

static void middle_is_busy(void *user)
{
    (void)user;
    os_delay(1);
    note('M');
    be_busy(MIDDLE_TICKS);
    note('m');
    os_delay(OS_FOREVER);
}

static void high_needs_the_region(void *user)
{
    (void)user;
    os_delay(1);
    note('h');
    lock();
    note('H');
    times[0] = os_time() - 1;
    unlock();
    os_delay(MIDDLE_TICKS + 2 * REGION_TICKS);
    os_stop();
}

static void invert(check_t *check, int by_mutex)
{
    begin();
    uses_mutex = by_mutex;
    (void)os_sem_create(&sem, 1);
    CHECK_INT(check, os_mutex_create(&mutex, 2), OS_OK);
    (void)add(9, low_with_a_region);
    (void)add(6, middle_is_busy);
    (void)add(3, high_needs_the_region);
    run(check);
}

static void the_ceiling_bounds_priority_inversion(check_t *check)
{
    invert(check, 1);
    CHECK_TRACE(check, "LlhHMm");
    CHECK(check, times[0] <= REGION_TICKS);
}

// The control: the same three tasks with a semaphore for a lock show what the ceiling prevents.
static void without_a_ceiling_the_inversion_lasts(check_t *check)
{
    invert(check, 0);
    CHECK_TRACE(check, "LhMmlH");
    CHECK(check, times[0] >= MIDDLE_TICKS);
}

static void nest(void *user)
{
    (void)user;
    statuses[0] = os_mutex_pend(&mutex, OS_FOREVER);
    times[0] = os_kernel.running->priority;
    statuses[1] = os_mutex_pend(&outer, OS_FOREVER);
    times[1] = os_kernel.running->priority;
    statuses[2] = os_mutex_post(&mutex); // not the last one
    statuses[3] = os_mutex_pend(&outer, OS_NO_WAIT);
    statuses[4] = os_mutex_post(&outer);
    times[2] = os_kernel.running->priority;
    statuses[5] = os_mutex_post(&outer);
    statuses[6] = os_mutex_post(&mutex);
    times[3] = os_kernel.running->priority;
    os_stop();
}

static void check_nest(check_t *check, uint32_t ceiling, uint32_t outer_ceiling)
{
    begin();
    CHECK_INT(check, os_mutex_create(&mutex, ceiling), OS_OK);
    CHECK_INT(check, os_mutex_create(&outer, outer_ceiling), OS_OK);
    (void)add(7, nest);
    run(check);
    static const os_status_t want[] = {OS_OK,      OS_OK, OS_E_OWNER, OS_E_OWNER,
                                       OS_OK, OS_E_OWNER, OS_OK};
    for (uint32_t k = 0; k < 7; k++) CHECK_INT(check, statuses[k], want[k]);
    CHECK_INT(check, times[0], ceiling);
    CHECK_INT(check, times[1], ceiling < outer_ceiling ? ceiling : outer_ceiling);
    CHECK_INT(check, times[2], ceiling);
    CHECK_INT(check, times[3], 7);
}

static void mutexes_nest(check_t *check)
{
    check_nest(check, 5, 2);
    check_nest(check, 2, 5);
}

static void sleep_in_the_region(void *user)
{
    (void)user;
    statuses[0] = os_mutex_pend(&mutex, OS_FOREVER);
    os_delay(10);
    statuses[1] = os_mutex_post(&mutex);
    os_delay(10);
    os_stop();
}

static void need_it_within_5(void *user)
{
    (void)user;
    os_delay(2);
    statuses[2] = os_mutex_pend(&mutex, 5);
    times[2] = os_time();
    statuses[3] = os_mutex_pend(&mutex, OS_FOREVER);
    times[3] = os_time();
    note('a');
    statuses[4] = os_mutex_post(&mutex);
}

static void need_it_too(void *user)
{
    (void)user;
    os_delay(1);
    statuses[5] = os_mutex_pend(&mutex, OS_FOREVER);
    times[5] = os_time();
    note('b');
    times[6] = os_kernel.running->priority;
    statuses[6] = os_mutex_post(&mutex);
    times[7] = os_kernel.running->priority;
}

static void the_highest_that_waits_gets_the_mutex(check_t *check)
{
    begin();
    (void)os_mutex_create(&mutex, 2);
    (void)add(12, sleep_in_the_region);
    (void)add(4, need_it_within_5);
    (void)add(5, need_it_too);
    run(check);
    static const os_status_t want[] = {OS_OK, OS_OK, OS_TIMED_OUT, OS_OK, OS_OK, OS_OK, OS_OK};
    for (uint32_t k = 0; k < 7; k++) CHECK_INT(check, statuses[k], want[k]);
    CHECK_INT(check, times[2], 7);
    CHECK_INT(check, times[3], 10);
    CHECK_INT(check, times[5], 10);
    CHECK_INT(check, times[6], 2);
    CHECK_INT(check, times[7], 5);
    CHECK_TRACE(check, "ab");
    CHECK_INT(check, mutex.owner, OS_PRIORITIES);
}

static void end_with_the_mutex(void *user)
{
    (void)user;
    (void)os_mutex_pend(&mutex, OS_FOREVER);
}

static void miss_the_mutex(void *user)
{
    (void)user;
    statuses[0] = os_mutex_pend(&mutex, 3);
    statuses[1] = os_mutex_post(&mutex);
    os_stop();
}

static void a_task_that_ends_with_a_mutex_is_told(check_t *check)
{
    begin();
    (void)os_mutex_create(&mutex, 1);
    (void)add(4, end_with_the_mutex);
    (void)add(5, miss_the_mutex);
    run(check);
    CHECK_INT(check, stage.fault, OS_FAULT_MUTEX);
    CHECK_INT(check, stage.faulty, 4);
    CHECK_INT(check, statuses[0], OS_TIMED_OUT);
    CHECK_INT(check, statuses[1], OS_E_OWNER);
}

static void come_from_above(void *user)
{
    (void)user;
    statuses[0] = os_mutex_pend(&mutex, OS_FOREVER);
    os_stop();
}

static void a_ceiling_is_above_its_users_and_its_own(check_t *check)
{
    begin();
    (void)add(3, come_from_above);
    CHECK_INT(check, os_mutex_create(&mutex, 3), OS_E_PRIORITY);
    CHECK_INT(check, os_mutex_create(&mutex, OS_PRIORITY_IDLE), OS_E_PRIORITY);
    CHECK_INT(check, os_mutex_create(&mutex, 4), OS_OK);
    CHECK_INT(check, os_mutex_create(&outer, 4), OS_E_PRIORITY);
    CHECK_INT(check, add(4, come_from_above), OS_E_PRIORITY);
    CHECK_INT(check, os_mutex_create(NULL, 5), OS_E_ARGUMENT);
    CHECK_INT(check, os_mutex_pend(NULL, 0), OS_E_ARGUMENT);
    CHECK_INT(check, os_mutex_post(NULL), OS_E_ARGUMENT);
    CHECK_INT(check, os_mutex_pend(&mutex, 0), OS_E_CONTEXT);
    run(check);
    CHECK_INT(check, statuses[0], OS_E_CEILING);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_wait_ends_at_its_timeout);
    CHECK_RUN(&check, what_was_posted_is_there);
    CHECK_RUN(&check, the_highest_that_waits_is_served_first);
    CHECK_RUN(&check, an_interrupt_posts_in_the_last_moment);
    CHECK_RUN(&check, an_interrupt_looks_but_does_not_wait);
    CHECK_RUN(&check, the_ceiling_bounds_priority_inversion);
    CHECK_RUN(&check, without_a_ceiling_the_inversion_lasts);
    CHECK_RUN(&check, mutexes_nest);
    CHECK_RUN(&check, the_highest_that_waits_gets_the_mutex);
    CHECK_RUN(&check, a_task_that_ends_with_a_mutex_is_told);
    CHECK_RUN(&check, a_ceiling_is_above_its_users_and_its_own);
    return check_end(&check);
}
