// SPDX-License-Identifier: MIT
// Inside room 6: whether prep brings the rest that is asked for, and is there at all. Face:
// interpolate.h.
#ifndef NCK_TICK_WATCH_H
#define NCK_TICK_WATCH_H

#include <stdint.h> // uint32_t

#include "nck/base/records.h" // nck_tick_state_t
#include "nck/base/terms.h"   // nck_terms_t

// What a tick knows of prep.
typedef struct nck_watched {
    int asks;        // 1: somebody asks for rest
    int planned;     // 1: the plan in force brings it
    int at_once;     // 1: the rest is the tick's own: the path is clocked, or it stands
    uint32_t steps;  // of prep so far, modulo 2³²; 0: it has nothing left to do, or has not begun
    int on_tail;     // 1: the tick is on the stop tail
    double v;        // of the last tick [path mm/s]
    // where a rest is asked for, which the filter will show:
    double ahead_v;    // [path mm/s]
    double ahead_gain; // … in a period
} nck_watched_t;

// The watch.
typedef struct nck_watch {
    double v;        // of the last tick as seen one before [path mm/s]
    uint32_t asked;  // periods since a rest has been asked for; 0: none is
    uint32_t most;   // so many are enough for it
    uint32_t steps;  // of prep as last seen, …
    uint32_t unseen; // … and for how many periods it has made none
    uint8_t stops;   // 1: no plan has brought the rest in time, so the tick does
    uint8_t gone;    // 1: prep is gone, so the tick brakes on the tail
    uint8_t back;    // 1: it has done so, and prep is back
} nck_watch_t;

// One period on. Returns as what the tick has to brake by itself: NCK_TICK_HOLD where prep has not
// planned the rest in time, or where that takes too long; NCK_TICK_STARVED on the tail where prep
// is not seen any more; NCK_TICK_IDLE: it need not. Cost: constant; linear in the axes when a rest
// begins to be asked for. Context: tick.
nck_tick_state_t nck_watch_tick(nck_watch_t *self, const nck_terms_t *terms,
                                const nck_watched_t *seen);

#endif
