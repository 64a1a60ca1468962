// SPDX-License-Identifier: MIT
// What a run leaves for who started it: the rows of its trace, and its exit status.
#ifndef APP_OUTCOME_H
#define APP_OUTCOME_H

#include <stdint.h> // uint32_t uint8_t

// Exit statuses without a report that tells more. 0: the report tells; from 100 on the board's.
typedef enum app_exit {
    APP_EXIT_JOB = 2,     // the job is wrong; the report says where
    APP_EXIT_SYSTEM = 3,  // the tasks could not be made
    APP_EXIT_STREAMS = 4, // a file could not be opened
    APP_EXIT_KERNEL = 5,  // the operating system refused a call
    APP_EXIT_BITS = 6     // arithmetic gives other bits: nck_selftest
} app_exit_t;

// One row of the trace: what the drives got. Followed by one int64_t a joint [nm, ndeg].
typedef struct app_row {
    uint32_t tick;       // 1 is the first
    uint32_t line;       // source line
    uint32_t queue;      // final cells that wait
    uint8_t state;       // app_state_t
    uint8_t tick_state;  // nck_tick_state_t
    uint8_t limit;       // nck_limit_t
    uint8_t drives;      // 1: on
} app_row_t;

#endif
