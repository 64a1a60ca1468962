// SPDX-License-Identifier: MIT
// Room 2, toolcomp: block → block. Tool offsets, and the path of the tool's centre beside the
// contour (G41, G42).
//
//     push a block → it passes, or is taken → pull what is given → push the next one
#ifndef NCK_PREP_TOOLCOMP_H
#define NCK_PREP_TOOLCOMP_H

#include "nck/base/limits.h"  // NCK_COMP_ROWS NCK_COMP_STATE
#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_block_t
#include "nck/base/status.h"  // nck_status_t nck_diagnostic_t
#include "nck/prep/2_toolcomp/shape.h" // nck_shape_t

// What the path has of a contour: an arc about the corner before it, and what is parallel to it.
typedef enum nck_comp_part {
    NCK_COMP_ABOUT = 0,
    NCK_COMP_BESIDE = 1,
    NCK_COMP_PARTS = 2
} nck_comp_part_t;

// From where to where the path is on a piece.
typedef struct nck_comp_span {
    double from; // [mm] along it
    double to;
} nck_comp_span_t;

// A block that waits, and what it is in the plane.
typedef NCK_COMP_STATE nck_comp_entry {
    nck_block_t block;   // as it came
    nck_shape_t contour; // the programmed line or arc
    double tangent[2];   // direction of the contour before it, at its end; of the first move: the
                         // one that it ends upright on, by the types of Fanuc
    double s;            // contour before it [mm]
    double height;       // where it begins outside of the plane, as nck_comp_height has it [mm]
    nck_comp_span_t path[NCK_COMP_PARTS];
    uint8_t on[NCK_COMP_PARTS]; // 1: the path is on that piece
    uint8_t moves;       // 1: it has a contour
    uint8_t rapid;       // 1: G0: nothing is cut there
    uint8_t enters;      // 1: the first move
    uint8_t crosses;     // 1: it is the way to the other side of the contour, without G40
    uint8_t clear;       // 1: the first contour behind it, if that came by a rapid: the arc to its
                         // side cuts nothing either
    uint8_t leaves;      // 1: the move behind G40, with an arc about the contour's end before it
    uint8_t anew;        // 1: the contour comes back to itself here
} nck_comp_entry_t;

// How far compensation is.
typedef enum nck_comp_phase {
    NCK_COMP_OFF = 0,
    NCK_COMP_ENTERS = 1, // the first move in the plane is not there yet
    NCK_COMP_ON = 2,
    NCK_COMP_LEAVES = 3  // off, but for an arc about the contour's end and the move behind it
} nck_comp_phase_t;

// A piece of the centre's path, from where a contour begins to where it ends.
typedef struct nck_comp_piece {
    nck_shape_t shape;
    uint32_t of;         // count of the contour
    uint8_t part;        // nck_comp_part_t
    uint8_t reserved[3]; // 0
} nck_comp_piece_t;

// The room's state: filled by nck_toolcomp_init, written by the room alone.
typedef struct nck_toolcomp {
    const nck_machine_t *machine; // who has X, Y and Z, and their travel
    double radius;       // of the tool, > 0 [mm]
    double side;         // 1: left of the contour, −1: right
    double nose[2];      // from the centre to the tool's point, along the plane's axes [mm]
    double at[2];        // where the centre is by now [mm]
    double s;            // contour pushed [mm]
    int64_t given_nm[NCK_AXIS_MAX];   // target of the last move given
    int64_t reached_nm[NCK_AXIS_MAX]; // target of the last move pushed
    uint8_t phase;       // nck_comp_phase_t
    uint8_t closed;      // 1: what waits is all there is
    uint8_t away;        // 1: off, and the tool still stands where compensation has left it
    uint8_t plane;       // 17, 18, 19
    uint8_t axis[2];     // its axes
    uint8_t enters;      // 1: the program begins in the middle, and what comes is before that
    uint8_t start;       // nck_comp_start_t of what is in force or was last

    // The contours that were pushed last and first.
    NCK_COMP_STATE {
        double tangent[2]; // direction in which the last one ends
        double first[2];   // where the first one behind the entry begins, and its direction
        double ahead[2];
        double height;     // of that place
        uint32_t from;     // counts from here on are of this contour
        uint32_t count;    // of the last one
        uint32_t line;     // of the last one
        uint32_t begins;   // line of the first one behind the entry; 0: there is none
        uint8_t rapid;     // 1: the last one is a G0
        uint8_t reserved[7]; // 0
    } last;

    // The piece in work.
    NCK_COMP_STATE {
        uint8_t open;        // 1: there is one
        uint8_t planned;     // 1: it is good
        uint8_t part;        // of the entry at the tail, the next one to be looked at
        uint8_t reserved[5]; // 0
        double along;        // where on it the path is [mm]
        double until;        // where the path leaves it [mm]
        nck_comp_piece_t piece;
    } walk;

    // The next entry whose path is too near to a contour before it, which is done with by then.
    NCK_COMP_STATE {
        double most;   // so deep is the tool in it [mm]; 0: there is none
        uint32_t of;   // count of the entry
        uint32_t line; // of the contour before
    } deep;

    struct {
        uint32_t head; // blocks taken
        uint32_t tail; // blocks done with
        nck_comp_entry_t at[NCK_COMP_ROWS];
    } ring;

    nck_diagnostic_t error; // code 0: none
    NCK_COMP_STATE {
        nck_diagnostic_t left; // corners left out; code 0: none
        nck_diagnostic_t way;  // a way in or out in the contour; code 0: none
    } note;
} nck_toolcomp_t;

