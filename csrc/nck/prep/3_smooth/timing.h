// SPDX-License-Identifier: MIT
// Inside room 3: the clock, program length against a guessed time u. The curve has its knots at
// even steps of it, so wherever the program is slow they are close.
#ifndef NCK_PREP_TIMING_H
#define NCK_PREP_TIMING_H

#include <stdint.h> // uint32_t

#include "nck/base/real.h"           // nck_num
#include "nck/base/status.h"         // nck_status_t
#include "nck/prep/3_smooth/fair.h"  // NCK_FAIR_…
#include "nck/prep/3_smooth/track.h" // nck_track_t

// Sizes.
enum {
    NCK_TIMING_AHEAD = 8, // knots that are made beyond a window
    NCK_TIMING_CELLS = 4 * (NCK_FAIR_WINDOW + NCK_TIMING_AHEAD + 4), // a quarter of a knot each
    NCK_TIMING_PLACES = 3 * NCK_FAIR_WINDOW, // of the guess: a window and the way to brake behind
    NCK_TIMING_LIST = 2 * NCK_TIMING_CELLS + 2,
    NCK_TIMING_RUNGS = 24 // lengths that a place is looked at over
};

// What the machine can do.
typedef struct nck_timing_terms {
    int axes;     // so many
    double tau;   // what knots are apart [s]
    nck_num v[NCK_AXIS_MAX]; // of every axis [mm/s]
    nck_num a[NCK_AXIS_MAX]; // [mm/s²]
    nck_num j[NCK_AXIS_MAX]; // [mm/s³]
    nck_num smooth[NCK_AXIS_MAX]; // what a curve's jerk is measured by: j, A/τ where that is less
    nck_num smooth_least;
    double along[2]; // along the path, acceleration [mm/s²] and jerk [mm/s³]; 0: as axes have it
    nck_num v_most;  // the most of the axes
    double spin_a;  // how fast the spindle follows a surface speed [rpm/s]; 0: at once
    nck_num a_least; // the least of the axes and the path
    nck_num j_least;
    nck_num longest; // what a knot takes at most where nothing is near, in τ; 1 at least
} nck_timing_terms_t;

// A place of the program, and how fast it may be passed.
typedef struct nck_place {
    double s;  // [path mm]
    nck_num v; // [path mm/s]
    nck_num wide; // how fast the clock may be there, by how far its element's ends are [path mm/s]
} nck_place_t;

// Places in work: what is kept of the last plan, then those of the guess. Needed for making a clock
// alone.
typedef struct nck_timing_list {
    int count;
    int kept;
    nck_place_t at[NCK_TIMING_LIST];
} nck_timing_list_t;

// What makes a clock, in order.
typedef enum nck_timing_phase {
    NCK_TIMING_ADD = 0,     // the guess behind what is kept
    NCK_TIMING_FORWARD,     // no faster than it can have become
    NCK_TIMING_BACKWARD,    // nor than it can brake
    NCK_TIMING_CUT,         // behind the window
    NCK_TIMING_SAMPLE,      // s at quarters
    NCK_TIMING_ADD_UP,      // their sums,
    NCK_TIMING_MEAN,        // so steps of acceleration are rounded;
    NCK_TIMING_ADD_UP_AGAIN, // both again
    NCK_TIMING_MEAN_AGAIN,
    NCK_TIMING_LIST_ANEW,   // places of that
    NCK_TIMING_SUM,         // their time
    NCK_TIMING_SET          // s at all quarters of the window
} nck_timing_phase_t;

