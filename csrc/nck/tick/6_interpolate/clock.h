// SPDX-License-Identifier: MIT
// Inside room 6: the tick's own clock. It runs with the periods, until a stop is asked for that no
// plan brings: then the tick slows it by itself, and later lets it set off again. Face:
// interpolate.h.
#ifndef NCK_TICK_CLOCK_H
#define NCK_TICK_CLOCK_H

#include "nck/base/link.h"               // nck_link_t
#include "nck/base/real.h"               // nck_num
#include "nck/base/records.h"            // nck_seg_t nck_cell_t
#include "nck/base/terms.h"              // nck_terms_t
#include "nck/tick/6_interpolate/look.h" // nck_look_place_t

// What the clock does.
typedef enum nck_clock_state {
    NCK_CLOCK_RUNS = 0,    // with the periods
    NCK_CLOCK_BRAKES = 1,  // slows down, as the axes can
    NCK_CLOCK_STANDS = 2,  // the tool rests in the middle of a plan
    NCK_CLOCK_SETS_OFF = 3 // quickens until it runs
} nck_clock_state_t;

// The clock. A plan says s(φ); the tick is at φ = k·T − late.
typedef struct nck_clock {
    uint32_t state;           // nck_clock_state_t; the tick writes
    uint16_t feels;           // for so many periods more: braking, the last corner; setting off,
                              // what came to rest before
    uint8_t follows;          // … 1: the plan, which is slower
    uint8_t kept;             // standing: for so many periods, by a plan that is made
    double late;              // [s]
    union {
        double v;             // braking: of the path [path mm/s]
        double rate;          // setting off: dφ/dt, 0 … 1; along a clocked path a period before
    } first;
    union {
        double a;             // braking: of the path [path mm/s²]
        double gain;          // setting off: d²φ/dt² [1/s]
    } second;
    float jump[NCK_AXIS_MAX]; // braking: by which dp/ds jumps at that corner
    nck_num share;            // along a clocked path: of what k″ may be, what may last
    float j_end;              // … the jerk that takes the last acceleration away [path mm/s³]
} nck_clock_t;

// Begin to brake, where the plan has the speed v and the acceleration a. Cost: constant.
// Context: tick.
void nck_clock_begin(nck_clock_t *self, double v, double a);

// Where the cells stand at the time t from the begin of the cell: all of a place but v and a.
// Cost: linear in the segs of the cell. Context: tick.
void nck_clock_find(const nck_link_t *link, const nck_cell_t *cell, double t,
                    nck_look_place_t *place_out);

// How many periods the tick hands out the mean of on a seg: a clocked path needs no filter.
// Cost: constant. Context: tick.
static inline uint32_t nck_clock_taps(const nck_terms_t *terms, const nck_seg_t *seg) {
    return nck_look_is_clocked(seg) ? 1u : terms->taps;
}

// At s of a clocked seg, whose coordinate goes by the clock: the pose tells the program's
// coordinate by the share of the seg's length, and the tool's own speed. Cost: six tangents.
// Context: tick.
void nck_clock_measure(const nck_seg_t *seg, double s, nck_pose_t *pose);

// The speed and the acceleration that the plan has at the time t from the begin of the cell, at the
// place that was found for it. a_before: of the cell before, where cells are steps; else the
// cell's own. Cost: constant. Context: tick.
void nck_clock_plan(const nck_cell_t *cell, double t, double a_before, nck_look_place_t *place);

// One period of braking from the clock's v and a, which become those behind it: the jerk is the
// least that every axis allows. Returns the way [path mm].
// Cost: linear in the axes; of an arc four sines and cosines. Context: tick.
double nck_clock_brake(nck_clock_t *self, const nck_terms_t *terms,
                       const nck_look_place_t *place);

// Braking goes on from the plan's speed and acceleration, as far as jerk takes that away by the
// rest. Cost: constant. Context: tick.
void nck_clock_follow(nck_clock_t *self, double v, double a);

// Begin to set off. Cost: constant. Context: tick.
void nck_clock_go_on(nck_clock_t *self);

// Nobody asks for rest: a clock that stands goes on; if it is kept, since a plan is made, behind
// 250 periods of that at the latest. Cost: constant. Context: tick.
void nck_clock_leave(nck_clock_t *self, uint32_t kept);

// One period of setting off, where the plan has the speed v [path mm/s]. Returns how far φ goes on
// [s]. Cost: linear in the axes. Context: tick.
double nck_clock_set_off(nck_clock_t *self, const nck_terms_t *terms, double v);

// How long a cell takes from t on to a place `way` further on, which lies in it [s].
// Cost: constant. Context: tick.
double nck_clock_time(const nck_cell_t *cell, double t, double way);

#endif
