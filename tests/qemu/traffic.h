// SPDX-License-Identifier: MIT
// Traffic over base/link.h with a rule for every word of it: what prep pushes is a function of its
// place on the path, so that whoever takes it can tell at once what is lost, doubled, torn or taken
// back. One side may interrupt the other at any instruction.
//
//     place      0   1   2   3   4   5   6   7 …      a cell covers one place, a seg four
//     final      ├───┼───┼───┤
//     tail                   ├───┼───┤ rest: the next final cell begins here, if it was entered
#ifndef TRAFFIC_H
#define TRAFFIC_H

#include "nck/base/link.h" // nck_link_t

// How prep publishes.
typedef enum traffic_way {
    TRAFFIC_BATCHES = 0, // the linear slope's: a batch of cells, and a tail behind it
    TRAFFIC_PLANS = 1,   // the jerk-limited slope's: whole plans, made final bit by bit
    TRAFFIC_BARE = 2     // batches without tails: the tick has no word to exchange
} traffic_way_t;

// What prep knows.
typedef struct traffic_prep {
    uint32_t way;     // traffic_way_t
    uint32_t place;   // behind the batch or the plan
    uint32_t final;   // place behind the last final cell
    uint32_t end;     // the same as nck_link_end counts
    uint32_t in_tail; // 1: the tick has left the plan for its tail
    uint32_t rest;    // place where that tail ends
    uint32_t segs;    // pushed
    uint32_t outputs; // pushed
    uint32_t seed;    // of the sizes of batches and tails
    uint32_t batches; // published
    uint32_t losses;  // batches void, because the tick was in the tail first
    const char *fault; // the first broken rule, NULL: none
} traffic_prep_t;

// What the tick knows.
typedef struct traffic_tick {
    uint32_t way;     // as in prep
    uint32_t place;   // where the next cell must begin
    uint32_t outputs; // taken
    uint32_t cells;   // taken
    uint32_t tails;   // entered
    uint32_t rested;  // 1: at the end of a tail
    uint32_t braking; // 1: in a tail
    uint32_t seed;    // of how much is taken at once
    const char *fault; // the first broken rule, NULL: none
} traffic_tick_t;

// The next number of a sequence, 0 … limit - 1. Cost: constant. Context: the seed's.
uint32_t traffic_below(uint32_t *seed, uint32_t limit);

// Push what has room, build a batch with its tail or a plan, and publish it. Context: prep.
void traffic_prepare(nck_link_t *link, traffic_prep_t *prep);

// Take one cell, look at it and its seg, and take the outputs that are due. Context: tick.
void traffic_consume(nck_link_t *link, traffic_tick_t *tick);

#endif
