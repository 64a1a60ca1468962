// SPDX-License-Identifier: MIT
// What a host's trajectory planner is asked for, on libnck: moves in, one place a cycle out.
//
//     planner_line, planner_arc, … ─▶ ring of moves ─▶ nck_push_block, nck_prep ─▶ nck_tick ─▶ pose
//
// It knows no host: nck_tp.c is LinuxCNC's side. All runs in one thread, the servo thread. Nothing
// is allocated, nobody waited for. Lengths are mm, angles degrees.
#ifndef PLANNER_H
#define PLANNER_H

#include <math.h>   // fmax
#include <stdint.h> // uint32_t

#include "bounds.h"        // bounds_t bounds_most_t
#include "follow.h"        // follow_t
#include "moves.h"         // moves_t
#include "nck/nck_tools.h" // nck_t
#include "settings.h"      // settings_t

// What the planner asks of the host. Every pointer is needed.
typedef struct planner_hooks {
    void (*digital)(int index, char value);
    void (*analog)(int index, double value);
    void (*set_unlock)(int joint, int unlock); // a locking indexer
    int (*is_unlocked)(int joint);
    double (*v_max)(int axis);                 // limits of now [units/s, units/s²]
    double (*a_max)(int axis);
    int (*at_speed)(void);                     // 1: all spindles are
    int (*index)(int ask);  // 1: ask the spindle for its index; 0: has it passed since?
    void (*turn)(double share); // the spindle is to have that share of its speed, − backward
    void (*message)(const char *text);         // for the owner
} planner_hooks_t;

// An output that changes where the next move begins.
typedef struct planner_output {
    int index;
    uint32_t analog;
    double value;
} planner_output_t;

enum {
    PLANNER_OUTPUTS = 16, // of them, for one move
    PLANNER_STEPS = 8     // cycles over which the spindle's speed is measured
};

// What is in force for the moves that come.
typedef struct planner_modal {
    int id;            // the host's number
    uint32_t path_mode;// nck_path_mode_t
    double tolerance;  // [mm]; 0: the owner's
    double lead;       // in step with the spindle: [mm] a revolution; 0: not
    uint32_t speed;    // 1: by its speed, as feed a revolution; 0: by its angle
    uint32_t spindle;  // which
} planner_modal_t;

// What a move has beside its geometry.
typedef struct planner_order {
    double vel;        // [units/s] of the tool; of rotary axes where they move alone
    double v_most;     // the same at any override; 0: as the axes can
    double a_most;     // [units/s²] along the path, likewise
    double j_most;     // [units/s³] along the path, as the axes leave it; 0: nothing is told
    int motion;        // the host's kind, told back
    uint8_t enables;   // the host's, told back
    uint8_t rapid;     // 1: as fast as the axes can
    uint8_t at_speed;  // 1: not before the spindles have their speed
    int indexer;       // joint to unlock for it; −1: none
    uint8_t blends;    // 1: under G64, of which a cycle makes the exact path
} planner_order_t;

// What the operator wants, for the cycle that comes.
typedef struct planner_wish {
    double feed, rapid;// overrides, 1: as programmed
    double v_most;     // of the tool [mm/s]
    int single;        // 1: rest at the end of the move in work
    double turns;      // of the spindle as measured, forward as it was commanded [revolutions]
    double rps;        // how fast it turns, ≥ 0 [1/s]
    double rps_most;   // as commanded at most: under G96 more than for now; 0: by nobody
    double surface;    // G96: its speed times the radius [mm/s]; 0: its speed is constant
    double axis_x;     // from where that radius counts [mm]
} planner_wish_t;

// What is told of a cycle.
typedef struct planner_told {
    uint32_t move;     // count of the move in work; valid if not done
    uint32_t between;     // 1: single block, or an override of none, rests at the end of that move
    double place[MOVES_AXES];
    double dtg[MOVES_AXES]; // to the move's end
    double to_go;      // the same along the path [mm]
    double v;          // of the tool, [mm/s]; of rotary axes where they move alone
    double a, j;       // along the path [mm/s², mm/s³]
    double along[3];   // X Y Z: in which direction, of length 1; 0 where they rest
    uint32_t limit;    // nck_limit_t in force
    uint32_t work;     // in this cycle, at most [1000 instructions]
} planner_told_t;

// Two means of a number over the last cycles, the slow one twice as far back: how it changes.
typedef struct trend {
    double fast, slow;
} trend_t;

// How far the kernel is from taking moves.
typedef enum planner_state {
    PLANNER_READY = 0,
    PLANNER_STOPS = 1, // an abort: the axes brake
    PLANNER_HIDES = 2, // it has been put elsewhere while it moved: it brakes unseen
    PLANNER_FOLLOWS = 3,// the spindle leads, the kernel rests
    PLANNER_TURNS = 4   // it is to go the other way: the kernel lets go of what it has
} planner_state_t;

