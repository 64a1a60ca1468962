// SPDX-License-Identifier: MIT
// The link between the asynchronous and the synchronous rooms: rings of cells, segs and outputs,
// and the stop tail. The only memory that two contexts share.
//
//      taken                 end
//        │  final cells       │   batch being built (prep's alone)
//   ─────┼────────────────────┼───────────────···▶   cell ring
//        │                    └──▶ tail[parity]: how to stop from here on, if nothing more comes
//
// A tail may also be a whole plan, the first cells of which are made final bit by bit as the tick
// comes near (nck_link_install, nck_link_advance): what is left of it is the tail from there on.
//
// One word says it all: end of the final cells, whether and which tail belongs to that end, and
// whether the tick has entered it. Prep publishes more cells by exchanging the word; the tick
// enters the tail by exchanging it too. Whoever is second sees that he lost: a cell is never taken
// back, a tail never overwritten in use.
//
// To begin anew prep asks for the link; the tick, once it has nothing left to execute, yields it
// and touches nothing until prep has emptied it.
#ifndef NCK_BASE_LINK_H
#define NCK_BASE_LINK_H

#include <assert.h> // assert

#include "nck/base/fence.h"   // nck_fence_load and its kin
#include "nck/base/limits.h"  // capacities
#include "nck/base/marks.h"   // nck_marks_t
#include "nck/base/motion.h"  // nck_motion_work_t
#include "nck/base/records.h" // nck_cell_t nck_seg_t nck_output_t
#include "nck/base/status.h"  // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// Running numbers of cells count modulo 2²⁹.
enum { NCK_LINK_COUNT_MASK = 0x1fffffff };

// Parts of the link's word that more than the link's own file reads.
enum { NCK_LINK_ENTERED = 1, NCK_LINK_PARITY = 2, NCK_LINK_END_SHIFT = 3 };

// Whose the link is.
typedef enum nck_link_owner {
    NCK_LINK_BOTH = 0,  // each his side
    NCK_LINK_ASKED = 1, // the same; prep wants all of it, and publishes nothing
    NCK_LINK_PREP = 2   // prep's alone
} nck_link_owner_t;

// What prep finds in the memory of the next tail as long as it builds none there.
typedef union nck_link_spare {
    struct {
        double number[6][NCK_TAIL_MAX];
        uint32_t index[NCK_TAIL_MAX];
    } ladder;
    NCK_OPTIMAL_MEMBER(nck_motion_work_t, motion)
} nck_link_spare_t;

// The memory of a tail.
typedef union nck_link_tail {
    nck_cell_t cell[NCK_TAIL_MAX];
    nck_link_spare_t spare;
} nck_link_tail_t;

// The link. Who writes a member stands behind it; the tick reads the rings, prep fills them.
typedef struct nck_link {
    uint32_t owner;       // nck_link_owner_t; both: prep asks and gives back, the tick yields
    uint32_t word;        // end << 3 | has tail << 2 | parity << 1 | entered; both, by exchange
    uint32_t seg_head;    // segs pushed; prep writes
    uint32_t output_head; // outputs pushed; prep writes
    uint32_t base;        // the word that the batch builds on; prep alone
    uint32_t batch;       // cells behind the end, not yet final; prep alone
    uint32_t tail_fill;   // cells in the tail being built; prep alone
    uint32_t tail_entered; // whether the tick was in the old tail then; prep alone
    uint32_t lead_seen;   // cells whose time has left lead_s; prep alone
    double lead_s;        // duration of the final cells from lead_seen on; prep alone
    uint32_t broken;      // 1: a cell was put in that is none; prep alone
    uint32_t broken_line; // its source line; prep alone
    nck_cell_t *tail_at;  // where the next cell of the tail being built goes; prep alone

    uint32_t taken;        // cells taken by the tick; tick writes
    uint32_t seg_done;     // segs finished; tick writes
    uint32_t output_taken; // outputs handed over; tick writes
    uint32_t tail_rested;  // word's end whose tail has come to rest, plus one; tick writes
    uint32_t tail_taken;   // cells taken from the tail; tick alone

    uint32_t tail_count[2];
    uint32_t tail_origin[2]; // end of the final cells that the tail's first cell follows
    nck_cell_t cell[NCK_CELL_MAX];
    nck_link_tail_t tail[2];
    nck_seg_t seg[NCK_SEG_MAX];
    nck_output_t output[NCK_OUTPUT_MAX];
    nck_marks_t marks; // lines of the path; prep writes
} nck_link_t;

// Empty the link. Cost: constant. Context: any, before the tick runs.
void nck_link_init(nck_link_t *self);

// Room for more? Cells: free places behind the batch. Cost: constant. Context: prep.
uint32_t nck_link_cell_room(const nck_link_t *self);

// 1 if a seg and an output find room. Cost: constant. Context: prep.
static inline int nck_link_has_room(const nck_link_t *self) {
    return self->seg_head - nck_fence_load(&self->seg_done) < NCK_SEG_MAX
           && self->output_head - nck_fence_load(&self->output_taken) < NCK_OUTPUT_MAX;
}

