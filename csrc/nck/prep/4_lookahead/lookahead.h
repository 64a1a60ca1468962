// SPDX-License-Identifier: MIT
// Room 4, lookahead: seg → node. Places the nodes and finds every cap.
//
//   push ─▶ junctions (caps of segs and junctions) ─▶ window of nodes ─▶ pieces
#ifndef NCK_PREP_LOOKAHEAD_H
#define NCK_PREP_LOOKAHEAD_H

#include "nck/base/limits.h"  // NCK_NODE_MAX NCK_CORNER_SPAN …
#include "nck/base/records.h" // nck_seg_t nck_node_t
#include "nck/base/status.h"  // nck_status_t
#include "nck/base/terms.h"   // nck_terms_t

// Pieces and junctions of one seg, and junctions that are kept.
enum {
    NCK_PIECES_PER_SEG = 3, // head, middle, tail
    NCK_JUNCTION_MAX = 4 * NCK_CORNER_SPAN,
    NCK_JUNCTION_ROOM = NCK_JUNCTION_MAX - NCK_CORNER_SPAN - 1 // for one more seg
};

// Segs on either side that a seg's limits hang on at most.
enum { NCK_NEAR_SPAN = NCK_CORNER_SPAN / 2 };

// The two paces that a path is planned for: as programmed, and at a feed override beyond 100 %.
enum { NCK_PACE_FEED = 0, NCK_PACE_OVER = 1, NCK_PACES = 2 };

// A seg and the junction at its end at one pace.
typedef struct nck_pace {
    double v;             // speed cap of the whole seg [path mm/s]
    double time;          // that the seg takes at v [s]
    double least;         // the time that the seg takes is no less, under a jerk limit [s]
    double a;             // tangential acceleration [path mm/s²]
    double j;             // tangential jerk left at v [path mm/s³]
    double v_corner;      // cap at the end [path mm/s]
    double share;         // β that the junction at the end may use
} nck_pace_t;

// What is at a junction's end, bit by bit.
typedef enum nck_junction_end {
    NCK_JUNCTION_STOP = 1,  // the path rests there
    NCK_JUNCTION_TURNS = 2, // its seg keeps NCK_KEEP_TURNS
    NCK_JUNCTION_RESTS = 4  // of NCK_JUNCTION_CLOCKED: the path rests there
} nck_junction_end_t;

// The kind of a junction that is an interval of a clocked path: where its limits are kept is room
// 5's alone, so for its neighbours here it is a rest.
enum { NCK_JUNCTION_CLOCKED = NCK_SEG_TAP + 1 };

// What the axes allow a line or an arc; the rest of it: what an arc costs of its plane's two axes.
typedef struct nck_junction_arc {
    double a_straight;    // tangential limit by the axes that are on no arc [path mm/s²]
    double a_plane;       // their smaller limit [mm/s²]
    double j_plane;       // and of jerk [mm/s³]
    double cos_lambda;    // in-plane share of the path speed
    double kappa;         // in-plane acceleration = v²·kappa [1/mm]
} nck_junction_arc_t;

// What only some kinds of seg have.
typedef union nck_junction_shape {
    nck_junction_arc_t arc;   // or line
    double dwell_s;           // dwell [s]; wait: 0
    double clocked;           // NCK_JUNCTION_CLOCKED: its length [path mm]
} nck_junction_shape_t;

// A junction, and the seg that ends there.
typedef struct nck_junction {
    uint32_t seq;         // of the seg
    uint8_t kind;         // nck_seg_kind_t
    uint8_t limit;        // nck_limit_t that set v_max
    uint8_t limit_free;   // nck_limit_t that set v_free
    uint8_t end;          // bits of nck_junction_end_t
    double length;        // [path mm]
    double feed;          // programmed speed [path mm/s]; 0: a rapid
    double tool;          // speed of the tool / path speed; 0: rotary axes move alone
    double v_max;         // speed cap of the whole seg at 100 % [path mm/s]
    double v_free;        // the same by everything but the feed; ≥ v_max
    double vv_out;        // v² at its end is no more: what can be gained from the last rest on
    double j_straight;    // tangential jerk limit by all axes' directions [path mm/s³]
    double a_most;        // largest tangential acceleration anywhere on the seg [path mm/s²]
    double load;          // d of the junction at the end [s²/mm]; 0 at a stop
    nck_pace_t pace[NCK_PACES];
    nck_junction_shape_t shape; // by kind
} nck_junction_t;

