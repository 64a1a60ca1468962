// SPDX-License-Identifier: MIT
// Room 3, smooth: block → seg. Exact lines, arcs, helices; within a tolerance a spline of them.
#ifndef NCK_PREP_SMOOTH_H
#define NCK_PREP_SMOOTH_H

#include "nck/base/limits.h"  // NCK_SMOOTH_… NCK_MERGE_ROWS
#include "nck/base/records.h" // nck_block_t nck_seg_t nck_output_t
#include "nck/base/status.h"  // nck_status_t
#include "nck/base/terms.h"   // nck_terms_t
#include "nck/prep/3_smooth/clocked.h" // nck_clocked_t

// Blocks that G64 Q may join to one, the first not counted.
enum { NCK_SMOOTH_MERGE = NCK_MERGE_ROWS };

// How the path goes on from one block with length into the next: as good as straight, or not. What
// changes the direction of either takes the answer back.
typedef enum nck_onward {
    NCK_ONWARD_UNKNOWN = 0,
    NCK_ONWARD_STRAIGHT,
    NCK_ONWARD_BENT
} nck_onward_t;

// A block's end that wants a knot of its own: a corner, its control point on the path or off it, or
// a step of the path's curvature.
typedef enum nck_key {
    NCK_KEY_NONE = 0,
    NCK_KEY_ON_PATH,
    NCK_KEY_LIFTED,
    NCK_KEY_STEP,
    NCK_KEY_PAIR,  // the first of two corners that share a bend, with knots about their middle
    NCK_KEY_SECOND // the other one
} nck_key_t;

// What is still to be found of the spacing at a block's end.
typedef enum nck_lack {
    NCK_LACKS_NOTHING = 0,
    NCK_LACKS_BLOCKS, // it is what the full ring lets us see; perhaps there is more
    NCK_LACKS_TIME    // whether a stop is faster
} nck_lack_t;

// A block on its way through the room.
typedef struct nck_raw {
    nck_seg_t seg;       // its exact seg
    nck_output_t output; // what it hands over, before its seg
    double s;            // where it begins in its run [path mm]
    double tolerance;    // [mm] of the smoothed path; 0: exact
    double spacing;      // of knots, as its end allows [path mm]; 0: not known yet
    double inside;       // of knots, as its bend or a line's speed allows [path mm]
    float moved[2];      // by how much its begin and its end are off the program [mm]
    uint8_t has_seg;     // 1: it moves or rests
    uint8_t has_output;  // 1: it hands over something, and has not yet
    uint8_t smooth;      // 1: part of a run
    uint8_t key;         // whether its end wants a knot of its own: nck_key_t
    uint8_t rough;       // 1: the path is noise near its end, no curve
    uint8_t ends;        // 1: end of the program
    uint8_t lacks;       // of its spacing: nck_lack_t
    uint8_t onward;      // how the path goes on into it: nck_onward_t
} nck_raw_t;

// What the room gives: a seg, or an output between segs.
typedef struct nck_smooth_item {
    uint8_t is_output;   // 1: output, 0: seg
    uint8_t reserved[7]; // 0
    nck_seg_t seg;
    nck_output_t output; // after_segs is set
} nck_smooth_item_t;

// The next knot while it is sought: step after step, in stretches.
typedef struct nck_trial {
    double step;    // that is wanted [path mm]
    double off;     // deviation at the end of the block compared last [mm]
    uint32_t count; // block that the piece in work is compared with next
    uint8_t on;     // 1: a knot is sought
    uint8_t fails;  // 1: it does not fit
    uint8_t n;      // step that is tried
    uint8_t first;  // piece in work of the three that the knot makes
    uint8_t to_key; // whose own knot the step wanted leads to: nck_key_t
    uint8_t rough;  // 1: the path is noise ahead; the last of the steps are tried as before
    uint8_t was_rough; // run.rough of the knot before
    uint8_t looks;  // 1: before it, the way ahead is looked at from `count` on, `step` so far
} nck_trial_t;

// What a look at a block's end has found of the path around it.
typedef struct nck_look {
    double h;       // spacing that was looked at [path mm]; 0: none
    double before[NCK_AXIS_MAX]; // δ²p one spacing before [mm]
    double middle[NCK_AXIS_MAX]; // and there
    double behind[NCK_AXIS_MAX]; // p one spacing behind [mm]
} nck_look_t;

// Looks at one block's end: those in vain come again, and places are about where they were.
typedef struct nck_looks {
    uint32_t count;   // the block
    uint32_t tail;    // of the ring, then
    nck_look_t at[2]; // the newest, in turn
    double wait;      // a spacing that was good where it was looked at last, while a wider one
                      // waits for more blocks [path mm]; 0: none waits
} nck_looks_t;

// And what goes with it.
typedef struct nck_looked {
    int16_t off[3]; // blocks to two spacings before the end, and to one and two behind it: about
    uint8_t newest; // of the two looks
    uint8_t known;  // 1: `wait` is good whatever comes
} nck_looked_t;

