// SPDX-License-Identifier: MIT
// The link, with the tick coming between any two accesses of prep to what they share: the path goes
// on without a gap, whoever is first. The fence is the test's own: it lets the tick in.
#include <stdint.h> // uint32_t

#include "check.h"

static void let_tick_in(void);

#define NCK_BASE_FENCE_H
static inline uint32_t nck_fence_load(const uint32_t *word)
{
    let_tick_in();
    return *word;
}

static inline void nck_fence_store(uint32_t *word, uint32_t value)
{
    let_tick_in();
    *word = value;
}

static inline int nck_fence_exchange(uint32_t *word, uint32_t expected, uint32_t desired)
{
    let_tick_in();
    if (*word != expected) return 0;
    *word = desired;
    return 1;
}

#include "nck/base/link.c"

enum { PLAN = 5, STEPS = 200, GAPS = 40, TAKES = 7 };
#define DURATION 0.25 // sums of it are exact

static nck_link_t link_;
static uint32_t gap, takes; // the tick comes every so many accesses and takes so many cells
static uint32_t accesses;
static int in_tick;
static uint32_t place;      // of the cell that the tick takes next
static uint32_t leaps;      // cells out of order
static uint32_t void_plans, void_advances, rests; // what the races led to

static void take_cells(void)
{
    nck_cell_t cell;
    int from_tail = 0;
    for (uint32_t n = 0; n < takes; n++) {
        if (nck_link_take(&link_, &cell, &from_tail) != NCK_OK) return;
        leaps += cell.seg != place;
        place = cell.seg + 1;
        if (!from_tail || !cell.stop) continue;
        nck_link_tail_rest(&link_);
        rests++;
    }
}

static void let_tick_in(void)
{
    if (in_tick || ++accesses % gap != 0) return;
    in_tick = 1;
    take_cells();
    in_tick = 0;
}

static void build(uint32_t begin)
{
    nck_link_tail_begin(&link_);
    for (uint32_t k = 0; k < PLAN; k++) {
        const nck_cell_t cell = {.seg = begin + k, .stop = k + 1 == PLAN, .duration = DURATION};
        nck_link_tail_push(&link_, &cell);
    }
}

// Behind the final cells, or behind the tail that the tick is in.
static uint32_t next_place(uint32_t end, int entered)
{
    uint32_t count = 0;
    const nck_cell_t *const next = nck_link_tail_cell(&link_, end);
    const nck_cell_t *const last = nck_link_tail_end(&link_, &count);
    if (entered) return last->seg + 1;
    if (next) return next->seg;
    const nck_cell_t *const final = nck_link_tail_cell(&link_, (end - 1) & NCK_LINK_COUNT_MASK);
    return final ? final->seg + 1 : 0;
}

// The tick has entered the tail while the plan was made: what it is built on may be either.
static int saw_one_state(uint32_t end, int entered)
{
    int entered_now = 0;
    return nck_link_end(&link_, &entered_now) == end && entered_now == entered;
}

static void prepare(uint32_t step)
{
    int entered = 0;
    const uint32_t end = nck_link_end(&link_, &entered);
    const uint32_t begin = next_place(end, entered);
    if (!saw_one_state(end, entered)) return;
    build(begin);
    if (link_.tail_entered != (uint32_t)entered) return;
    const nck_status_t installed = nck_link_install(&link_, DURATION, 1 + step % 3);
    void_plans += installed == NCK_E_STATE;
    const nck_status_t advanced = nck_link_advance(&link_, 2.0 * DURATION, 1 + step % 2);
    void_advances += advanced == NCK_E_STATE;
}

// Nobody comes between now: what waits must last as long as its cells.
static int lead_is_right(void)
{
    in_tick = 1;
    const int good = nck_link_lead(&link_) == DURATION * nck_link_waiting(&link_);
    in_tick = 0;
    return good;
}

static void path_has_no_gap_however_the_tick_comes_between(check_t *check)
{
    void_plans = void_advances = rests = 0;
    for (gap = 1; gap <= GAPS; gap++) {
        for (takes = 1; takes <= TAKES; takes++) {
            nck_link_init(&link_);
            accesses = place = leaps = 0;
            (void)nck_link_batch_begin(&link_);
            for (uint32_t step = 0; step < STEPS; step++) {
                prepare(step);
                CHECK(check, lead_is_right());
            }
            CHECK_INT(check, leaps, 0);
            CHECK(check, place > 0);
        }
    }
    CHECK(check, void_plans > 100 && void_advances > 100 && rests > 100);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, path_has_no_gap_however_the_tick_comes_between);
    return check_end(&check);
}
