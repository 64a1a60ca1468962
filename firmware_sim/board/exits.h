// SPDX-License-Identifier: MIT
// How a board ends a run that does not end by itself.
#ifndef BOARD_EXITS_H
#define BOARD_EXITS_H

// Exit statuses of the board itself; a program keeps to 0 … 99.
typedef enum board_exit {
    BOARD_EXIT_UNEXPECTED = 100, // an exception that nobody takes
    BOARD_EXIT_NMI = 101,
    BOARD_EXIT_HARD_FAULT = 102,
    BOARD_EXIT_MEM_FAULT = 103,
    BOARD_EXIT_BUS_FAULT = 104,
    BOARD_EXIT_USAGE_FAULT = 105, // undefined instruction, division by zero
    BOARD_EXIT_OVERRUN = 106,     // for a program: a tick that took longer than its period
    BOARD_EXIT_WATCHDOG = 107     // for a program: its watchdog was not fed
} board_exit_t;

#endif
