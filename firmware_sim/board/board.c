// SPDX-License-Identifier: MIT
// Semihosting and SysTick of a Cortex-M.
#include "board/board.h"

#include <string.h> // strlen

// Operations: ARM, Semihosting for AArch32 and AArch64, section "Semihosting operations".
enum {
    SYS_OPEN = 0x01, SYS_CLOSE = 0x02, SYS_WRITE0 = 0x04, SYS_WRITE = 0x05, SYS_READ = 0x06,
    SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20,
    APPLICATION_EXIT = 0x20026,
    LINE_MAX = 512
};

// The stack: its pattern, what is painted at most, and what a function of this file may stand on.
enum { PAINT = 0x5aa5c33c, PAINT_WORDS = 16384, OWN_WORDS = 64 };

// Of the linker script.
extern uint32_t board_stack_top[];
extern uint8_t board_bss_begin[], board_bss_size[];


// Armv7-M Architecture Reference Manual, B3.2 and B3.3.
typedef struct systick {
    uint32_t control; // bit 0 counts, bit 1 interrupts, bit 2 clock of the core
    uint32_t reload;
    uint32_t value;   // a write sets it to 0
} systick_t;

static volatile systick_t *const systick = (volatile systick_t *)0xe000e010u;
static volatile uint32_t *const interrupt_state = (volatile uint32_t *)0xe000ed04u;
static const uint32_t pending_systick = 1u << 26;

static int32_t call_host(uint32_t operation, const void *argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}

void board_exit(int status) {
    const uint32_t block[2] = {APPLICATION_EXIT, (uint32_t)status};
    (void)call_host(SYS_EXIT_EXTENDED, block);
    for (;;) continue;
}

int board_open(const char *name, board_mode_t mode) {
    const uint32_t block[3] = {(uint32_t)(uintptr_t)name, (uint32_t)mode, (uint32_t)strlen(name)};
    return call_host(SYS_OPEN, block);
}

// The host answers with what it did not move.
static size_t moved(uint32_t operation, int file, const void *data, size_t n) {
    const uint32_t block[3] = {(uint32_t)file, (uint32_t)(uintptr_t)data, (uint32_t)n};
    const int32_t left = call_host(operation, block);
    return left < 0 || (size_t)left > n ? 0 : n - (size_t)left;
}

size_t board_read(int file, void *data, size_t n) { return moved(SYS_READ, file, data, n); }

size_t board_write(int file, const void *data, size_t n) {
    return moved(SYS_WRITE, file, data, n);
}

void board_close(int file) {
    const uint32_t block[1] = {(uint32_t)file};
    (void)call_host(SYS_CLOSE, block);
}

void board_print(const char *text) { (void)call_host(SYS_WRITE0, text); }

static const char *next_word(const char *at) {
    while (*at && *at != ' ') at++;
    while (*at == ' ') at++;
    return at;
}

int board_argument(int k, char *text, size_t size) {
    char line[LINE_MAX] = "";
    const uint32_t block[2] = {(uint32_t)(uintptr_t)line, sizeof line};
    if (call_host(SYS_GET_CMDLINE, block) != 0) return -1;
    const char *word = line;
    for (int n = 0; n < k; n++) word = next_word(word);
    size_t length = 0;
    while (word[length] && word[length] != ' ') length++;
    if (length == 0 || length >= size) return -1;
    memcpy(text, word, length);
    text[length] = '\0';
    return (int)length;
}

static uint32_t *lowest_painted(void) {
    const uintptr_t free = (uintptr_t)board_bss_begin + (uintptr_t)board_bss_size;
    const uintptr_t lowest = (uintptr_t)board_stack_top - PAINT_WORDS * sizeof(uint32_t);
    return (uint32_t *)(lowest > free ? lowest : free);
}

void board_stack_paint(void) {
    uint32_t here = 0;
    const uintptr_t end = (uintptr_t)&here - OWN_WORDS * sizeof(uint32_t);
    for (volatile uint32_t *at = lowest_painted(); (uintptr_t)at < end; at++) *at = PAINT;
}

uint32_t board_stack_used(void) {
    const uint32_t *at = lowest_painted();
    while (at < board_stack_top && *at == PAINT) at++;
    return (uint32_t)((uintptr_t)board_stack_top - (uintptr_t)at);
}

void board_tick_start(uint32_t clocks) {
    systick->control = 0;
    systick->reload = clocks - 1;
    systick->value = 0;
    systick->control = 7;
}

void board_tick_stop(void) { systick->control = 0; }

int board_tick_is_due(void) { return (*interrupt_state & pending_systick) != 0; }
