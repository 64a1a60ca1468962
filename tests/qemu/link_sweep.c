// SPDX-License-Identifier: MIT
// The tick interrupts prep every few instructions: the gap between two interrupts is fixed, prep's
// loop is not a multiple of it, so that in the end every instruction of prep has been interrupted.
//
//     link_sweep CLOCKS INTERRUPTS APPETITE WAY
//
// APPETITE is the most cells that one interrupt takes, more than prep makes in a gap, so that the
// tick runs into the tail; every other while it takes but one, so that the ring is full. WAY is a
// traffic_way_t.
//
// Exit status: 0, or 1 if a rule of the traffic is broken, 2 if an argument is wrong or the run
// met none of what it is for.
#include "board/board.h" // board_tick_start
#include "traffic.h"     // traffic_prepare traffic_consume traffic_below

#include <stdlib.h> // strtoul

enum { WORD_MAX = 16, EVENTS_LEAST = 20, WHILE = 256 };

void SysTick_Handler(void);

static nck_link_t link_;
static traffic_prep_t prep;
static traffic_tick_t tick;
static uint32_t clocks, appetite;
static volatile uint32_t interrupts;

void SysTick_Handler(void) {
    board_tick_stop();
    const uint32_t most = (interrupts & WHILE) ? 1 : appetite;
    const uint32_t cells = 1 + traffic_below(&tick.seed, most);
    for (uint32_t n = 0; n < cells; n++) traffic_consume(&link_, &tick);
    interrupts++;
    board_tick_start(clocks);
}

static uint32_t number(int k) {
    char word[WORD_MAX];
    return board_argument(k, word, sizeof word) < 0 ? 0 : (uint32_t)strtoul(word, NULL, 10);
}

static int judge(void) {
    const char *const fault = prep.fault ? prep.fault : tick.fault;
    if (fault) {
        board_print("broken: ");
        board_print(fault);
        board_print("\n");
        return 1;
    }
    const int met = prep.batches >= EVENTS_LEAST && tick.tails >= EVENTS_LEAST
                    && tick.cells >= EVENTS_LEAST && tick.outputs >= EVENTS_LEAST;
    return met ? 0 : 2;
}

int main(void) {
    const uint32_t wanted = number(2);
    clocks = number(1);
    appetite = number(3);
    if (clocks < 2 || wanted == 0 || appetite == 0) return 2;
    prep.way = tick.way = number(4);
    nck_link_init(&link_);
    board_tick_start(clocks);
    while (interrupts < wanted && !prep.fault && !tick.fault) traffic_prepare(&link_, &prep);
    board_tick_stop();
    return judge();
}