// The room's state: filled by nck_smooth_init, written by the room alone.
typedef struct nck_smooth {
    const nck_terms_t *terms;
    int64_t position_nm[NCK_AXIS_MAX]; // end of the last block pushed [nm, ndeg]
    double position[NCK_AXIS_MAX];     // the same [mm, deg]
    double s;            // length of all segs pulled [path mm]
    double known;        // and of the blocks that have been pushed [path mm]
    double spacing_max;  // of knots [path mm]
    double travel[2][NCK_AXIS_MAX]; // of every axis, from … to [mm, deg]
    double tolerance;    // of the newest smoothed block [mm]; 0: none yet
    uint32_t seq;        // of the next seg pulled
    uint8_t hungry;      // 1: pull needs a block
    uint8_t ended;       // 1: no more blocks
    uint8_t mixed;       // 1: blocks have come with more than one tolerance
    uint8_t rests;       // 1: the path does, behind the last seg pulled

    struct {
        uint32_t head; // blocks pushed
        uint32_t tail; // blocks done with
        nck_raw_t at[NCK_SMOOTH_ROWS];
    } raw;

    // The seg that is given in pieces, since the spindle's speed changes along it.
    struct {
        double from;   // given up to here [path mm]; its length: nothing is left
        nck_seg_t seg;
    } divide;

    // The newest block, as lines are joined to it.
    NCK_SMOOTH_STATE {
        uint32_t count;    // vertices that have vanished in it
        double tolerance;  // P of its blocks [mm]
        double within;     // its tolerance before anything was joined [mm]
        double s[NCK_SMOOTH_MERGE + 1]; // where the vertices were in it [path mm]
        double vertex[NCK_SMOOTH_MERGE + 1][NCK_AXIS_MAX];
    } merge;

    // The smoothed stretch at the front, from rest or exact path to the next: knots t, controls c.
    NCK_SMOOTH_STATE {
        uint8_t open;    // 1: there is one
        uint8_t closed;  // 1: it gets no more blocks
        uint8_t chosen;  // 1: t[5] and c[3] are chosen
        uint8_t on_key;  // whose own knot t[4] is: nck_key_t
        uint8_t past_key; // the same of t[3], if it wants more knots beside it
        uint8_t rough;   // 1: c[3] … c[5] are those of noise
        uint8_t corner;  // whether c[3] is that of a corner: nck_key_t
        uint32_t end;    // count of the block behind its last one
        uint32_t kinks;  // places where it must rest to stay within the tolerance, in all runs
        uint32_t tries;  // knots that the last pull has begun to try
        nck_trial_t trial;
        nck_looks_t looks;
        nck_looked_t looked;
        double rest;     // the place of the next of them; beyond the run: none is known
        double given;    // t[2] … t[3] is given up to here
        double t[8];     // next seg: t[2] … t[3]; t[6], t[7]: if it had to end at t[5]
        double c[6][NCK_AXIS_MAX]; // c[i] belongs to t[i] t[i+1] t[i+2]
        double reach[6][2];        // and is made of the path from … to [path mm]
        double position[NCK_AXIS_MAX]; // end of its last seg
    } run;

    NCK_OPTIMAL_MEMBER(nck_clocked_t, clocked) // the run in work, of the optimal slope
} nck_smooth_t;

// Begin at the machine's start position. Cost: constant. Context: any, before the tick runs.
void nck_smooth_init(nck_smooth_t *self, const nck_terms_t *terms);

// Take a block of any kind, the running number of which is block_seq. Blocks without length vanish.
// Returns NCK_OK; NCK_FULL if nck_smooth_pull has not asked for a block (pull until it says
// NCK_EMPTY; so the segs depend on the blocks alone); NCK_E_FEED_MISSING if the feed comes out as
// zero or less (feed per revolution of a spindle that stands): the block is not taken.
// Cost: constant. Context: prep.
nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq);

// Push and pull in one, for a move on the exact path where no block waits in the room: its seg.
// Returns NCK_OK; NCK_EMPTY: it has no length and vanishes; NCK_E_FEED_MISSING; NCK_FULL: it has to
// be pushed. Cost: constant. Context: prep.
nck_status_t nck_smooth_pass(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq,
                             nck_seg_t *seg_out);

// 1 if the last pull has asked for a block and none has come since. Cost: constant. Context: prep.
static inline int nck_smooth_is_hungry(const nck_smooth_t *self) { return (int)self->hungry; }

// There are no more blocks: end of the program, or an error. Cost: constant. Context: prep.
void nck_smooth_end(nck_smooth_t *self);

// There are more blocks after all: the path goes on from the end that nck_smooth_pull has told by
// NCK_DONE. Cost: constant. Context: prep.
void nck_smooth_go_on(nck_smooth_t *self);

// Take the machine's limits anew: they have changed. Only while no block is under way.
// Cost: constant. Context: prep.
void nck_smooth_adapt(nck_smooth_t *self);

// 1 if no block is under way. Cost: constant. Context: prep.
int nck_smooth_is_empty(const nck_smooth_t *self);

// Nobody knows when more blocks come: a clocked path goes on with what is known of it, if that is
// enough for a window. Behind NCK_EMPTY. Cost: constant. Context: prep.
void nck_smooth_hurry(nck_smooth_t *self);

// Give the next seg or output, in order.
// Returns NCK_OK and the item; NCK_FULL if it has to be called again; NCK_EMPTY if it needs another
// block or nck_smooth_end; NCK_DONE if all is given.
// Cost: 30 points of the path, 200 where the end of a block is looked at first (README).
// Context: prep.
nck_status_t nck_smooth_pull(nck_smooth_t *self, nck_smooth_item_t *item_out);

// 1 if what must always hold does: for tests. Cost: linear in NCK_SMOOTH_SPAN. Context: prep.
int nck_smooth_invariants(const nck_smooth_t *self);

#endif
