// SPDX-License-Identifier: MIT
// The classical S-shape: acceleration is zero at every junction. The junction behind the piece in
// work gets the largest speed from which rest is possible within the look-ahead (Cao et al. 2014,
// section 8). README, section "S-shape".
//
//     pieces ─▶ look further ─▶ speeds, backward ─▶ a run ─▶ … ─▶ brake ─▶ install
//
// A run is what lies between two places without acceleration: a piece, or pieces of one seg where
// the zones next to its junctions need no rest of the acceleration of their own. A part of it is a
// ramp, or a stretch of cruise: it begins and ends without acceleration, so that the path can be
// braked from its end. The part becomes final, the brake is the tail.
#ifndef NCK_PREP_SSHAPE_H
#define NCK_PREP_SSHAPE_H

#include "nck/base/limits.h"               // NCK_WINDOW NCK_TAIL_MAX
#include "nck/base/link.h"                 // nck_link_t
#include "nck/base/machine.h"              // nck_machine_t
#include "nck/base/status.h"               // nck_status_t
#include "nck/prep/5_slope/plan.h"         // nck_pieces_t
#include "nck/prep/5_slope/sshape_piece.h" // nck_sshape_course_t

enum { NCK_SSHAPE_RUN = 3 }; // pieces of a run at most: head, middle, tail of a seg

// A place on the path that is passed without acceleration.
typedef struct nck_sshape_place {
    uint32_t piece; // running number of the run's first piece
    uint32_t fresh; // 1: where that piece begins; s is not set
    double s;       // path coordinate in the run's seg [path mm]
    double v;       // speed there [path mm/s]
} nck_sshape_place_t;

typedef struct nck_sshape {
    const nck_machine_t *machine;
    nck_link_t *link;        // producer's side
    uint32_t phase;
    uint32_t in_tail;        // 1: the tick has been seen in the stop tail
    nck_sshape_place_t done; // where the published part ends
    nck_sshape_place_t rest; // where the brake behind it comes to rest
    nck_sshape_place_t at;   // how far the part in work is drawn
    nck_sshape_place_t brake; // how far the brake behind it is drawn

    struct {
        uint32_t begin;      // published part: follows so many final cells
        uint32_t cells;      // of it
        uint32_t built;      // cells of the part in work
        double time;         // that they last [s]
    } part;

    struct {
        uint32_t set;        // 1: known for the run at `at`
        uint32_t stage;      // what comes next: rise, cruise or fall
        nck_sshape_course_t way;
    } course;

    // the look-ahead, in pieces
    struct {
        uint32_t horizon;    // it sees the pieces before this one, and assumes rest there
        uint32_t looks;      // 1: it is being moved on
        uint32_t was;        // horizon that the speeds were last computed for
        uint32_t i;          // backward: the next node
        uint32_t capped;     // the last node known whose own cap holds it; lower ones behind are
                             // held by the horizon
        double v[NCK_WINDOW]; // speed at a run's start from which the horizon's rest is possible
        uint8_t pieces[NCK_WINDOW]; // of the run that begins with a piece; 0: within a run
    } ahead;
} nck_sshape_t;

// Cost: linear in the capacities. Context: any, before the tick runs.
void nck_sshape_init(nck_sshape_t *self, const nck_machine_t *machine, nck_link_t *link);

// One bounded piece of work. hold: 1: make nothing more final, so that the tick comes to rest on
// the stop tail. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_FULL (waits for the
// tick, or holds), NCK_E_INTERNAL (a broken plan, see nck_link_publish). Cost: 32 pieces looked at
// or their speeds found, or one run drawn, or eight braked through, or the cells of a part made
// final. Context: prep.
nck_status_t nck_sshape_step(nck_sshape_t *self, const nck_pieces_t *pieces, uint32_t hold);

// The number of the oldest piece that is still needed. Cost: constant. Context: prep.
uint32_t nck_sshape_needs(const nck_sshape_t *self);

#endif