// The clock.
typedef struct nck_timing {
    const nck_timing_terms_t *terms;
    uint8_t closed;   // 1: the run's end is known
    uint8_t looked;   // 1: the guess has reached it
    uint8_t hurries;  // 1: more may be long in coming: what is known has to do
    uint8_t brakes;   // 1: so little is known that the guess rests where that ends
    uint8_t begins;   // 1: the window begins at rest
    uint8_t even;     // 1: knots are τ apart everywhere: a window has failed otherwise
    uint8_t ends;     // 1: it ends at the run's end
    nck_timing_phase_t phase;
    int at;           // place or quarter of the phase that comes next
    int knots;        // of the window
    struct {
        int from, to; // knots that are kept
        int blend;    // knots over which the plan comes in
        uint32_t near; // element where one was found last
    } keep;
    struct {
        double all;   // time of the list [s]; to be stretched
        double more;  // by so much [s]
        double step;  // s is sought at times so far apart [s]
        nck_num t;    // time behind the place in work [s]
        nck_num cell; // how long that lasts, stretched [s]
        nck_num past; // of that, at the time in work [s]
        nck_num last_v; // of the list's end before the means [path mm/s]
        nck_num raise; // of the guess where it begins behind a plan, by how much [1]
        int count;    // so many steps
        int place;    // of the list, in work
    } make;
    struct {
        uint32_t head; // places looked at
        uint32_t tail; // done with
        nck_num v;     // what the newest can be reached with [path mm/s]
        uint32_t near[2 * NCK_TIMING_RUNGS + 1]; // elements, where each point was found last
        nck_place_t at[NCK_TIMING_PLACES];
    } guess;
    double s[NCK_TIMING_CELLS + 1]; // at quarters from the window's begin on [path mm]
} nck_timing_t;

// Begin a run at s = 0. Cost: constant. Context: prep.
void nck_timing_begin(nck_timing_t *self, const nck_timing_terms_t *terms);

// Look at the next place. Returns NCK_OK (call again); NCK_EMPTY: the track must be known further,
// closed or full first, or time presses; NCK_DONE: as far as there is room for, or to the end.
// Cost: 2 NCK_TIMING_RUNGS points. Context: prep.
nck_status_t nck_timing_look(nck_timing_t *self, const nck_track_t *track);

// Nobody knows when more comes. Returns 1 if what is known will do for a window, as nck_timing_look
// tells then. Cost: constant. Context: prep.
int nck_timing_hurry(nck_timing_t *self);

// How far before the window's begin the track is still looked at. Cost: constant. Context: prep.
double nck_timing_reach(const nck_timing_t *self, const nck_track_t *track);

// Forget the places before s. Cost: linear in them. Context: prep.
void nck_timing_drop(nck_timing_t *self, double s);

// Begin to make the next clock from the knot `from` of this one on: its time runs by the plan's
// b = (du/dt)² at knots, which comes in over `blend` knots, 0: at once. Up to the knot `to` all is
// kept; behind it is the guess. span: from, to, blend; from = to = 0: nothing is kept.
// Cost: constant. Context: prep.
void nck_timing_begin_keep(nck_timing_t *self, nck_timing_list_t *list, const nck_track_t *track,
                           const int span[3]);

// Keep it. Returns NCK_OK (call again); NCK_DONE. Cost: a slice of 24 quarters. Context: prep.
nck_status_t nck_timing_keep(nck_timing_t *self, nck_timing_list_t *list,
                             const nck_track_t *track, const nck_num *b);

// 1 if knots are far apart at this one. Cost: as nck_track_find. Context: prep.
int nck_timing_is_wide(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                       int knot);

// How slow a clock is run where its knots are far apart, about: b at the most that the least
// acceleration of an axis builds up from the next end of the element on. Cost: as nck_track_find.
// Context: prep.
double nck_timing_pace(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                       int knot);

// By what the next clock's speed differs at a knot from this one's, if the plan has b there.
// Cost: as nck_track_find. Context: prep.
nck_num nck_timing_factor(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                          int knot, nck_num b);

// Begin to make a clock that begins at rest at s, of the guess alone. Cost: constant.
// Context: prep.
void nck_timing_rest(nck_timing_t *self, nck_timing_list_t *list, double s);

// What the next call makes of it at most, in hundreds of a PC's instructions. Cost: constant.
// Context: prep.
static inline uint32_t nck_timing_price(const nck_timing_t *self) {
    static const uint8_t price[] = {22, 11, 12, 22, 36, 8, 12, 8, 12, 13, 21, 36};
    return price[self->phase];
}

// Make it. Returns NCK_OK (call again); NCK_DONE. Cost: a slice of 24 places or quarters.
// Context: prep.
nck_status_t nck_timing_make(nck_timing_t *self, nck_timing_list_t *list, const nck_track_t *track);

#endif
