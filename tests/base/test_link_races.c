// SPDX-License-Identifier: MIT
// The link, with one side coming between any two accesses of the other to what they share: the path
// goes on without a gap, whoever is first. The fence is the test's own: it lets the other side in.
#include <stddef.h> // NULL
#include <stdint.h> // uint32_t

#include "check.h"

static void let_other_in(void);

#define NCK_BASE_FENCE_H
static inline uint32_t nck_fence_load(const uint32_t *word)
{
    let_other_in();
    return *word;
}

static inline void nck_fence_store(uint32_t *word, uint32_t value)
{
    let_other_in();
    *word = value;
}

static inline int nck_fence_exchange(uint32_t *word, uint32_t expected, uint32_t desired)
{
    let_other_in();
    if (*word != expected) return 0;
    *word = desired;
    return 1;
}

#include "nck/base/link.c"

enum { PLAN = 5, STEPS = 200, GAPS = 40, TAKES = 7 };
#define DURATION 0.25 // sums of it are exact

static nck_link_t link_;
static void (*other)(void); // the side that comes between, every so many accesses
static uint32_t gap, accesses;
static uint32_t takes;      // cells that the tick takes at once
static uint32_t step;       // of prep
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

static void let_other_in(void)
{
    void (*const side)(void) = other;
    if (!side || ++accesses % gap != 0) return;
    other = NULL; // nobody comes between what comes between
    side();
    other = side;
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

static void prepare(void)
{
    int entered = 0;
    const uint32_t end = nck_link_end(&link_, &entered);
    const uint32_t begin = next_place(end, entered);
    if (!saw_one_state(end, entered)) return;
    build(begin);
    if (link_.tail_entered != (uint32_t)entered) return;
    step++;
    const nck_status_t installed = nck_link_install(&link_, DURATION, 1 + step % 3);
    void_plans += installed == NCK_E_STATE;
    const nck_status_t advanced = nck_link_advance(&link_, 2.0 * DURATION, 1 + step % 2);
    void_advances += advanced == NCK_E_STATE;
}

// What waits lasts as long as its cells.
static int lead_is_right(void)
{
    void (*const side)(void) = other;
    other = NULL;
    const int good = nck_link_lead(&link_) == DURATION * nck_link_waiting(&link_);
    other = side;
    return good;
}

static void begin(void (*side)(void))
{
    other = NULL;
    nck_link_init(&link_);
    accesses = place = leaps = step = 0;
    (void)nck_link_batch_begin(&link_);
    other = side;
}

static void path_has_no_gap_when_the_tick_comes_between(check_t *check)
{
    void_plans = void_advances = rests = 0;
    for (gap = 1; gap <= GAPS; gap++) {
        for (takes = 1; takes <= TAKES; takes++) {
            begin(take_cells);
            for (uint32_t n = 0; n < STEPS; n++) {
                prepare();
                CHECK(check, lead_is_right());
            }
            CHECK_INT(check, leaps, 0);
            CHECK(check, place > 0);
        }
    }
    CHECK(check, void_plans > 100 && void_advances > 100 && rests > 100);
}

// Two processors: prep may come between the tick's accesses as well.
static void path_has_no_gap_when_prep_comes_between(check_t *check)
{
    rests = 0;
    for (gap = 1; gap <= GAPS; gap++) {
        for (takes = 1; takes <= TAKES; takes++) {
            begin(prepare);
            for (uint32_t n = 0; n < STEPS; n++) {
                take_cells();
                CHECK(check, lead_is_right());
            }
            CHECK_INT(check, leaps, 0);
            CHECK(check, place > 0);
        }
    }
    CHECK(check, rests > 100);
}

static void publish_a_tail_alone(void)
{
    (void)nck_link_batch_begin(&link_);
    build(place);
    (void)nck_link_publish(&link_);
}

// As often as prep may be first, the tick says that there is nothing rather than to try on.
static void the_tick_never_spins(check_t *check)
{
    nck_cell_t cell;
    int from_tail = 0;
    begin(NULL);
    publish_a_tail_alone();
    gap = 1;
    other = publish_a_tail_alone;
    CHECK_INT(check, nck_link_take(&link_, &cell, &from_tail), NCK_EMPTY);
    other = NULL;
    CHECK_INT(check, nck_link_take(&link_, &cell, &from_tail), NCK_OK);
    CHECK(check, from_tail && cell.seg == 0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, path_has_no_gap_when_the_tick_comes_between);
    CHECK_RUN(&check, path_has_no_gap_when_prep_comes_between);
    CHECK_RUN(&check, the_tick_never_spins);
    return check_end(&check);
}
