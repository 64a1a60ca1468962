// SPDX-License-Identifier: MIT
// Traffic over the link, and the rules that it keeps.
#include "traffic.h"

#include <string.h> // memset

enum {
    SEG_PLACES = 4, SEGS_AHEAD = 8,
    BATCH_MOST = 7, TAIL_MOST = 9,
    PLAN_MOST = 16, LEAD_MOST = 12, ADVANCES = 3 // of a plan
};

// A linear congruential generator (Knuth, The Art of Computer Programming 2, 3.3.4): its upper bits
// are good enough for sizes that only have to differ.
uint32_t traffic_below(uint32_t *seed, uint32_t limit) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 16) % limit;
}

static void blame(const char **fault, int good, const char *rule) {
    if (!good && !*fault) *fault = rule;
}

static void make_cell(nck_cell_t *cell, uint32_t place, uint32_t from_tail) {
    memset(cell, 0, sizeof *cell);
    cell->seg = place / SEG_PLACES;
    cell->limit = (uint8_t)from_tail;
    cell->last = place % SEG_PLACES == SEG_PLACES - 1;
    cell->s = place;
    cell->length = 1.0;
    cell->v = place;
    cell->duration = 1.0;
}

static void make_seg(nck_seg_t *seg, uint32_t seq) {
    memset(seg, 0, sizeof *seg);
    seg->seq = seq;
    seg->line = ~seq;
    seg->s_begin = seq;
    seg->dwell_s = seq;
}

// Outputs are due soon, so that the tick mostly waits for the next one to be pushed.
static void push_output(nck_link_t *link, traffic_prep_t *prep) {
    const nck_output_t output = {prep->final / SEG_PLACES, ~prep->outputs, 0, 0, prep->outputs};
    if (!nck_link_has_room(link)) return;
    const nck_status_t status = nck_link_push_output(link, &output);
    blame(&prep->fault, status == NCK_OK, "an output finds the room it was promised");
    prep->outputs++;
}

static void push_segs(nck_link_t *link, traffic_prep_t *prep) {
    while (prep->segs < prep->final / SEG_PLACES + SEGS_AHEAD && nck_link_has_room(link)) {
        nck_seg_t seg;
        make_seg(&seg, prep->segs);
        const nck_status_t status = nck_link_push_seg(link, &seg);
        blame(&prep->fault, status == NCK_OK, "a seg finds the room it was promised");
        prep->segs++;
    }
}

static int has_seg(const traffic_prep_t *prep, uint32_t place) {
    return place / SEG_PLACES < prep->segs;
}

static void fill_batch(nck_link_t *link, traffic_prep_t *prep) {
    uint32_t room = nck_link_cell_room(link);
    for (uint32_t n = 1 + traffic_below(&prep->seed, BATCH_MOST); n > 0 && room > 0; n--) {
        nck_cell_t cell;
        if (!has_seg(prep, prep->place)) return;
        make_cell(&cell, prep->place, 0);
        nck_link_push_cell(link, &cell);
        prep->place++;
        room--;
    }
}

static void fill_tail(nck_link_t *link, traffic_prep_t *prep, uint32_t count) {
    uint32_t place = prep->place;
    nck_link_tail_begin(link);
    for (uint32_t n = count; n > 0 && has_seg(prep, place); n--) {
        nck_cell_t cell;
        make_cell(&cell, place, 1);
        nck_link_tail_push(link, &cell);
        place++;
    }
}

static void count_outcome(traffic_prep_t *prep, nck_status_t status) {
    prep->batches += status == NCK_OK;
    prep->losses += status == NCK_E_STATE;
}

// The linear slope's way: a batch of cells, and behind it a tail.
static void prepare_batch(nck_link_t *link, traffic_prep_t *prep) {
    const uint32_t begin = prep->place;
    fill_batch(link, prep);
    if (prep->place == begin) return; // a batch has one cell at least
    fill_tail(link, prep, traffic_below(&prep->seed, TAIL_MOST + 1));
    nck_status_t status = nck_link_publish(link);
    while (status == NCK_FULL) status = nck_link_publish(link); // until the tail is at rest
    if (status == NCK_OK) prep->final = prep->place;
    count_outcome(prep, status);
}

static double some_lead(traffic_prep_t *prep) { return traffic_below(&prep->seed, LEAD_MOST + 1); }

