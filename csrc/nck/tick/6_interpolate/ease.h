// SPDX-License-Identifier: MIT
// Inside room 6: how the tick brakes along a clocked path, and sets off again. It slows down the
// plan's own time or quickens it, never so hard that it could not ease off again. README, "The
// clock".
#ifndef NCK_TICK_EASE_H
#define NCK_TICK_EASE_H

#include "nck/base/link.h"                // nck_link_t
#include "nck/base/records.h"             // nck_cell_t
#include "nck/base/terms.h"               // nck_terms_t
#include "nck/tick/6_interpolate/clock.h" // nck_clock_t
#include "nck/tick/6_interpolate/stretch.h" // nck_stretch_past_t

// Begin to brake: from the plan's pace, or from that of a clock that sets off.
// Cost: constant. Context: tick.
void nck_ease_begin(nck_clock_t *clock);

// Nobody asks for rest any more: what brakes eases off, and sets off from the pace that is left.
// Cost: constant. Context: tick.
void nck_ease_release(nck_clock_t *clock);

// One period of braking, or of setting off, from the time t in a cell on, behind which the link's
// are: the clock's rate becomes that behind it, 0 where it rests, 1 where it runs from then on.
// Returns how far the plan's time goes on [s].
// past: up to the begin of the period. Cost: a point, 38 looks at a place, 36 of them with 4 bounds
// for every axis that moves and 2 trials, and the cells on the way, twice if prep publishes
// meanwhile; instructions: docs/size.md. Context: tick.
double nck_ease_period(nck_clock_t *clock, const nck_terms_t *terms, nck_link_t *link,
                       const nck_cell_t *cell, double t, const nck_stretch_past_t *past);

// Behind a period: the clock stands, if its rate is 0 and the path goes on; where the path rests
// one that sets off runs, since nothing moves. Cost: constant. Context: tick.
void nck_ease_rest(nck_clock_t *clock, int moves);

#endif
