// SPDX-License-Identifier: MIT
// base/link.h: nothing is lost, nothing is taken back, the stop tail is entered at most once, and
// plans become final cell by cell.
#include <string.h> // memset

#include "check.h"
#include "nck/base/link.h" // nck_link_t

static nck_link_t link_;

static nck_cell_t cell_of(uint32_t seg)
{
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.seg = seg;
    return cell;
}

static void put_batch(uint32_t first, uint32_t count, uint32_t tail)
{
    nck_link_batch_begin(&link_);
    for (uint32_t k = 0; k < count; k++) {
        const nck_cell_t cell = cell_of(first + k);
        nck_link_push_cell(&link_, &cell);
    }
    nck_link_tail_begin(&link_);
    for (uint32_t k = 0; k < tail; k++) {
        const nck_cell_t cell = cell_of(1000 + first + count + k);
        nck_link_tail_push(&link_, &cell);
    }
}

static long take(int *from_tail)
{
    nck_cell_t cell;
    return nck_link_take(&link_, &cell, from_tail) == NCK_OK ? (long)cell.seg : -1;
}

static void cells_come_out_in_order_round_the_ring(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    uint32_t out = 0;
    for (uint32_t in = 0; in < 20 * NCK_CELL_MAX; in += 5) {
        put_batch(in, 5, 2);
        CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
        while (nck_link_cell_room(&link_) < 5) {
            CHECK_INT(check, take(&from_tail), out);
            out++;
        }
    }
    CHECK(check, out > 10 * NCK_CELL_MAX);
}

// Numbers that no cell may have, in each of its places.
static void what_is_no_number_is_never_published(check_t *check)
{
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    int from_tail = 0;
    for (int k = 0; k < 6 * 3; k++) {
        nck_cell_t cell = cell_of(0);
        double *const number[] = {&cell.s, &cell.length, &cell.v, &cell.a, &cell.j, &cell.duration};
        *number[k % 6] = bad[k / 6];
        nck_link_init(&link_);
        link_.seg[0].line = 7;
        put_batch(0, 3, 2);
        CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
        nck_link_tail_begin(&link_);
        nck_link_tail_push(&link_, &cell);
        CHECK_INT(check, nck_link_install(&link_, 1.0, 1), NCK_E_INTERNAL);
        CHECK_INT(check, nck_link_broken_line(&link_), 7);
        put_batch(0, 1, 1);
        CHECK_INT(check, nck_link_publish(&link_), NCK_E_INTERNAL);
        for (int n = 0; n < 3; n++) CHECK_INT(check, take(&from_tail), n);
        CHECK_INT(check, take(&from_tail), 1003);
        CHECK(check, from_tail);
    }
}

static void batch_is_invisible_until_it_is_published(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 3, 0);
    CHECK_INT(check, nck_link_waiting(&link_), 0);
    CHECK_INT(check, take(&from_tail), -1);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, nck_link_waiting(&link_), 3);
    CHECK_INT(check, take(&from_tail), 0);
}

static void tail_is_entered_only_when_the_cells_are_used_up(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 2, 2);
    nck_link_publish(&link_);
    CHECK_INT(check, take(&from_tail), 0);
    CHECK_INT(check, take(&from_tail), 1);
    CHECK_INT(check, from_tail, 0);
    CHECK_INT(check, take(&from_tail), 1002);
    CHECK_INT(check, from_tail, 1);
    CHECK_INT(check, take(&from_tail), 1003);
    CHECK_INT(check, take(&from_tail), -1);
}

static void tick_first_makes_the_batch_void(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 1, 2);
    nck_link_publish(&link_);
    put_batch(1, 4, 2); // built on the cell, while the tick ...
    take(&from_tail);
    CHECK_INT(check, take(&from_tail), 1001); // ... enters the tail
    CHECK_INT(check, nck_link_publish(&link_), NCK_E_STATE);
    CHECK_INT(check, nck_link_batch_begin(&link_), 1);
    CHECK_INT(check, take(&from_tail), 1002);
    CHECK_INT(check, take(&from_tail), -1);
}

