// SPDX-License-Identifier: MIT
// Inside room 3: segs become one curve within P, window by window: CURVE.md.
#ifndef NCK_PREP_STREAM_H
#define NCK_PREP_STREAM_H

#include "nck/base/motion.h"         // nck_motion_t
#include "nck/base/records.h"        // nck_seg_t
#include "nck/base/status.h"         // nck_status_t
#include "nck/prep/3_smooth/timing.h" // nck_timing_t
#include "nck/prep/3_smooth/fair.h"  // nck_fair_t
#include "nck/prep/3_smooth/track.h" // nck_track_t

// What is asked of it, the same for all runs.
typedef struct nck_stream_wish {
    nck_timing_terms_t terms;
    int rounds;  // clocks a window: 1 … 9
    double gap;  // of the curve: 0.1 is enough
    int most;    // iterations of a clock's plan
} nck_stream_wish_t;

// An interval of the curve: u from 0 to τ, cubic.
typedef struct nck_stream_piece {
    double point[4][NCK_AXIS_MAX]; // control points of the uniform B-spline [mm, deg]
    double s[2];       // of the program, at its begin and its end [path mm]
    uint32_t line;     // the first source line of what its begin is in
    uint32_t block;    // the first block of it
    nck_track_words_t words; // of it
    uint8_t rests;     // bit 0: at its begin, bit 1: at its end
} nck_stream_piece_t;

// What happens next.
typedef enum nck_stream_phase {
    NCK_STREAM_GUESS = 0, // look at places as far ahead as there is room
    NCK_STREAM_KEEP,      // keep what the next clock has of this one
    NCK_STREAM_CLOCK,     // make the clock
    NCK_STREAM_REFERENCE, // control points on the program
    NCK_STREAM_SAMPLES,   // where the curve must be
    NCK_STREAM_FAIR,      // the smoothest one
    NCK_STREAM_NODES,     // its motion: set up
    NCK_STREAM_MOTION,    // solve
    NCK_STREAM_COMPARE,   // is it the clock?
    NCK_STREAM_PROVE,     // is it within P everywhere?
    NCK_STREAM_REST,      // could it come to rest behind what is given?
    NCK_STREAM_GIVE,      // pieces to take
    NCK_STREAM_OVER       // the run has ended
} nck_stream_phase_t;

// What has happened, for who measures it.
typedef struct nck_stream_told {
    uint32_t windows;     // curves that have been smoothed
    uint32_t iterations;  // of them
    uint32_t plans;       // iterations of their plans
    uint32_t again;       // windows that missed P at first
    uint32_t rests;       // that were left out for a rest: none of theirs was within P
    uint32_t restless;    // that had no seam with a rest within P behind it
    uint32_t missed;      // that were given although their proof failed
    double most;          // |r − p|/P that is proven, at most
    uint32_t places;      // of the guess
} nck_stream_told_t;

// The fastest curve of the window so far, by its plan.
typedef struct nck_stream_best {
    int knots;     // 0: none
    int given;
    uint8_t ends;
    nck_num b[NCK_HAS_FASTEST * NCK_FAIR_KNOTS + 1];
    double s[NCK_HAS_FASTEST * NCK_TIMING_CELLS + 1];
    double point[NCK_HAS_FASTEST * NCK_FAIR_KNOTS + 3][NCK_AXIS_MAX];
} nck_stream_best_t;

// The run in work.
typedef struct nck_stream {
    nck_stream_wish_t wish;
    nck_stream_phase_t phase;
    int at;              // interval, point or piece in work
    int leg;             // interval of the rest that is held against the program next
    int round;           // clocks of the window made so far
    int tries;           // curves of it that missed P
    uint8_t sound;       // 1: the curve is the smoothest one, as far as it is sought
    int given;           // intervals of it to give, once it is proven
    int commit;          // the same, when it is: 0 before
    double share;        // of P that samples may use
    double miss;         // |r − p|/P at most, as far as it is proven
    double unit;         // P of the window [mm]
    uint32_t near;       // element where something was found last
    uint8_t halts;       // 1: what is given comes to rest
    double knot_s[3];    // of the program at the seam and the two knots behind it [path mm]
    double seam[3][NCK_AXIS_MAX];                 // control points given last
    double point[NCK_FAIR_POINTS][NCK_AXIS_MAX];  // of the window
    nck_num b[NCK_FAIR_KNOTS + 1];                // of the clock's plan
    nck_num off;         // by so much it is off the clock, as far as they are compared
    int planned;         // 1: b is that of the curve in work, which is the last one
    nck_stream_best_t best;
    int moving;          // axes that move in the window, of axis[]: those that `fair` has
    uint8_t axis[NCK_AXIS_MAX];
    nck_stream_told_t told;
    nck_timing_t clock;
    nck_track_t track;
    union {
        nck_timing_list_t list;
        nck_fair_t fair;
        struct {
            nck_motion_t motion;
            nck_motion_work_t work;
        } plan;
    } work;
} nck_stream_t;

// Begin a run at rest at a point. Cost: constant. Context: prep.
void nck_stream_begin(nck_stream_t *self, const nck_stream_wish_t *wish);

// Add a line, an arc or a helix. Returns NCK_OK; NCK_FULL: step first. Cost: constant.
// Context: prep.
nck_status_t nck_stream_push(nck_stream_t *self, const nck_seg_t *seg, double tolerance);

// The run has no more segs: it ends at rest. Cost: constant. Context: prep.
void nck_stream_close(nck_stream_t *self);

// Work, a slice. Returns NCK_OK: call again; NCK_EMPTY: it needs a seg, or the close; NCK_FULL: a
// piece waits to be taken; NCK_DONE: all of the run is given.
// Cost: 8 000 operations, or linear in the knots of a window. Context: prep.
nck_status_t nck_stream_step(nck_stream_t *self);

// What the next step takes at most, in hundreds of a PC's instructions; with arcs, whose points are
// turned, more. Cost: constant. Context: prep.
static inline uint32_t nck_stream_price(const nck_stream_t *self) {
    static const uint16_t line[] = {130, 82, 0, 24, 40, 0, 48, 0, 23, 78, 187, 30, 12};
    static const uint16_t arc[] = {195, 82, 0, 44, 63, 0, 48, 0, 23, 117, 432, 30, 12};
    switch (self->phase) {
    case NCK_STREAM_CLOCK: return nck_timing_price(&self->clock);
    case NCK_STREAM_FAIR: return nck_fair_price(&self->work.fair);
    case NCK_STREAM_MOTION: return nck_motion_price(&self->work.plan.motion);
    default: break;
    }
    const uint32_t near = self->phase == NCK_STREAM_GUESS ? self->clock.guess.near[0] : self->near;
    const int turns = nck_track_at(&self->track, near)->plane != 0;
    return turns ? arc[self->phase] : line[self->phase];
}

// Nobody knows when more segs come: a window of what is known, if it is enough for one. Returns 1
// if it is: step anew. Behind NCK_EMPTY. Cost: constant. Context: prep.
int nck_stream_hurry(nck_stream_t *self);

// Where the next piece begins, when step has said NCK_FULL [path mm]. Cost: constant.
// Context: prep.
double nck_stream_place(const nck_stream_t *self);

// Take the next piece, when step has said NCK_FULL. Cost: constant. Context: prep.
void nck_stream_take(nck_stream_t *self, nck_stream_piece_t *piece_out);

#endif
