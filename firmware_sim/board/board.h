// SPDX-License-Identifier: MIT
// The emulated boards: Cortex-M4F (QEMU's mps2-an386), Cortex-M7 (mps2-an500) and Cortex-M55
// (mps3-an547). Files and the exit status go through semihosting, time comes from SysTick alone.
//
// startup.c owns the vector table. A firmware or an operating system takes an exception by defining
// NMI_Handler, SVC_Handler, PendSV_Handler or SysTick_Handler; what nobody takes ends the run with
// its status.
#ifndef BOARD_H
#define BOARD_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

#include "board/exits.h" // board_exit_t

// How a file of the host is opened.
typedef enum board_mode {
    BOARD_READ = 1, // binary, from the start
    BOARD_WRITE = 5 // binary, emptied or made
} board_mode_t;

// Of the program: called first in the handler of every fault and of every exception that nobody
// takes, on the main stack from its top on, to switch off what moves. Without it nothing is done.
void board_on_fault(void);

// End the run: the emulator exits with this status (0 … 255). Cost: constant. Context: any.
void board_exit(int status);

// Open a file of the host. Returns a handle ≥ 0, or -1. Cost: a halt for the host. Context: main.
int board_open(const char *name, board_mode_t mode);

// Read up to n bytes. Returns how many, 0 at the end of the file or after an error.
// Cost: a halt for the host; 64 KB at once are quickest. Context: main.
size_t board_read(int file, void *data, size_t n);

// Write n bytes. Returns how many were written. Cost: a halt for the host. Context: main.
size_t board_write(int file, const void *data, size_t n);

// Close a file. Cost: a halt for the host. Context: main.
void board_close(int file);

// Print text on the emulator's standard error. Cost: a halt for the host. Context: any.
void board_print(const char *text);

// Copy the k-th word of the command line (-semihosting-config arg=…), 0 being the first, to text,
// which ends in a NUL. Returns its length, or -1 if there is none or it does not fit in size.
// Cost: a halt for the host. Context: main.
int board_argument(int k, char *text, size_t size);

// Paint the free part of the stack, 64 KB at most, to measure what follows. No interrupt may run.
// Cost: linear in the bytes painted. Context: main.
void board_stack_paint(void);

// The most stack that was used since then, from its top on [bytes]. Cost: linear in the bytes
// painted. Context: main.
uint32_t board_stack_used(void);

// Run SysTick_Handler every so many clocks of the core (2 … 2²⁴). Cost: constant. Context: main.
void board_tick_start(uint32_t clocks);

// Stop it. Cost: constant. Context: any.
void board_tick_stop(void);

// 1 if the next tick is due already: at the end of SysTick_Handler an overrun.
// Cost: constant. Context: any.
int board_tick_is_due(void);

#endif