static void prep_first_keeps_the_tick_out_of_the_tail(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 1, 2);
    nck_link_publish(&link_);
    take(&from_tail);
    put_batch(1, 1, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, take(&from_tail), 1);
    CHECK_INT(check, from_tail, 0);
    CHECK_INT(check, take(&from_tail), -1);
}

static void going_on_waits_until_the_tail_has_come_to_rest(check_t *check)
{
    int from_tail = 0;
    uint32_t count = 0;
    nck_link_init(&link_);
    put_batch(0, 1, 2);
    nck_link_publish(&link_);
    take(&from_tail);
    take(&from_tail);
    CHECK(check, nck_link_tail_end(&link_, &count)->seg == 1002 && count == 2);
    put_batch(7, 1, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_FULL);
    CHECK_INT(check, take(&from_tail), 1002);
    nck_link_tail_rest(&link_);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, take(&from_tail), 7);
    CHECK_INT(check, from_tail, 0);
}

// The stop may lie before the tail's last cell; what comes behind it is prep's to write.
static void nothing_of_a_tail_at_rest_is_taken(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 1, 3);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, take(&from_tail), 0);
    CHECK_INT(check, take(&from_tail), 1001);
    nck_link_tail_rest(&link_);
    CHECK_INT(check, take(&from_tail), -1);
    put_batch(7, 1, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, take(&from_tail), 7);
}

static void outputs_wait_for_their_segs(check_t *check)
{
    nck_output_t output;
    memset(&output, 0, sizeof output);
    nck_link_init(&link_);
    output.after_segs = 2;
    nck_link_push_output(&link_, &output);
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_EMPTY);
    nck_link_seg_finish(&link_, 1);
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_EMPTY);
    nck_link_seg_finish(&link_, 2);
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_OK);
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_EMPTY);
}

static void rings_say_when_they_are_full(check_t *check)
{
    nck_seg_t seg;
    nck_output_t output;
    memset(&seg, 0, sizeof seg);
    memset(&output, 0, sizeof output);
    nck_link_init(&link_);
    for (uint32_t k = 0; k < NCK_SEG_MAX; k++) {
        seg.seq = k;
        CHECK_INT(check, nck_link_push_seg(&link_, &seg), NCK_OK);
    }
    CHECK_INT(check, nck_link_has_room(&link_), 0);
    CHECK_INT(check, nck_link_push_seg(&link_, &seg), NCK_FULL);
    nck_link_seg_finish(&link_, 1);
    CHECK_INT(check, nck_link_has_room(&link_), 1);
    for (uint32_t k = 0; k < NCK_OUTPUT_MAX; k++) {
        CHECK_INT(check, nck_link_push_output(&link_, &output), NCK_OK);
    }
    CHECK_INT(check, nck_link_push_output(&link_, &output), NCK_FULL);
    CHECK_INT(check, nck_link_has_room(&link_), 0);
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_OK);
    CHECK_INT(check, nck_link_has_room(&link_), 1);
    CHECK_INT(check, nck_link_seg(&link_, 5)->seq, 5);
}

