// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path of a run, from rest to rest, as elements: lines, some of them
// joined from many, arcs and helices.
#ifndef NCK_PREP_TRACK_H
#define NCK_PREP_TRACK_H

#include <stdint.h> // uint32_t

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_CLOCKED_…
#include "nck/base/real.h"    // NCK_ONCE nck_num
#include "nck/base/records.h" // nck_seg_t
#include "nck/base/status.h"  // nck_status_t

// Sizes.
enum {
    NCK_TRACK_SPAN = NCK_CLOCKED_TRACK, // elements
    NCK_TRACK_WORDS = NCK_CLOCKED_WORDS, // sets of words that change seldom, shared by elements
    NCK_TRACK_LEVELS = 4 // of what joining lines may cost
};

// What holds along an element beside its path.
typedef struct nck_track_words {
    double feed;       // wanted path speed [path mm/s]; of a rapid what its axes can do
    double feed_scale; // as in the seg
    nck_spin_t spin;   // as in the seg
    uint8_t rapid;     // 1: G0
    uint8_t reserved[7]; // 0
} nck_track_words_t;

// What of them changes seldom.
typedef struct nck_track_shared {
    double feed_scale;
    double most, x, per_rev; // as in nck_spin_t
} nck_track_shared_t;

// An arc, its plane's axes apart.
typedef struct nck_track_arc {
    double centre_u, centre_v, sweep; // as in nck_seg_arc_t
} nck_track_arc_t;

// An element.
typedef struct nck_track_element {
    double s;         // where it begins in its run [path mm]
    double length;    // [path mm]
    double start[NCK_AXIS_MAX]; // [mm, deg]
    double feed;      // of its words
    double speed;     // of their spindle, as in nck_spin_t
    union {
        nck_num way[NCK_AXIS_MAX]; // of a line: from start to end
        nck_track_arc_t arc;       // of an arc
    } shape;
    float tolerance;  // what joining has left of P [mm]
    uint32_t line;    // the first source line
    uint32_t block;   // the first block
    uint16_t words;   // number of the set that it shares
    uint8_t plane;    // 17, 18, 19: of an arc; 0: a line
    uint8_t rapid;    // 1: G0
} nck_track_element_t;

// The path: elements tail … head − 1 of a ring.
typedef struct nck_track {
    int axes;         // so many coordinates
    uint32_t head;    // elements begun
    uint32_t tail;    // elements done with
    uint8_t grows;    // 1: lines may be joined to the newest one
    double knot_s;    // what knots are apart in time [s]
    double spin_a;    // how fast the spindle follows a surface speed [rpm/s]; 0: at once
    double end[NCK_AXIS_MAX]; // of the newest
    struct {
        double tolerance; // P of its blocks [mm]
        double low[NCK_TRACK_LEVELS][NCK_AXIS_MAX]; // what its slope may be at every level
        double high[NCK_TRACK_LEVELS][NCK_AXIS_MAX];
    } join;
    struct {
        uint32_t head; // sets begun
        uint8_t lacks; // 1: another one had no room
        nck_track_shared_t at[NCK_TRACK_WORDS];
    } words;
    nck_track_element_t at[NCK_TRACK_SPAN];
} nck_track_t;

// Begin a run. The knots' time and the spindle's acceleration are as in the track.
// Cost: constant. Context: prep.
void nck_track_begin(nck_track_t *self, int axes, double knot_s, double spin_a);

// Add a line, arc or helix with length, which begins where the last one ended. Its feed is what is
// wanted, of a rapid what its axes can do. tolerance: P > 0.
// Returns NCK_OK; NCK_FULL: no room. Cost: constant. Context: prep.
nck_status_t nck_track_push(nck_track_t *self, const nck_seg_t *seg, double tolerance);

// The newest element is whole: nothing is joined to it. Cost: constant. Context: prep.
void nck_track_seal(nck_track_t *self);

// The run is known up to here [path mm]. Cost: constant. Context: prep.
double nck_track_known(const nck_track_t *self);

// 1 if there is no room for another element, or for its words. Cost: constant. Context: prep.
static inline int nck_track_is_full(const nck_track_t *self) {
    return self->head - self->tail == NCK_TRACK_SPAN || self->words.lacks;
}

// The element with this count. Cost: constant. Context: prep.
static NCK_ONCE const nck_track_element_t *nck_track_at(const nck_track_t *self, uint32_t count) {
    return &self->at[count & (NCK_TRACK_SPAN - 1)];
}

// The known element that s is in, the first or last one beyond them; near: one to begin with, of
// any count. Cost: linear in elements between. Context: prep.
uint32_t nck_track_find(const nck_track_t *self, uint32_t near, double s);

// The point at s of a known element, straight on beyond it. Cost: constant. Context: prep.
void nck_track_point(const nck_track_t *self, uint32_t count, double s, double *point_out);

// An element that was looked at from a view.
typedef struct nck_track_seen {
    uint32_t count;            // the view's own: none
    double s;                  // of its end that is next to the view [path mm]
    nck_num off[NCK_AXIS_MAX]; // where that is, from the view's point [mm, deg]
} nck_track_seen_t;

// A place that points near it are told from: floats hold what is near.
typedef struct nck_track_view {
    uint32_t count;             // element
    double s;                   // [path mm]
    double point[NCK_AXIS_MAX]; // [mm, deg]
    nck_track_seen_t seen[2];   // last behind it, and before it
} nck_track_view_t;

// The view from s of a known element. Cost: constant. Context: prep.
void nck_track_view(const nck_track_t *self, uint32_t count, double s, nck_track_view_t *view_out);

// p(s) of a known element less the point of a view [mm, deg]. It is as exact as a number of its
// size can be, however long an element is. Cost: constant. Context: prep.
void nck_track_offset(const nck_track_t *self, nck_track_view_t *from, uint32_t count, double s,
                      nck_num *offset_out);

// dp/ds at s of a known element. Cost: constant. Context: prep.
void nck_track_tangent(const nck_track_t *self, uint32_t count, double s, nck_num *tangent_out);

// The wanted speed at s of a known element [path mm/s]: its feed; under G96 that of the place, by
// the spindle's speed there and no more than it can follow. Cost: constant. Context: prep.
double nck_track_feed(const nck_track_t *self, uint32_t count, double s);

// The way at s of a known element, straight on, over which its feed would change by all of itself:
// under G96 that to the spindle's axis, longer where its speed is the most, else beyond any path
// [path mm]. Cost: constant. Context: prep.
double nck_track_even(const nck_track_t *self, uint32_t count, double s);

// The words of a piece from somewhere on this element to s, where the tool is at x: of its begin,
// but the feed of its slowest element. One may be shorter than a knot.
// Cost: linear in its elements. Context: prep.
void nck_track_words(const nck_track_t *self, uint32_t count, double s, double x,
                     nck_track_words_t *words_out);

// Where an element ends. Cost: constant. Context: prep.
const double *nck_track_end(const nck_track_t *self, uint32_t count);

// An element as a seg, without words. Cost: constant. Context: prep.
void nck_track_seg(const nck_track_t *self, uint32_t count, nck_seg_t *seg_out);

// The run is given up to s: forget the elements that end further than `back` before it, and what
// takes more than a quarter of the ring. Cost: linear in them. Context: prep.
void nck_track_drop(nck_track_t *self, double s, double back);

#endif