// A program that begins in the middle (dialect.from_line) gives nothing before NCK_BLOCK_ENTRY.
// Cost: constant. Context: any, before the tick runs.
void nck_toolcomp_init(nck_toolcomp_t *self, const nck_machine_t *machine);

// nck_toolcomp_push of a block that compensation has to do with, and nck_toolcomp_place of one with
// a tool offset.
nck_status_t nck_toolcomp_take(nck_toolcomp_t *self, nck_block_t *block);
void nck_toolcomp_move(const nck_toolcomp_t *self, nck_block_t *block);

// Take a block. Under compensation at most NCK_COMP_SPAN wait: pull before.
// Returns NCK_OK: it passes, and goes on as it is now; NCK_EMPTY: it is taken, what comes of it, if
// anything does, is pulled; NCK_E_COMP_ENTRY, NCK_E_COMP_RADIUS, NCK_E_COMP_GOUGE,
// NCK_E_COMP_EXIT: compensation ends
// there.
// Cost: linear in NCK_COMP_SPAN. Context: prep.
static inline nck_status_t nck_toolcomp_push(nck_toolcomp_t *self, nck_block_t *block) {
    const int passes = self->phase == NCK_COMP_OFF && !self->away && !self->enters;
    if (passes && (!NCK_HAS_COMP || block->kind < NCK_BLOCK_COMP)) return NCK_OK;
    return nck_toolcomp_take(self, block);
}

// 1 if blocks are taken and wait. Cost: constant. Context: prep.
static inline int nck_toolcomp_is_on(const nck_toolcomp_t *self) {
    return self->phase != NCK_COMP_OFF;
}

// Take the next block of what waits. Returns NCK_OK; NCK_EMPTY: push a block before;
// NCK_E_COMP_GOUGE, NCK_E_TRAVEL: compensation ends there, and what waits is dropped.
// Cost: quadratic in NCK_COMP_SPAN where contours are left out or cross, else linear. Context:
// prep.
nck_status_t nck_toolcomp_pull(nck_toolcomp_t *self, nck_block_t *block_out);

// No block follows what waits. Cost: constant. Context: prep.
void nck_toolcomp_end(nck_toolcomp_t *self);

// Take what was found: an error that push or pull has returned, or a note. Returns NCK_OK or
// NCK_EMPTY. Cost: constant. Context: prep.
nck_status_t nck_toolcomp_diagnostic(nck_toolcomp_t *self, nck_diagnostic_t *diagnostic_out);

// Turn a block of the tool tip into a block of the machine: target and arc centre are moved by the
// tool offset in force, which is zero afterwards. Blocks without motion stay. Cost: constant.
// Context: prep.
static inline void nck_toolcomp_place(const nck_toolcomp_t *self, nck_block_t *block) {
    const int64_t *const tool = block->tool_nm;
    if ((tool[0] | tool[1] | tool[2]) != 0) nck_toolcomp_move(self, block);
}

// What must hold between two calls. Returns 1 if it holds. For tests. Cost: constant.
// Context: prep.
int nck_toolcomp_invariants(const nck_toolcomp_t *self);

#endif