// The way of a source line ends somewhere on the path. Cost: constant. Context: prep.
void nck_link_push_mark(nck_link_t *self, const nck_mark_t *mark);

// Put a seg in; its place is its seq. NCK_OK or NCK_FULL. Cost: constant. Context: prep.
nck_status_t nck_link_push_seg(nck_link_t *self, const nck_seg_t *seg);

// The place of the next seg, to be filled where it is, and that it is filled. There must be room.
// Cost: constant. Context: prep.
static inline nck_seg_t *nck_link_seg_place(nck_link_t *self) {
    return &self->seg[self->seg_head & (NCK_SEG_MAX - 1)];
}
static inline void nck_link_seg_placed(nck_link_t *self, nck_seg_t *seg) {
    if (NCK_HAS_MARKS) nck_marks_tell(&self->marks, seg);
    nck_fence_store(&self->seg_head, self->seg_head + 1);
}

// Put an output in. NCK_OK or NCK_FULL. Cost: constant. Context: prep.
nck_status_t nck_link_push_output(nck_link_t *self, const nck_output_t *output);

// Begin a batch on what is final now. Returns 1 if the tick has entered the tail: then the batch
// must go on from the tail's end, else 0. Cost: constant. Context: prep.
int nck_link_batch_begin(nck_link_t *self);

// Put a cell behind the batch (there must be room). Cost: constant. Context: prep.
void nck_link_push_cell(nck_link_t *self, const nck_cell_t *cell);

// A cell was put in that is none. Cost: constant. Context: prep.
void nck_link_break(nck_link_t *self, const nck_cell_t *cell);

// Whether a cell is one; one sum tells: what is not finite makes it so. Cost: constant.
// Context: prep.
static inline void nck_link_inspect(nck_link_t *self, const nck_cell_t *cell) {
    const double sum = cell->s + cell->length + cell->v + cell->a + cell->j + cell->duration;
    const int good = sum - sum == 0.0 && cell->length >= 0.0 && cell->duration >= 0.0;
    if (!good) nck_link_break(self, cell);
}

// Which of the two tails a word says is published. Cost: constant. Context: any.
static inline uint32_t nck_link_parity(uint32_t word) { return word / NCK_LINK_PARITY & 1u; }

// Begin the tail of the batch; then put its cells in, NCK_TAIL_MAX at most.
// Cost: constant. Context: prep.
void nck_link_tail_begin(nck_link_t *self);
void nck_link_tail_push(nck_link_t *self, const nck_cell_t *cell);

// The same in place: where the tail's next cells go, and that so many more stand there.
// Cost: constant; linear in the cells. Context: prep.
static inline nck_cell_t *nck_link_tail_room(nck_link_t *self) { return self->tail_at; }
void nck_link_tail_grow(nck_link_t *self, uint32_t count);

// The same of one cell, that stands where nck_link_tail_room has said. Cost: constant.
// Context: prep.
static inline void nck_link_tail_placed(nck_link_t *self, const nck_cell_t *cell) {
    assert(self->tail_fill < NCK_TAIL_MAX);
    nck_link_inspect(self, cell);
    self->tail_fill++;
    self->tail_at++;
}

// The memory of the tail that is built next, for prep to work in until nck_link_tail_begin; a tail
// that was being built is lost. It stays where it is until something is published.
// Cost: constant. Context: prep.
nck_link_spare_t *nck_link_spare(nck_link_t *self);

// Make the batch final, with its tail, in one exchange.
// Returns NCK_OK; NCK_FULL while the old tail has been entered but has not come to rest yet (the
// batch is kept); NCK_E_STATE if the tick has entered the old tail since the batch was begun (the
// batch is void: begin another); NCK_E_INTERNAL once a cell was put in with a number that is not
// finite, or a length or duration below zero: nothing is published from then on, and the tick comes
// to rest on what is. Cost: constant. Context: prep.
nck_status_t nck_link_publish(nck_link_t *self);

// Make the cells put in since nck_link_tail_begin the plan from the end of the final cells on; the
// first of them become final at once, up to `lead` seconds of them (one at least), and no more than
// `most`. Returns as nck_link_publish, and NCK_FULL too if the ring has no room.
// Cost: linear in the cells made final. Context: prep.
nck_status_t nck_link_install(nck_link_t *self, double lead, uint32_t most);

// Make more of the published tail final, until `lead` seconds wait for the tick, and no more cells
// than `most`. Returns NCK_OK; NCK_FULL if there was nothing to do; NCK_E_STATE if the tick is in
// the tail. Cost: linear in the cells made final. Context: prep.
nck_status_t nck_link_advance(nck_link_t *self, double lead, uint32_t most);

// How long the final cells last that the tick has not taken [s].
// Cost: linear in the cells taken since it was last asked. Context: prep.
double nck_link_lead(nck_link_t *self);

// The end of the final cells as a running number; 1 in *entered_out if the tick is in the tail.
// Cost: constant. Context: prep.
static inline uint32_t nck_link_end(const nck_link_t *self, int *entered_out) {
    const uint32_t word = nck_fence_load(&self->word);
    *entered_out = (word & NCK_LINK_ENTERED) != 0;
    return word >> NCK_LINK_END_SHIFT;
}