static void link_is_empty_without_a_cell_and_an_output(check_t *check)
{
    nck_output_t output;
    int from_tail = 0;
    memset(&output, 0, sizeof output);
    nck_link_init(&link_);
    CHECK(check, nck_link_is_empty(&link_));
    put_batch(0, 1, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK(check, !nck_link_is_empty(&link_));
    CHECK_INT(check, take(&from_tail), 0);
    CHECK(check, nck_link_is_empty(&link_));
    CHECK_INT(check, nck_link_push_output(&link_, &output), NCK_OK);
    CHECK(check, !nck_link_is_empty(&link_));
    CHECK_INT(check, nck_link_take_output(&link_, &output), NCK_OK);
    CHECK(check, nck_link_is_empty(&link_));
}

// A plan as prep lays it: cells of 1 ms, their seg telling which plan and which cell.
static nck_status_t install(uint32_t name, uint32_t count, double lead, uint32_t most)
{
    nck_link_tail_begin(&link_);
    for (uint32_t k = 0; k < count; k++) {
        nck_cell_t cell = cell_of(name + k);
        cell.duration = 1e-3;
        nck_link_tail_push(&link_, &cell);
    }
    return nck_link_install(&link_, lead, most);
}

static uint32_t end_now(void)
{
    int entered = 0;
    return nck_link_end(&link_, &entered);
}

static void begin_plans(void)
{
    nck_link_init(&link_);
    (void)nck_link_batch_begin(&link_);
}

static void plan_becomes_final_as_far_as_lead_and_most_allow(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 10, 2.5e-3, 8), NCK_OK);
    CHECK_INT(check, end_now(), 3);
    CHECK_INT(check, nck_link_advance(&link_, 2.5e-3, 5), NCK_FULL);
    CHECK_INT(check, take(&from_tail), 100);
    CHECK_INT(check, nck_link_advance(&link_, 2.5e-3, 5), NCK_OK);
    CHECK_INT(check, end_now(), 4);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 2), NCK_OK); // no more than two
    CHECK_INT(check, end_now(), 6);
    for (long k = 101; k < 106; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 0);
}

static void rest_of_the_plan_is_the_tail(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 6, 2e-3, 6), NCK_OK);
    CHECK_INT(check, take(&from_tail), 100);
    CHECK_INT(check, nck_link_advance(&link_, 2e-3, 6), NCK_OK);
    for (long k = 101; k < 103; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 0);
    for (long k = 103; k < 106; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 1);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 6), NCK_E_STATE);
    CHECK_INT(check, take(&from_tail), -1);
}

static void plan_follows_on_the_final_cells_of_the_last(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 6, 2e-3, 6), NCK_OK);
    CHECK_INT(check, install(200, 4, 2e-3, 4), NCK_OK); // one cell at least, whatever waits
    CHECK_INT(check, end_now(), 3);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 99), NCK_OK);
    const long want[] = {100, 101, 200, 201, 202, 203, -1};
    for (int k = 0; k < 7; k++) CHECK_INT(check, take(&from_tail), want[k]);
    CHECK_INT(check, from_tail, 0);
}

static void plan_in_a_tail_in_use_waits_for_its_rest(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 3, 1e-3, 3), NCK_OK);
    for (long k = 100; k < 102; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 1);
    CHECK_INT(check, install(200, 3, 1e-3, 3), NCK_FULL);
    CHECK_INT(check, take(&from_tail), 102);
    nck_link_tail_rest(&link_);
    CHECK_INT(check, nck_link_install(&link_, 1e-3, 3), NCK_OK); // kept meanwhile
    CHECK_INT(check, take(&from_tail), 200);
    CHECK_INT(check, from_tail, 0);
}

static void plan_waits_for_room_in_the_ring(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, NCK_CELL_MAX, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, nck_link_cell_room(&link_), 0);
    CHECK_INT(check, install(NCK_CELL_MAX, 3, 1.0, 3), NCK_FULL);
    for (long k = 0; k < 2; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, nck_link_install(&link_, 1.0, 3), NCK_OK); // two of it find room
    CHECK_INT(check, nck_link_cell_room(&link_), 0);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 3), NCK_FULL);
    for (long k = 2; k < NCK_CELL_MAX + 2; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 0);
    CHECK_INT(check, take(&from_tail), NCK_CELL_MAX + 2);
    CHECK_INT(check, from_tail, 1);
}

static void plan_that_is_all_final_goes_no_further(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 2, 1.0, 2), NCK_OK);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 2), NCK_FULL);
    CHECK_INT(check, end_now(), 2);
    for (long k = 100; k < 102; k++) CHECK_INT(check, take(&from_tail), k);
    CHECK_INT(check, from_tail, 0);
    CHECK_INT(check, take(&from_tail), -1);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 2), NCK_FULL);
}