static void check_plan(const nck_link_t *link, traffic_prep_t *prep) {
    int entered = 0;
    const uint32_t end = nck_link_end(link, &entered);
    const nck_cell_t *const next = nck_link_tail_cell(link, end);
    blame(&prep->fault, !next || next->s == prep->final, "a plan goes on where the ring ends");
}

// The jerk-limited slope's way: a whole plan to rest, made final from its beginning on.
static void prepare_plan(nck_link_t *link, traffic_prep_t *prep) {
    int entered = 0;
    uint32_t end = nck_link_end(link, &entered);
    if (!has_seg(prep, prep->place)) return;
    fill_tail(link, prep, 1 + traffic_below(&prep->seed, PLAN_MOST));
    const uint32_t begin = prep->place;
    nck_status_t status = nck_link_install(link, some_lead(prep), BATCH_MOST);
    while (status == NCK_FULL) status = nck_link_install(link, some_lead(prep), BATCH_MOST);
    count_outcome(prep, status);
    if (status != NCK_OK) return;
    prep->final = begin;
    for (int n = 0; n <= ADVANCES && status != NCK_E_STATE; n++) {
        const uint32_t before = end;
        end = nck_link_end(link, &entered);
        prep->final += end - before;
        check_plan(link, prep);
        if (n < ADVANCES) status = nck_link_advance(link, some_lead(prep), BATCH_MOST);
    }
    prep->losses += status == NCK_E_STATE;
}

void traffic_prepare(nck_link_t *link, traffic_prep_t *prep) {
    push_output(link, prep);
    push_segs(link, prep);
    prep->place = prep->final;
    if (nck_link_batch_begin(link)) {
        uint32_t count = 0;
        const nck_cell_t *const end = nck_link_tail_end(link, &count);
        blame(&prep->fault, count > 0, "a tail that was entered has cells");
        if (count > 0) prep->place = (uint32_t)end->s + 1;
    }
    if (prep->plans) {
        prepare_plan(link, prep);
    } else {
        prepare_batch(link, prep);
    }
}

static void look_at(const nck_link_t *link, traffic_tick_t *tick, const nck_cell_t *cell) {
    const nck_seg_t *const seg = nck_link_seg(link, cell->seg);
    blame(&tick->fault, cell->s == tick->place, "cells follow one another on the path");
    blame(&tick->fault, cell->v == cell->s && cell->length == 1.0, "a cell is whole");
    blame(&tick->fault, cell->seg == tick->place / SEG_PLACES, "a cell names its seg");
    blame(&tick->fault, seg->seq == cell->seg && seg->line == ~cell->seg, "a seg is whole");
    blame(&tick->fault, seg->dwell_s == seg->seq && seg->s_begin == seg->seq, "a seg is whole");
}

static void take_cell(nck_link_t *link, traffic_tick_t *tick) {
    nck_cell_t cell;
    int from_tail = 0;
    if (nck_link_take(link, &cell, &from_tail) != NCK_OK) {
        if (tick->braking && !tick->rested) nck_link_tail_rest(link);
        tick->rested = tick->braking;
        return;
    }
    const uint32_t is_tail = from_tail ? 1u : 0u;
    blame(&tick->fault, cell.limit <= is_tail || tick->plans, "a tail is told from what is final");
    blame(&tick->fault, is_tail || !tick->braking || tick->rested, "a tail is left at rest only");
    tick->tails += is_tail && (!tick->braking || tick->rested);
    tick->braking = is_tail;
    tick->rested = 0;
    look_at(link, tick, &cell);
    tick->cells++;
    tick->place++;
    if (cell.last) nck_link_seg_finish(link, cell.seg + 1);
}

static void take_outputs(nck_link_t *link, traffic_tick_t *tick) {
    nck_output_t output;
    while (nck_link_take_output(link, &output) == NCK_OK) {
        const int is_due = output.after_segs <= tick->place / SEG_PLACES;
        blame(&tick->fault, output.value == tick->outputs, "outputs come in order");
        blame(&tick->fault, output.line == ~tick->outputs, "an output is whole");
        blame(&tick->fault, is_due, "an output waits for its segs");
        tick->outputs++;
    }
}

void traffic_consume(nck_link_t *link, traffic_tick_t *tick) {
    take_cell(link, tick);
    take_outputs(link, tick);
}
