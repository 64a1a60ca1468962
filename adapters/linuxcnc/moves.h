// SPDX-License-Identifier: MIT
// The moves that the host has handed over: a ring in the order of the program, with what is not
// behind the tool yet, and of what is the last MOVES_KEPT entries. The kernel takes them one by
// one, forward, or back from their ends to their starts; the ring tells what the host wants to
// hear.
#ifndef MOVES_H
#define MOVES_H

#include <stdint.h> // uint32_t

#include "arc.h"     // arc_t
#include "nck/nck.h" // nck_block_in_t

enum {
    MOVES_AXES = 9,    // X Y Z A B C U V W
    MOVES_MAX = 4096,  // power of two
    MOVES_KEPT = 1024, // behind the tool: so far back it can go
    MOVES_MARGIN = 160 // the host hears `full` so many before: what it has begun still fits
};

// What an entry of the ring is.
typedef enum move_kind {
    MOVE_RAPID = 0,
    MOVE_LINE = 1,
    MOVE_ARC = 2,     // about X, Y or Z
    MOVE_CHORDS = 3,  // about any axis, and spirals: chords, which the kernel makes smooth
    MOVE_DIGITAL = 4, // output `index` becomes `value`
    MOVE_ANALOG = 5,
    MOVE_AT_SPEED = 6,// rest until the spindles have their speed
    MOVE_UNLOCK = 7,  // rest until the locking indexer of joint `index` is free
    MOVE_LOCK = 8,    // rest until it is locked
    MOVE_LIMITS = 9,  // what follows has the machine's limits of then
    MOVE_THREAD = 10, // a line in step with the spindle; the kernel rests meanwhile
    MOVE_TAP = 11     // the same, and back
} move_kind_t;

// One entry. Places are the host's, in mm and degrees.
typedef struct move {
    uint8_t kind;      // move_kind_t
    uint8_t path_mode; // nck_path_mode_t
    uint8_t plane;     // of an arc: 17, 18, 19
    uint8_t enables;   // the host's, told back
    uint8_t spindle;   // that it goes by
    uint8_t per_rev;   // 1: its feed hangs on the spindle's speed
    uint8_t said;      // 1: its output is out, or what it waits for has come
    int32_t motion;    // the host's kind of motion, told back
    int32_t id;        // the host's number of the move
    int32_t index;     // of an output, or a joint
    int32_t turns;     // of an arc
    uint32_t count;    // moves that the host has handed over up to this one
    uint32_t chords;
    double value;      // of an output; of a thread the lead [mm]; of a tap the lead too
    double a_share;    // of limits, and of a thread: see bounds_t
    double v_share;
    double before[MOVES_AXES + 2]; // of limits: those of what comes before, j, a_share, v_share
    double back;       // of a tap: how much faster the spindle is to turn on the way back
    double vel;        // the host's speed of the move [units/s], told back
    double feed;       // [mm/min, deg/min], by the revolution at 1 a second; 0: a rapid
    double cap;        // at no override more than this [mm/min, deg/min]; 0: the axes see to it
    double given;      // feed that the kernel has of it [mm/min, deg/min]; 0: not yet
    double tolerance;  // [mm]
    double way;        // programmed path up to its end [mm]
    double length;     // of its own part of that [mm]
    double start[MOVES_AXES]; // of limits: the axes' jerk
    double end[MOVES_AXES];
    arc_t arc;
} move_t;

// The ring. Counts go on for ever; an entry's count is its name.
typedef struct moves {
    move_t at[MOVES_MAX];
    uint32_t head; // the next one that comes
    uint32_t next; // the next one that the kernel takes
    uint32_t tail; // the oldest that is kept
    uint32_t back; // 1: from end to start, towards the tail
    uint32_t anew; // 1: `next` begins where the tool is, within the tolerance of it, …
    double away;   // … so far from it [mm]
    uint32_t exact; // 1: none runs as a curve: they rest where their path turns
    uint32_t axes; // that the machine has, a bit for each; the owner writes
    uint32_t part; // chords of `next`, or parts of its line, that it has taken
    double from;   // of it: the next part, in shares of the way, in the direction of running
    double to;
} moves_t;

// Where the axes may go. The host looks at the ends of moves; an arc may lead further.
typedef struct moves_travel {
    double least[3]; // X Y Z [mm]
    double most[3];
} moves_travel_t;

// The entry of a count. Cost: constant. Context: servo thread, as all of them.
static inline move_t *moves_at(moves_t *self, uint32_t count) {
    return &self->at[count & (MOVES_MAX - 1)];
}

// The entry behind one, as it runs. Cost: constant.
static inline uint32_t moves_on(const moves_t *self, uint32_t count) {
    return self->back ? count - 1 : count + 1;
}

// How far one entry is ahead of another, as it runs. Cost: constant.
static inline int32_t moves_ahead(const moves_t *self, uint32_t count, uint32_t from) {
    return (int32_t)(self->back ? from - count : count - from);
}

// 1 if the tool can go on over an entry in both directions. Cost: constant.
static inline int moves_is_open(const move_t *move) {
    const int locks = move->kind == MOVE_UNLOCK || move->kind == MOVE_LOCK;
    return !locks && move->kind < MOVE_THREAD && !move->per_rev;
}

// 1 if there is an entry that the kernel can take. Cost: constant.
int moves_has_next(const moves_t *self);

// 1 if the host is to wait. Cost: constant.
int moves_full(const moves_t *self);

// Forget all. Counts go on. Cost: constant.
void moves_clear(moves_t *self);

// The tool is in the entry of this count: those well before it are forgotten. Cost: constant.
void moves_pass(moves_t *self, uint32_t count);

// Straight from start to end. Returns its programmed length [mm]. Cost: constant.
double moves_straight(move_t *move, const double *start, const double *end);

// About an axis. Returns the length, −1 if there is no such arc. Cost: constant.
double moves_round(move_t *move, const double *centre, const double *normal, int32_t turn);

// The entry from its end to its start. Cost: constant.
void moves_reverse(move_t *move);

// How far a place is from an entry with a way, squared [mm²], and at which share of it; of several
// turns of an arc the one nearest to the share `guess`. Cost: constant.
double moves_distance(const move_t *move, const double *place, double guess, double *share_out);

// 1 if a tool that rests at a block's end rests at the entry's: those of chords have many. Cost:
// constant.
int moves_is_over(const moves_t *self, const move_t *move, const double *place);

// The tool is at a share of the entry of a count, so far away from it [mm]: the kernel takes what
// is left of it as it runs, or what comes behind. Cost: linear in entries without way there.
void moves_resume(moves_t *self, uint32_t count, double share, double away);

// The next block of the entry `next`: of a line from `from` to `to`, which the owner sets; offset:
// what the kernel's places lack of the host's.
// Returns 1 if it is the entry's last. Cost: constant.
int moves_block(const moves_t *self, const double *offset, nck_block_in_t *block_out);

// M codes that entries without way are to the kernel: one that passes, one that waits.
enum { MOVES_M_PASS = 900, MOVES_M_WAIT = 901 };

// 1 if X, Y or Z comes so near the end of the travel [mm], or for room < 0 that far behind it. Who
// begins outside has to lead back. Cost: constant.
int moves_reach(const move_t *move, const moves_travel_t *travel, double room);

#endif
