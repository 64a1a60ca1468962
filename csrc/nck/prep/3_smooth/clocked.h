// SPDX-License-Identifier: MIT
// Inside room 3: runs of blocks within a tolerance become a clocked path (CURVE.md), interval by
// interval, with their outputs.
#ifndef NCK_PREP_CLOCKED_H
#define NCK_PREP_CLOCKED_H

#include "nck/base/records.h"         // nck_seg_t nck_output_t
#include "nck/base/status.h"          // nck_status_t
#include "nck/base/terms.h"           // nck_terms_t
#include "nck/prep/3_smooth/stream.h" // nck_stream_t

// The run in work.
typedef struct nck_clocked {
    uint8_t open;    // 1: there is one
    uint8_t closed;  // 1: it gets no more blocks
    uint8_t rests;   // 1: what is before it has to come to rest first
    struct {
        uint32_t head, tail; // taken, given
        struct {
            double s;            // where in the run [path mm]
            nck_output_t output;
        } at[NCK_CLOCKED_OUTPUTS];
    } out;
    double s;        // length of the blocks taken [path mm]
    double position[NCK_AXIS_MAX]; // end of the last interval given [mm, deg]
    nck_stream_t stream;
} nck_clocked_t;

// None is open. Cost: constant. Context: any, before the tick runs.
void nck_clocked_init(nck_clocked_t *self);

// 1 if an output has room in the run. Cost: constant. Context: prep.
static inline int nck_clocked_has_room(const nck_clocked_t *self) {
    return self->out.head - self->out.tail < NCK_CLOCKED_OUTPUTS;
}

// Take a block's exact seg; the first one opens a run. rests: 1: the path does, so far.
// Returns NCK_OK; NCK_FULL: pull first. Cost: constant. Context: prep.
nck_status_t nck_clocked_push(nck_clocked_t *self, const nck_terms_t *terms, const nck_seg_t *seg,
                              double tolerance, int rests);

// Take an output, which has room. Cost: constant. Context: prep.
void nck_clocked_push_output(nck_clocked_t *self, const nck_output_t *output);

// The run gets no more blocks. Cost: constant. Context: prep.
void nck_clocked_close(nck_clocked_t *self);

// What comes next of the run. NCK_OK: *output_out, if not NULL, else *seg_out; NCK_FULL: call
// again; NCK_EMPTY: it needs a block, or to be closed; NCK_DONE: the run is over.
// Cost: nck_stream_step. Context: prep.
nck_status_t nck_clocked_pull(nck_clocked_t *self, nck_seg_t *seg_out,
                              const nck_output_t **output_out);

#endif
