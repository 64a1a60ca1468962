// SPDX-License-Identifier: MIT
// The spindle's angle beside a plan. How long a pass of a thread waits for its angle hangs on every
// period before it, so the plan's cells are executed by a room 6 of its own, with a link of its
// own: the tick's numbers, by the tick's code.
//
//     cell as it becomes final ─▶ ticks as far as cells are known ─▶ of a pass: how many it takes
#ifndef NCK_HOST_SPINDLE_H
#define NCK_HOST_SPINDLE_H

#include "nck/base/link.h"                      // nck_link_t
#include "nck/base/terms.h"                     // nck_terms_t
#include "nck/tick/6_interpolate/interpolate.h" // nck_interpolate_t

#ifdef __cplusplus
extern "C" {
#endif

// A spindle that turns as commanded, beside a plan. Times in s.
typedef struct nck_host_spindle {
    uint32_t on;        // 1: asked for
    uint32_t broken;    // 1: a cell found no room, and nothing here is right
    uint64_t ticks;     // since the last rest
    double known_s;     // from there to the end of the cells that are known
    uint32_t rests;     // 1: the last of them comes to rest
    uint32_t reserved;
    nck_terms_t terms;
    nck_link_t link;
    nck_interpolate_t interpolate;
} nck_host_spindle_t;

// Begin. machine: must stay. Cost: constant. Context: any.
void nck_host_spindle_init(nck_host_spindle_t *self, const nck_machine_t *machine);

// The next cell of the plan, whose segs are still in `from`: of a pass of a thread or of a tap it
// is given the duration that the tick takes, the wait for the spindle's angle and all.
// Cost: linear in the ticks. Context: prep.
void nck_host_spindle_cell(nck_host_spindle_t *self, const nck_link_t *from, nck_cell_t *cell);

#ifdef __cplusplus
}
#endif

#endif
