// SPDX-License-Identifier: MIT
// base/link.h: a plan joins the one before it, the last cells of which ride beside it and keep
// their places until they are taken.
#include <string.h> // memset

#include "check.h"
#include "nck/base/link.h" // nck_link_join nck_link_ride nck_link_take_rider

#define UNIT 0.0009765625 // duration of a cell, 2⁻¹⁰ s: sums are exact
#define NO_LEAD 0.0       // one cell, whatever waits

static nck_link_t link_;

// A plan's cells: their seg tells the plan and the cell, the last one rests.
static void build(uint32_t name, uint32_t count)
{
    nck_link_tail_begin(&link_);
    for (uint32_t k = 0; k < count; k++) {
        nck_cell_t cell;
        memset(&cell, 0, sizeof cell);
        cell.seg = name + k;
        cell.v = 64.0;
        cell.length = 64.0 * UNIT;
        cell.duration = UNIT;
        cell.stop = k + 1 == count ? NCK_STOP_REST : 0;
        nck_link_tail_push(&link_, &cell);
    }
}

// Four cells, so many of them final, and three built to join them.
static void begin(check_t *check, uint32_t final)
{
    nck_link_init(&link_);
    (void)nck_link_batch_begin(&link_);
    build(100, 4);
    CHECK_INT(check, nck_link_install(&link_, 9.0, final), NCK_OK);
    build(200, 3);
}

static nck_status_t join(double overlap, double lead, uint32_t most)
{
    uint32_t first = 0;
    return nck_link_join(&link_, overlap * UNIT, lead * UNIT, most, &first);
}

static uint32_t end_now(void)
{
    int entered = 0;
    return nck_link_end(&link_, &entered);
}

// The next cell; its seg as a check.
static nck_cell_t take(check_t *check, uint32_t seg)
{
    nck_cell_t cell;
    int from_tail = 0;
    memset(&cell, 0, sizeof cell);
    CHECK_INT(check, nck_link_take(&link_, &cell, &from_tail), NCK_OK);
    CHECK_INT(check, cell.seg, seg);
    CHECK_INT(check, from_tail, 0);
    return cell;
}

static nck_status_t take_rider(check_t *check, uint32_t seg)
{
    nck_cell_t cell;
    const nck_status_t status = nck_link_take_rider(&link_, &cell);
    if (status == NCK_OK) CHECK_INT(check, cell.seg, seg);
    return status;
}

// The cell in which the other plan begins is parted there.
static void cells_ride_from_where_the_other_plan_begins(check_t *check)
{
    uint32_t first = 0;
    begin(check, 1);
    CHECK_INT(check, nck_link_join(&link_, 2.25 * UNIT, NO_LEAD, 3, &first), NCK_OK);
    CHECK_INT(check, first, 5);
    CHECK_INT(check, end_now(), 6);
    const uint32_t segs[] = {100, 101, 101, 102, 103, 200};
    const double durations[] = {1.0, 0.75, 0.25, 1.0, 1.0, 1.0};
    const int stops[] = {0, 0, NCK_STOP_RIDES, NCK_STOP_RIDES, NCK_STOP_RIDES | NCK_STOP_REST, 0};
    for (int k = 0; k < 6; k++) {
        const nck_cell_t *const cell = &link_.cell[k];
        CHECK_INT(check, cell->seg, segs[k]);
        CHECK_INT(check, cell->stop, stops[k]);
        CHECK(check, cell->duration == durations[k] * UNIT);
        CHECK(check, cell->length == 64.0 * cell->duration);
    }
    CHECK(check, link_.cell[2].s == link_.cell[1].s + link_.cell[1].length);
    CHECK(check, nck_link_tail_cell(&link_, 6) && nck_link_tail_cell(&link_, 6)->seg == 201);
}

static void no_cell_is_parted_where_two_meet(check_t *check)
{
    uint32_t first = 0;
    begin(check, 2);
    CHECK_INT(check, nck_link_join(&link_, 2.0 * UNIT, NO_LEAD, 3, &first), NCK_OK);
    CHECK_INT(check, first, 4);
    CHECK_INT(check, link_.cell[1].stop, 0);
    CHECK_INT(check, link_.cell[2].stop, NCK_STOP_RIDES);
    CHECK_INT(check, link_.cell[3].stop, NCK_STOP_RIDES | NCK_STOP_REST);
}

// What rides takes no time of its own, neither when it is final nor when it is taken.
static void lead_is_the_time_until_both_have_ended(check_t *check)
{
    begin(check, 1);
    CHECK_INT(check, join(2.25, 3.75, 3), NCK_OK); // 1.75, and two of the other plan
    CHECK_INT(check, end_now(), 7);
    CHECK(check, nck_link_lead(&link_) == 3.75 * UNIT);
    (void)take(check, 100);
    (void)take(check, 101);
    CHECK(check, nck_link_lead(&link_) == 2.0 * UNIT);
    (void)take(check, 101);
    nck_link_ride(&link_);
    CHECK(check, nck_link_lead(&link_) == 2.0 * UNIT);
    (void)take(check, 200);
    CHECK(check, nck_link_lead(&link_) == UNIT);
    CHECK_INT(check, nck_link_advance(&link_, 9.0, 9), NCK_OK);
    CHECK(check, nck_link_lead(&link_) == 2.0 * UNIT);
}

static void no_more_than_most_becomes_final_of_the_other_plan(check_t *check)
{
    begin(check, 1);
    CHECK_INT(check, join(2.25, 9.0, 2), NCK_OK);
    CHECK_INT(check, end_now(), 5 + 2);
}