// Even where the tail has come to rest meanwhile: the plan goes on from where the path left it.
static void plan_from_before_the_tail_is_void(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    CHECK_INT(check, install(100, 4, 1e-3, 4), NCK_OK);
    nck_link_tail_begin(&link_);
    const nck_cell_t early = cell_of(201);
    nck_link_tail_push(&link_, &early);
    for (long k = 100; k < 104; k++) CHECK_INT(check, take(&from_tail), k);
    nck_link_tail_rest(&link_);
    CHECK_INT(check, nck_link_install(&link_, 1e-3, 1), NCK_E_STATE);
    CHECK_INT(check, take(&from_tail), -1);
    CHECK_INT(check, install(300, 2, 1e-3, 2), NCK_OK);
    CHECK_INT(check, take(&from_tail), 300);
}

// Sums of tenths and their differences leave a rest of rounding, an empty ring none.
static void lead_is_the_time_that_waits(check_t *check)
{
    const double durations[] = {0.1, 0.2, 0.3};
    int from_tail = 0;
    begin_plans();
    CHECK(check, nck_link_lead(&link_) == 0.0);
    nck_link_tail_begin(&link_);
    for (uint32_t k = 0; k < 3; k++) {
        nck_cell_t cell = cell_of(k);
        cell.duration = durations[k];
        nck_link_tail_push(&link_, &cell);
    }
    CHECK_INT(check, nck_link_install(&link_, 0.0, 3), NCK_OK);
    CHECK_NEAR(check, nck_link_lead(&link_), 0.1, 1e-15);
    CHECK_INT(check, nck_link_advance(&link_, 1.0, 3), NCK_OK);
    CHECK_NEAR(check, nck_link_lead(&link_), 0.6, 1e-15);
    CHECK_INT(check, take(&from_tail), 0);
    CHECK_NEAR(check, nck_link_lead(&link_), 0.5, 1e-15);
    CHECK_INT(check, take(&from_tail), 1);
    CHECK_INT(check, take(&from_tail), 2);
    CHECK(check, nck_link_lead(&link_) == 0.0);
}

static void cells_of_a_plan_are_found_by_their_count(check_t *check)
{
    begin_plans();
    nck_link_tail_begin(&link_);
    CHECK(check, nck_link_built_cell(&link_, 0) == NULL);
    CHECK_INT(check, install(100, 5, 2e-3, 5), NCK_OK);
    for (uint32_t k = 0; k < 5; k++) {
        const nck_cell_t *const cell = nck_link_tail_cell(&link_, k);
        CHECK(check, cell && cell->seg == 100 + k);
    }
    CHECK(check, nck_link_tail_cell(&link_, 5) == NULL);
    CHECK(check, nck_link_tail_cell(&link_, NCK_LINK_COUNT_MASK) == NULL);
    nck_link_tail_begin(&link_);
    const nck_cell_t built = cell_of(7);
    nck_link_tail_push(&link_, &built);
    CHECK(check, nck_link_built_cell(&link_, 0) && nck_link_built_cell(&link_, 0)->seg == 7);
    CHECK(check, nck_link_built_cell(&link_, 1) == NULL);
}

static void plans_come_out_in_order_round_the_ring(check_t *check)
{
    int from_tail = 0;
    begin_plans();
    uint32_t out = 0;
    for (uint32_t n = 0; n < 10 * NCK_CELL_MAX; n++) {
        CHECK_INT(check, install(3 * n, 5, 0.0, 1), NCK_OK); // one cell, then two, then a new plan
        CHECK_INT(check, nck_link_advance(&link_, 1.0, 2), NCK_OK);
        while (nck_link_waiting(&link_) > 2) CHECK_INT(check, take(&from_tail), out++);
    }
    CHECK(check, out > 20 * NCK_CELL_MAX && from_tail == 0);
}

