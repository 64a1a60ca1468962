// SPDX-License-Identifier: MIT
// The small kernel's queues, and all its objects together while ticks fall everywhere, the same on
// the host and on a target.
#include "os_check.h"

#include <stdint.h> // uintptr_t

static os_sem_t sem, other_sem;
static os_queue_t queue;
static void *slots[3];
static os_status_t status;

static void *number(uintptr_t n) { return (void *)n; }

// Queues -----------------------------------------------------------------------------------------

static void a_queue_is_first_in_first_out_full_and_empty(check_t *check)
{
    void *message = number(99);
    begin();
    CHECK_INT(check, os_queue_create(&queue, slots, 3), OS_OK);
    for (uintptr_t round = 0; round < 7; round++) { // the beginning wanders through the slots
        CHECK_INT(check, os_queue_pend(&queue, OS_NO_WAIT, &message), OS_TIMED_OUT);
        CHECK_INT(check, (uintptr_t)message, round == 0 ? 99 : round + 1);
        for (uintptr_t k = 0; k < 3; k++) {
            CHECK_INT(check, os_queue_post(&queue, number(round + k)), OS_OK);
        }
        CHECK_INT(check, os_queue_post(&queue, number(77)), OS_FULL);
        for (uintptr_t k = 0; k < 3; k++) {
            CHECK_INT(check, os_queue_pend(&queue, OS_NO_WAIT, &message), OS_OK);
            CHECK_INT(check, (uintptr_t)message, round + k);
        }
        CHECK_INT(check, os_queue_post(&queue, number(1)), OS_OK);
        CHECK_INT(check, os_queue_pend(&queue, OS_NO_WAIT, &message), OS_OK);
        message = number(round + 2);
    }
    CHECK_INT(check, os_queue_pend(&queue, 1, &message), OS_E_CONTEXT);
    CHECK_INT(check, os_queue_create(&queue, slots, 0), OS_E_ARGUMENT);
    CHECK_INT(check, os_queue_create(&queue, NULL, 1), OS_E_ARGUMENT);
    CHECK_INT(check, os_queue_create(NULL, slots, 1), OS_E_ARGUMENT);
    CHECK_INT(check, os_queue_pend(NULL, 0, &message), OS_E_ARGUMENT);
    CHECK_INT(check, os_queue_pend(&queue, 0, NULL), OS_E_ARGUMENT);
    CHECK_INT(check, os_queue_post(NULL, NULL), OS_E_ARGUMENT);
}

static void receive(char letter)
{
    void *message = NULL;
    if (os_queue_pend(&queue, OS_FOREVER, &message) == OS_OK) {
        note(letter);
        note((char)(uintptr_t)message);
    }
}

static void receive_a(void *user) { (void)user; receive('a'); }
static void receive_b(void *user) { (void)user; receive('b'); }

static void send_three(void *user)
{
    (void)user;
    for (char k = '1'; k <= '3'; k++) (void)os_queue_post(&queue, number((uintptr_t)k));
    void *message = NULL;
    status = os_queue_pend(&queue, OS_NO_WAIT, &message);
    note((char)(uintptr_t)message);
    os_stop();
}

static void a_message_goes_to_the_highest_that_waits(check_t *check)
{
    begin();
    (void)os_queue_create(&queue, slots, 3);
    (void)add(8, receive_b);
    (void)add(4, receive_a);
    (void)add(9, send_three);
    run(check);
    CHECK_TRACE(check, "a1b23");
    CHECK_INT(check, status, OS_OK);
}

// Sweep: ticks that fall everywhere ---------------------------------------------------------------

enum { MESSAGES = 400, POSTS = 200 };
static uintptr_t received, in_order, tick_posts;

static void send_in_order(void *user)
{
    (void)user;
    for (uintptr_t k = 1; k <= MESSAGES; k++) {
        while (os_queue_post(&queue, number(k)) == OS_FULL) os_delay(1);
        (void)os_sem_post(&sem);
    }
    os_delay(OS_FOREVER);
}

static void receive_in_order(void *user)
{
    (void)user;
    void *message;
    while (received < MESSAGES) {
        if (os_sem_pend(&sem, OS_FOREVER) != OS_OK) break;
        if (os_queue_pend(&queue, OS_NO_WAIT, &message) != OS_OK) break;
        received++;
        in_order += (uintptr_t)message == received;
        if (received % 3 == 0) os_delay(1);
    }
    os_delay(OS_FOREVER);
}

static void post_from_the_tick(void)
{
    if (tick_posts == POSTS) return;
    tick_posts++;
    (void)os_sem_post(&other_sem);
}

static uintptr_t taken;

static void take_what_the_tick_posts(void *user)
{
    (void)user;
    while (taken < POSTS || received < MESSAGES) {
        taken += os_sem_pend(&other_sem, (uint32_t)(taken % 3)) == OS_OK;
    }
    os_stop();
}

static void nothing_is_lost_wherever_ticks_fall(check_t *check)
{
    static const uint32_t periods[] = {211, 307, 503, 997};
    for (uint32_t k = 0; k < 4; k++) {
        begin();
        received = in_order = tick_posts = taken = 0;
        (void)os_sem_create(&sem, 0);
        (void)os_sem_create(&other_sem, 0);
        (void)os_queue_create(&queue, slots, 3);
        stage.on_tick = post_from_the_tick;
        (void)add(3, receive_in_order);
        (void)add(6, send_in_order);
        (void)add(9, take_what_the_tick_posts);
        run_by(check, periods[k]);
        CHECK_INT(check, in_order, MESSAGES);
        CHECK_INT(check, taken, POSTS);
        CHECK_INT(check, stage.faults, 0);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_queue_is_first_in_first_out_full_and_empty);
    CHECK_RUN(&check, a_message_goes_to_the_highest_that_waits);
    CHECK_RUN(&check, nothing_is_lost_wherever_ticks_fall);
    return check_end(&check);
}