// The tick goes on behind the rest, and takes what rides when it likes: until then it is kept.
static void what_rides_keeps_its_place_until_it_is_taken(check_t *check)
{
    begin(check, 1);
    CHECK_INT(check, join(2.25, NO_LEAD, 3), NCK_OK);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 6);
    (void)take(check, 100);
    (void)take(check, 101);
    CHECK_INT(check, take_rider(check, 0), NCK_EMPTY);
    CHECK(check, take(check, 101).stop & NCK_STOP_RIDES);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 3);
    nck_link_ride(&link_);
    CHECK_INT(check, nck_link_waiting(&link_), 1);
    (void)take(check, 200);
    CHECK_INT(check, nck_link_waiting(&link_), 0);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 3);
    CHECK_INT(check, take_rider(check, 102), NCK_OK);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 2);
    CHECK_INT(check, take_rider(check, 103), NCK_OK);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX);
    CHECK_INT(check, take_rider(check, 0), NCK_EMPTY);
}

static void one_that_rides_alone_keeps_no_place(check_t *check)
{
    begin(check, 3);
    CHECK_INT(check, join(1.0, NO_LEAD, 3), NCK_OK);
    for (uint32_t k = 100; k < 104; k++) (void)take(check, k);
    nck_link_ride(&link_);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 1);
    CHECK_INT(check, take_rider(check, 0), NCK_EMPTY);
    (void)take(check, 200);
}

// Round the ring: nothing is lost, neither of what rides nor beside it.
static void plans_join_round_the_ring(check_t *check)
{
    begin(check, 2);
    for (uint32_t n = 0; n < 2 * NCK_CELL_MAX; n++) {
        CHECK_INT(check, join(1.5, NO_LEAD, 1), NCK_OK); // two of three cells are left
        const uint32_t name = n == 0 ? 101 : 200;
        if (n == 0) (void)take(check, 100);
        (void)take(check, name);
        (void)take(check, name + 1);
        (void)take(check, name + 1);
        nck_link_ride(&link_);
        CHECK_INT(check, take_rider(check, name + 2), NCK_OK);
        CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX - 1);
        build(200, 3);
    }
}

// The cells that are left, a parted one, and one of the other plan; nothing changes without.
static void join_waits_for_room(check_t *check)
{
    nck_link_init(&link_);
    build(0, NCK_CELL_MAX - 1);
    CHECK_INT(check, nck_link_install(&link_, 9.0, NCK_CELL_MAX - 3), NCK_OK);
    build(200, 3);
    const double lead = nck_link_lead(&link_);
    CHECK_INT(check, nck_link_cell_room(&link_), 3);
    CHECK_INT(check, join(0.5, NO_LEAD, 3), NCK_FULL);
    CHECK_INT(check, end_now(), NCK_CELL_MAX - 3);
    CHECK_INT(check, nck_link_cell_room(&link_), 3);
    CHECK(check, nck_link_lead(&link_) == lead);
    (void)take(check, 0);
    CHECK_INT(check, join(0.5, NO_LEAD, 3), NCK_OK);
    CHECK_INT(check, nck_link_cell_room(&link_), 0);
    for (uint32_t k = 1; k + 1 < NCK_CELL_MAX; k++) (void)take(check, k);
    (void)take(check, NCK_CELL_MAX - 2);
    nck_link_ride(&link_);
    (void)take(check, 200);
}

// The tick is in the rest of the plan before: it will have come to rest where the other one begins.
static void nothing_joins_a_tail_in_use(check_t *check)
{
    nck_cell_t cell;
    int from_tail = 0;
    begin(check, 1);
    (void)take(check, 100);
    CHECK_INT(check, nck_link_take(&link_, &cell, &from_tail), NCK_OK);
    CHECK_INT(check, from_tail, 1);
    CHECK_INT(check, join(1.5, NO_LEAD, 3), NCK_E_STATE); // built before
    build(200, 3);
    CHECK_INT(check, join(1.5, NO_LEAD, 3), NCK_FULL);
    nck_link_tail_rest(&link_);
    CHECK_INT(check, join(1.5, NO_LEAD, 3), NCK_E_STATE);
    CHECK(check, nck_link_lead(&link_) == 0.0);
    CHECK_INT(check, nck_link_install(&link_, 9.0, 3), NCK_OK); // but it may follow
    for (uint32_t k = 200; k < 203; k++) (void)take(check, k);
}

static void what_is_no_number_never_joins(check_t *check)
{
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.v = (double)NAN;
    begin(check, 1);
    nck_link_tail_push(&link_, &cell);
    CHECK_INT(check, join(1.5, NO_LEAD, 3), NCK_E_INTERNAL);
    CHECK_INT(check, end_now(), 1);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, cells_ride_from_where_the_other_plan_begins);
    CHECK_RUN(&check, no_cell_is_parted_where_two_meet);
    CHECK_RUN(&check, lead_is_the_time_until_both_have_ended);
    CHECK_RUN(&check, no_more_than_most_becomes_final_of_the_other_plan);
    CHECK_RUN(&check, what_rides_keeps_its_place_until_it_is_taken);
    CHECK_RUN(&check, one_that_rides_alone_keeps_no_place);
    CHECK_RUN(&check, plans_join_round_the_ring);
    CHECK_RUN(&check, join_waits_for_room);
    CHECK_RUN(&check, nothing_joins_a_tail_in_use);
    CHECK_RUN(&check, what_is_no_number_never_joins);
    return check_end(&check);
}
