// SPDX-License-Identifier: MIT
// Traffic over the link, and the rules that it keeps.
#include "traffic.h"

#include <string.h> // memset

enum {
    SEG_PLACES = 4, SEGS_AHEAD = 8,
    BATCH_MOST = 7, TAIL_MOST = 9,
    PLAN_MOST = 16, SKIP_MOST = 5, LEAD_MOST = 12, ADVANCES = 3 // of a plan
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
    seg->shape.dwell_s = seq;
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

static void push_tail(nck_link_t *link, uint32_t place) {
    nck_cell_t cell;
    make_cell(&cell, place, 1);
    nck_link_tail_push(link, &cell);
}

static void count_outcome(traffic_prep_t *prep, nck_status_t status) {
    prep->batches += status == NCK_OK;
    prep->losses += status == NCK_E_STATE;
}

// Where the path goes on: behind the final cells, or where the tail comes to rest.
static uint32_t next_place(const nck_link_t *link, traffic_prep_t *prep, int entered) {
    uint32_t count = 0;
    const nck_cell_t *const end = nck_link_tail_end(link, &count);
    if (!entered) return prep->final;
    blame(&prep->fault, count > 0, "a tail that was entered has cells");
    return count > 0 ? (uint32_t)end->s + 1 : prep->final;
}

// The linear slope's way: a batch of cells, and behind it a tail.
static void prepare_batch(nck_link_t *link, traffic_prep_t *prep) {
    const uint32_t begin = next_place(link, prep, nck_link_batch_begin(link));
    prep->place = begin;
    fill_batch(link, prep);
    if (prep->place == begin) return; // a batch has one cell at least
    nck_link_tail_begin(link);
    const uint32_t most = prep->way == TRAFFIC_BARE ? 0 : TAIL_MOST;
    const uint32_t end = prep->place + traffic_below(&prep->seed, most + 1);
    for (uint32_t at = prep->place; at < end && has_seg(prep, at); at++) push_tail(link, at);
    nck_status_t status = nck_link_publish(link);
    while (status == NCK_FULL) status = nck_link_publish(link); // until the tail is at rest
    if (status == NCK_OK) prep->final = prep->place;
    count_outcome(prep, status);
}

static double some_lead(traffic_prep_t *prep) { return traffic_below(&prep->seed, LEAD_MOST + 1); }

// See how far the plan has become final. Returns 1 if the tick has left it for its tail.
static int follow(const nck_link_t *link, traffic_prep_t *prep) {
    int entered = 0;
    const uint32_t end = nck_link_end(link, &entered);
    const nck_cell_t *const next = nck_link_tail_cell(link, end);
    prep->final += end - prep->end;
    prep->end = end;
    blame(&prep->fault, prep->in_tail || !next || next->s == prep->final,
          "a plan goes on where the ring ends");
    return entered && !prep->in_tail;
}

// Make more of the plan final, but not beyond a place.
static void advance(nck_link_t *link, traffic_prep_t *prep, uint32_t place) {
    if (prep->in_tail || prep->final >= place) return;
    (void)nck_link_advance(link, some_lead(prep), place - prep->final);
}

// Build a plan from a place on, while what is final comes nearer to it, and install it there.
static nck_status_t install_plan(nck_link_t *link, traffic_prep_t *prep, uint32_t begin) {
    const uint32_t wanted = begin + 1 + traffic_below(&prep->seed, PLAN_MOST);
    uint32_t place = begin;
    nck_link_tail_begin(link);
    while (place < wanted && has_seg(prep, place)) {
        push_tail(link, place);
        place++;
        advance(link, prep, begin);
        if (follow(link, prep)) return NCK_E_STATE;
    }
    nck_status_t status = NCK_FULL;
    while (status != NCK_OK) {
        if (follow(link, prep)) return NCK_E_STATE;
        if (prep->in_tail || prep->final == begin) {
            status = nck_link_install(link, some_lead(prep), BATCH_MOST);
        } else {
            advance(link, prep, begin);
        }
    }
    prep->in_tail = 0;
    prep->final = begin;
    prep->place = place;
    return NCK_OK;
}

// The jerk-limited slope's way: a whole plan to rest, made final from its beginning on; the next
// one goes on from a place within it.
static void prepare_plan(nck_link_t *link, traffic_prep_t *prep) {
    if (follow(link, prep)) {
        prep->rest = next_place(link, prep, 1);
        prep->in_tail = 1;
    }
    const uint32_t skip = traffic_below(&prep->seed, SKIP_MOST + 1);
    const uint32_t within = prep->final + skip < prep->place ? prep->final + skip : prep->place;
    const uint32_t begin = prep->in_tail ? prep->rest : within;
    if (!has_seg(prep, begin)) {
        advance(link, prep, prep->place);
        return;
    }
    const nck_status_t status = install_plan(link, prep, begin);
    count_outcome(prep, status);
    for (int n = 0; n < ADVANCES && status == NCK_OK; n++) {
        if (follow(link, prep)) return;
        advance(link, prep, prep->place);
    }
}

void traffic_prepare(nck_link_t *link, traffic_prep_t *prep) {
    push_output(link, prep);
    push_segs(link, prep);
    if (prep->way == TRAFFIC_PLANS) {
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
    blame(&tick->fault, seg->s_begin == seg->seq, "a seg is whole");
    blame(&tick->fault, seg->shape.dwell_s == seg->seq, "a seg is whole");
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
    blame(&tick->fault, cell.limit <= is_tail || tick->way == TRAFFIC_PLANS,
          "a tail is told from what is final");
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