// A length or a duration below zero, each on its own; one such cell is enough.
static void a_cell_that_goes_back_is_never_published(check_t *check)
{
    for (int k = 0; k < 3; k++) {
        nck_cell_t cell = cell_of(0);
        if (k != 1) cell.length = -1e-9;
        if (k != 0) cell.duration = -1e-9;
        nck_link_init(&link_);
        nck_link_batch_begin(&link_);
        for (int n = 0; n <= k; n++) nck_link_push_cell(&link_, &cell);
        nck_link_tail_begin(&link_);
        CHECK_INT(check, nck_link_publish(&link_), NCK_E_INTERNAL);
    }
}

static void a_link_is_spent_when_its_tail_rests(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    CHECK(check, nck_link_is_spent(&link_));
    put_batch(0, 1, 1);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK(check, !nck_link_is_spent(&link_));
    CHECK_INT(check, take(&from_tail), 0);
    CHECK(check, !nck_link_is_spent(&link_)); // a tail not entered
    CHECK_INT(check, take(&from_tail), 1001);
    CHECK(check, !nck_link_is_spent(&link_)); // entered, on its way
    nck_link_tail_rest(&link_);
    CHECK(check, nck_link_is_spent(&link_));
}

static void what_will_be_taken_is_seen_before(check_t *check)
{
    int from_tail = 0;
    nck_link_init(&link_);
    put_batch(0, 2, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, nck_link_ahead(&link_, nck_link_word(&link_), 1)->seg, 1);
    CHECK(check, !nck_link_ahead(&link_, nck_link_word(&link_), 2)); // no tail
    put_batch(2, 1, 3);
    const uint32_t before = nck_link_word(&link_);
    CHECK(check, nck_link_holds(&link_, before));
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK(check, !nck_link_holds(&link_, before));
    for (long taken = 0; taken < 6; taken++) { // the last three from the tail
        const uint32_t word = nck_link_word(&link_);
        for (long n = 0; n < 7; n++) {
            const nck_cell_t *const cell = nck_link_ahead(&link_, word, (uint32_t)n);
            if (taken + n < 6) CHECK_INT(check, cell->seg, taken + n + (taken + n < 3 ? 0 : 1000));
            else CHECK(check, !cell);
        }
        (void)take(&from_tail);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, cells_come_out_in_order_round_the_ring);
    CHECK_RUN(&check, what_is_no_number_is_never_published);
    CHECK_RUN(&check, batch_is_invisible_until_it_is_published);
    CHECK_RUN(&check, tail_is_entered_only_when_the_cells_are_used_up);
    CHECK_RUN(&check, tick_first_makes_the_batch_void);
    CHECK_RUN(&check, prep_first_keeps_the_tick_out_of_the_tail);
    CHECK_RUN(&check, going_on_waits_until_the_tail_has_come_to_rest);
    CHECK_RUN(&check, nothing_of_a_tail_at_rest_is_taken);
    CHECK_RUN(&check, outputs_wait_for_their_segs);
    CHECK_RUN(&check, rings_say_when_they_are_full);
    CHECK_RUN(&check, link_is_empty_without_a_cell_and_an_output);
    CHECK_RUN(&check, plan_becomes_final_as_far_as_lead_and_most_allow);
    CHECK_RUN(&check, rest_of_the_plan_is_the_tail);
    CHECK_RUN(&check, plan_follows_on_the_final_cells_of_the_last);
    CHECK_RUN(&check, plan_in_a_tail_in_use_waits_for_its_rest);
    CHECK_RUN(&check, plan_waits_for_room_in_the_ring);
    CHECK_RUN(&check, plan_that_is_all_final_goes_no_further);
    CHECK_RUN(&check, plan_from_before_the_tail_is_void);
    CHECK_RUN(&check, lead_is_the_time_that_waits);
    CHECK_RUN(&check, cells_of_a_plan_are_found_by_their_count);
    CHECK_RUN(&check, plans_come_out_in_order_round_the_ring);
    CHECK_RUN(&check, a_cell_that_goes_back_is_never_published);
    CHECK_RUN(&check, a_link_is_spent_when_its_tail_rests);
    CHECK_RUN(&check, what_will_be_taken_is_seen_before);
    return check_end(&check);
}
