// SPDX-License-Identifier: MIT
// Where a huge program may be cut: at its waits, and at dwells of some periods, where the path
// rests because the program says so. A cut knows what rooms 1 and 2 know there, so a part can be
// planned without what is before it. The text is read once, whoever plans the parts.
#ifndef NCK_HOST_CUT_H
#define NCK_HOST_CUT_H

#include <stddef.h> // size_t

#include "host/share.h" // nck_host_shares_t
#include "nck/prep/1_decode/decode.h"     // nck_decode_t
#include "nck/prep/2_toolcomp/toolcomp.h" // nck_toolcomp_t

#ifdef __cplusplus
extern "C" {
#endif

// A place between two blocks. It may be copied as bytes, also into another process of the same
// build: pointers in it are not followed but set anew.
typedef struct nck_host_cut {
    nck_decode_t decode;       // has read all before it: modes, offsets, positions, calls, loops
    nck_toolcomp_t toolcomp;
    nck_host_shares_t outputs; // tool, spindle; no rows
    uint64_t blocks;           // before it
    double zone_s;             // a dwell is cut at if it is long against this [s]
} nck_host_cut_t;

// Begin before the first block. machine, text (n bytes): must outlive the search.
// Returns NCK_OK; NCK_E_STATE: this build does not read texts itself, so nothing can be cut.
// Cost: constant. Context: prep.
nck_status_t nck_host_cut_init(nck_host_cut_t *cut, const nck_machine_t *machine, const char *text,
                               size_t n);

// Go on to the next rest with at least so many blocks before it, counted from where the cut is.
// Returns NCK_OK, and the cut is there; NCK_DONE: there is none before the program's end, or before
// its first error, and the cut is of no more use. Cost: linear in the text. Context: prep.
nck_status_t nck_host_cut_next(nck_host_cut_t *cut, uint64_t least);

#ifdef __cplusplus
}
#endif

#endif