// The planner. Its owner has one, and never moves it.
typedef struct planner {
    nck_t nck;
    nck_machine_t machine;  // the limits that were set last
    bounds_t bounds;        // of them
    bounds_t bounds_asked;  // of the last move that was handed over
    moves_t moves;
    settings_t settings;
    planner_hooks_t hooks;
    planner_modal_t modal;  // the owner writes
    moves_travel_t travel;// the owner writes
    planner_told_t told;    // the owner reads
    follow_t follow;        // the pass in step with the spindle
    uint32_t dropped;       // 1: it was aborted
    uint32_t led;           // the ring's first entry behind the pass
    uint32_t closed;        // 1: it has come, and is planned while the pass is cut
    uint32_t cut;           // the first entry of the ring whose word the pass has not said yet
    double steps[PLANNER_STEPS]; // of the spindle's angle in the last cycles [revolutions]
    double turns;           // its angle in the last cycle
    uint32_t step;          // of steps, the oldest
    planner_wish_t wish;    // of this cycle
    double rps;             // of the spindle, or as it is commanded, which is more
    trend_t spins;          // of its speed [1/s]
    trend_t override;       // of that over what feeds by it are told for
    double turned;          // the same foreseen, times the override of feeds
    planner_wish_t began;   // of when the kernel began on the feeds that it has
    uint32_t fed;           // the last move with a feed that the kernel has
    uint32_t by_turns;      // 1: the feeds that the kernel has hang on it
    uint32_t spindle;       // that the move in work, or the next one, goes by
    double skipped;         // programmed path where the kernel began, less what it had gone [mm]
    planner_output_t output[PLANNER_OUTPUTS];
    uint32_t outputs;       // of them, for the next move
    uint32_t state;         // planner_state_t
    uint32_t begun;         // 1: the kernel has been initialised
    uint32_t paused;        // 1: the operator holds
    uint32_t reversed;      // 1: he wants to go back
    uint32_t holds;         // 1: the kernel has been told so
    uint32_t failed;        // 1: the kernel refused a move; no more until an abort
    uint32_t done;          // 1: nothing left to do
    uint32_t count;         // moves handed over so far
    uint32_t passed;        // of them, those behind the tool
    uint32_t idle;          // cycles that the kernel has waited for more, at rest
    uint32_t quiet;         // cycles since the last one came
    uint32_t flushed;       // moves.next as of the last flush
    uint32_t empty;         // 1: the kernel has used up all that it was given
    double known;           // how long a curve lasts that it has, before it sets off [s]
    uint32_t grows;         // 1: that was less a cycle ago
    uint32_t making;        // cycles at rest in which it has worked since then
    uint32_t windows;       // of a curve that it has made at rest, …
    uint32_t took;          // … of the last one so many cycles, of the first one twice as many
    uint32_t single;        // 1: the kernel rests at the end of every move
    uint32_t owed;          // 1: it is to be let go on, having rested there
    uint32_t moved;         // 1: the tool has moved since it was last let go on
    uint32_t waits;         // 1: the unlocking or locking that is waited for has been asked for
    uint32_t first;         // entries before this one are behind the tool
    uint32_t calm;          // cycles since the overrides have changed
    double pace;            // cycles between two that were told, in the mean
    uint32_t wanted;        // override of feeds that the host wants [ppm]
    uint32_t bound;         // the last move with a cap, or a feed a revolution, that the kernel has
    double cycle_s;         // 0: it takes no moves
    uint32_t budget;        // of a cycle [1000 instructions]
    double a_path;          // tangential acceleration at most [mm/s²]
    double goal[MOVES_AXES];// where the last move ends
    double offset[MOVES_AXES]; // the host's place less the kernel's
    double at;              // programmed path up to the tool, as the kernel counts [mm]
    double way;             // programmed path up to the goal, as the kernel counts [mm]
} planner_t;

// Cycles that so many milliseconds take, 1 at least. Cost: constant. Context: any.
static inline uint32_t planner_cycles(const planner_t *self, double ms) {
    return self->cycle_s > 0.0 ? (uint32_t)fmax(ms * 1e-3 / self->cycle_s + 0.5, 1.0) : 1;
}

// Make it ready, at rest at zero; cycle_s: a period of the servo thread. modal and a_path stay.
// Returns 1, or 0 if the kernel refuses the machine or the period: it takes no moves then. Cost:
// linear in the memory. Context: before the first cycle.
int planner_init(planner_t *self, const settings_t *settings, const planner_hooks_t *hooks,
                 double cycle_s);

// A move to `end`: straight, or about an axis. Returns 1; 0 without length; −1 where nothing can be
// added: no room, after an error, while an abort brakes; −2 for a number that no machine has; −3
// for an arc that leaves the travel. Cost: constant. Context: servo thread, as all below.
int planner_line(planner_t *self, const planner_order_t *order, const double *end);
int planner_arc(planner_t *self, const planner_order_t *order, const double *end,
                const double *centre, const double *normal, int turn);

// The same in step with the spindle, there and back; the spindle is to turn back at `back` times
// its speed. modal.lead tells the lead.
int planner_tap(planner_t *self, const planner_order_t *order, const double *end, double back);

// An output that is to change where the next move begins; without one it does not. Returns 1, or −1
// if there are PLANNER_OUTPUTS of them.
int planner_output(planner_t *self, int analog, int index, double value);

// Brake to rest on the path, or rest there; go on. A cycle without a move forgets it.
void planner_pause(planner_t *self, int pause);

// Go back over the moves that are kept (1), or forward (0), as soon as it may go on. Outputs and
// waits are not said again. Returns 1; 0 if it moves, or has nothing to do: that counts for
// nothing; −1 for a move that cannot be gone back over: one that the spindle leads or feeds, or one
// of a locking indexer.
int planner_reverse(planner_t *self, int reverse);

// Brake to rest and drop what has not been done.
void planner_abort(planner_t *self);

// The axes are elsewhere, at rest; what has not been done is dropped.
void planner_put(planner_t *self, const double *place);

// The move in work, or the first one that will be. Cost: constant. Context: any.
static inline uint32_t planner_current(const planner_t *self) {
    const int known = moves_ahead(&self->moves, self->told.move, self->first) >= 0;
    return known ? self->told.move : self->first;
}

// Moves that are not behind the tool.
int planner_depth(const planner_t *self);

// One cycle: bounded work of preparation, one tick.
void planner_cycle(planner_t *self, const planner_wish_t *wish);

#endif