// The room's state.
typedef struct nck_lookahead {
    const nck_terms_t *terms;
    uint16_t ended;       // 1: no more segs will come before the path is at rest
    uint16_t before_limit; // nck_limit_t that set before.vv
    double a_any;         // no seg has a larger tangential acceleration [path mm/s²]
    double zone_s;        // how long before and after a junction its share is kept free [s]
    float even;           // what decided lines of an even polygon gain in a row (corner.c)
    float most_s;         // where the next seg is placed: for so long a share of more than half may
                          // still be kept free; negative: none is [s]

    // junctions, counted from the start; slot = count mod NCK_JUNCTION_MAX
    struct {
        uint32_t head;    // pushed
        uint32_t settled; // segs with speeds and limits
        uint32_t decided; // junctions with v_corner and share
        uint32_t placed;  // segs turned into nodes
        uint32_t known;   // head when the next junction could not be decided for want of segs
        uint32_t dense;   // from this one on all settled segs are of a dense row (zone.h)
        uint32_t tried;   // settled + decided when the next seg was to be placed in vain
        double tangent[2][NCK_AXIS_MAX]; // at the end of the last two segs, of count mod 2
        nck_junction_t at[NCK_JUNCTION_MAX];
    } junction;

    // the next junction to decide, if it is weighed: what it may take, with no other near it
    struct {
        uint32_t is_weighed;  // 1: its segs are known, and …
        double even;          // … of an even polygon: what the line before gains; else 0
        double beta;          // share that it may take
        double v[NCK_PACES];  // that it is crossed at [path mm/s]
    } next;

    // the piece before the next node; caps are 0 after a stop
    struct {
        double vv;        // cap at 100 %, v²
        double vv_over;   // cap by everything but the feed, v²
    } before;

    // window of nodes, counted from the start; slot = count mod NCK_NODE_MAX
    struct {
        uint32_t head;    // oldest node
        uint32_t fill;    // nodes in the window
        uint32_t barrier; // pieces from head on up to and with the newest WAIT; 0: none
        nck_node_t at[NCK_NODE_MAX];
    } window;
} nck_lookahead_t;

// Cost: linear in the capacities. Context: any, before the tick runs.
void nck_lookahead_init(nck_lookahead_t *self, const nck_terms_t *terms);

// Take the machine's limits anew: they have changed. Only while the path is to rest at the end of
// the last seg. Cost: constant. Context: prep.
void nck_lookahead_adapt(nck_lookahead_t *self);

// 1 if every seg is placed and the path rests at the last one's end. Cost: constant. Context: prep.
int nck_lookahead_is_settled(const nck_lookahead_t *self);

// 1 if nck_lookahead_push would take a seg. Cost: constant. Context: prep.
static inline int nck_lookahead_has_room(const nck_lookahead_t *self) {
    return self->junction.head - self->junction.placed <= NCK_JUNCTION_ROOM;
}

// Take a seg; behind an end it is where the path goes on from its rest. Returns NCK_OK or NCK_FULL.
// Cost: constant. Context: prep.
nck_status_t nck_lookahead_push(nck_lookahead_t *self, const nck_seg_t *seg);

// Say that no more segs will come before the path has come to rest. Cost: constant. Context: prep.
void nck_lookahead_end(nck_lookahead_t *self);

// Take a piece that another look-ahead has placed, in the place of a seg. Returns NCK_OK; NCK_FULL
// (pieces must be dropped); NCK_E_STATE after nck_lookahead_end. Cost: constant. Context: prep.
nck_status_t nck_lookahead_take(nck_lookahead_t *self, const nck_node_t *piece);

// One bounded piece of work. Returns NCK_OK, NCK_EMPTY (needs segs), NCK_FULL (pieces must be
// dropped), NCK_DONE (ended, and every piece is placed). Cost: one junction and two segs' nodes
// with at most 2·NCK_CORNER_SPAN neighbours at both paces. Context: prep.
nck_status_t nck_lookahead_step(nck_lookahead_t *self);

// 1 if a step would do nothing but say NCK_FULL, till pieces are dropped. Cost: constant.
// Context: prep.
static inline int nck_lookahead_is_full(const nck_lookahead_t *self) {
    return self->window.fill > NCK_NODE_MAX - NCK_PIECES_PER_SEG;
}

// 1 if a step, while there is room, would do nothing but say NCK_EMPTY, till another seg comes.
// Cost: constant. Context: prep.
static inline int nck_lookahead_is_idle(const nck_lookahead_t *self) {
    const uint32_t settled = self->junction.settled;
    const uint32_t decided = self->junction.decided;
    if (self->ended || settled != self->junction.head) return 0;
    if (decided + 1 != settled && self->junction.known != self->junction.head) return 0;
    return self->junction.placed == decided || self->junction.tried == settled + decided;
}

// The i-th piece from the window's head; NULL beyond the window. Cost: constant. Context: prep.
const nck_node_t *nck_lookahead_ahead(const nck_lookahead_t *self, uint32_t i);

// The oldest seg that has not become final to its end; `newer` if there is none. Cost: constant.
// Context: prep.
uint32_t nck_lookahead_oldest(const nck_lookahead_t *self, uint32_t newer);

// Pieces in the window. Cost: constant. Context: prep.
uint32_t nck_lookahead_fill(const nck_lookahead_t *self);

// 1 if no more pieces come before the path is at rest: the path has ended, or the newest piece is a
// WAIT. Cost: constant. Context: prep.
static inline int nck_lookahead_is_complete(const nck_lookahead_t *self) {
    const uint32_t barrier = self->window.barrier;
    if (barrier > 0 && barrier == self->window.fill) return 1;
    return self->ended && self->junction.placed == self->junction.head;
}

// Forget the first n pieces. Cost: constant. Context: prep.
void nck_lookahead_drop(nck_lookahead_t *self, uint32_t n);

// Every invariant of the room, for tests: 1 if all hold. Cost: linear in the window.
int nck_lookahead_invariants(const nck_lookahead_t *self);

#endif