// The source line of the cell that made nck_link_publish or nck_link_install say NCK_E_INTERNAL.
// Cost: constant. Context: prep.
uint32_t nck_link_broken_line(const nck_link_t *self);

// The tick has finished all segs before this one. Cost: constant. Context: prep.
uint32_t nck_link_finished(const nck_link_t *self);

// Cells that the tick has taken, as a running number. Cost: constant. Context: prep.
static inline uint32_t nck_link_taken(const nck_link_t *self) {
    return nck_fence_load(&self->taken);
}

// The cell number `count` (as nck_link_end counts) of the published tail or plan, whether final or
// not; NULL outside of it. Cost: constant. Context: prep.
const nck_cell_t *nck_link_tail_cell(const nck_link_t *self, uint32_t count);

// The i-th cell of the tail being built; NULL outside of it. Cost: constant. Context: prep.
const nck_cell_t *nck_link_built_cell(const nck_link_t *self, uint32_t i);

// The last cell of the last published tail and the count of them; NULL and 0 if it is empty.
// Cost: constant. Context: prep.
const nck_cell_t *nck_link_tail_end(const nck_link_t *self, uint32_t *count_out);

// Ask the tick for the link, and publish nothing from then on. Cost: constant. Context: prep.
void nck_link_ask(nck_link_t *self);

// Whose the link is, an nck_link_owner_t. Cost: constant. Context: any.
static inline uint32_t nck_link_owner(const nck_link_t *self) {
    return nck_fence_load(&self->owner);
}

// Empty the link that the tick has yielded: its numbers count from 0 again. Then give it back.
// Cost: constant. Context: prep.
void nck_link_renew(nck_link_t *self);
void nck_link_give_back(nck_link_t *self);

// Yield the link that prep has asked for. Cost: constant. Context: tick.
void nck_link_yield(nck_link_t *self);

// 1 if neither a final cell nor a tail that has not come to rest is left to take. Cost: constant.
// Context: any; another than tick's: as long as nothing is published.
int nck_link_is_spent(const nck_link_t *self);

// Take the next final cell; there must be one (nck_link_waiting). Cost: constant. Context: tick.
static inline void nck_link_take_final(nck_link_t *self, nck_cell_t *cell_out) {
    *cell_out = self->cell[self->taken & (NCK_CELL_MAX - 1)];
    nck_fence_store(&self->taken, (self->taken + 1) & NCK_LINK_COUNT_MASK);
}

// Take the next cell: a final one, else one of the tail (*from_tail_out = 1), else NCK_EMPTY.
// Cost: constant, no spinning. Context: tick.
nck_status_t nck_link_take(nck_link_t *self, nck_cell_t *cell_out, int *from_tail_out);

// The cell that is taken when n others have been, under a word of the link: a final one, or of the
// tail; NULL: none is known. What is read of a tail counts if the word still holds behind that.
// Cost: constant. Context: tick.
const nck_cell_t *nck_link_ahead(const nck_link_t *self, uint32_t word, uint32_t n);
static inline uint32_t nck_link_word(const nck_link_t *self) {
    return nck_fence_load(&self->word);
}
static inline int nck_link_holds(nck_link_t *self, uint32_t word) {
    return nck_fence_exchange(&self->word, word, word);
}

// The tail has come to rest: prep may publish again. Cost: constant. Context: tick.
void nck_link_tail_rest(nck_link_t *self);

// All segs before seq are finished: their places may be used again. Cost: constant. Context: tick.
static inline void nck_link_seg_finish(nck_link_t *self, uint32_t seq) {
    if (seq != self->seg_done) nck_fence_store(&self->seg_done, seq);
}

// The geometry of a seg that is not finished. Cost: constant. Context: tick.
const nck_seg_t *nck_link_seg(const nck_link_t *self, uint32_t seq);

// 1 if an output waits whose segs are all finished. Cost: constant. Context: tick.
static inline int nck_link_has_output(const nck_link_t *self) {
    if (nck_link_owner(self) == NCK_LINK_PREP) return 0;
    if (self->output_taken == nck_fence_load(&self->output_head)) return 0;
    const uint32_t after = self->output[self->output_taken & (NCK_OUTPUT_MAX - 1)].after_segs;
    return (int32_t)(self->seg_done - after) >= 0;
}

// Take the next output whose segs are all finished; NCK_EMPTY if there is none, or the link
// yielded.
// Cost: constant. Context: tick.
nck_status_t nck_link_take_output(nck_link_t *self, nck_output_t *output_out);

// Final cells that wait. Cost: constant. Context: tick.
static inline uint32_t nck_link_waiting(const nck_link_t *self) {
    const uint32_t end = nck_fence_load(&self->word) >> NCK_LINK_END_SHIFT;
    return (end - self->taken) & NCK_LINK_COUNT_MASK;
}

// 1 if no final cell and no output waits. Cost: constant. Context: tick.
int nck_link_is_empty(const nck_link_t *self);

#ifdef __cplusplus
}
#endif

#endif
