// SPDX-License-Identifier: MIT
// Inside room 5: a plan that begins at a sharp corner overlaps the end of the one that leads there.
#ifndef NCK_PREP_OVERLAP_H
#define NCK_PREP_OVERLAP_H

#include "nck/base/limits.h"       // NCK_CELL_MAX
#include "nck/base/link.h"         // nck_link_t
#include "nck/base/machine.h"      // nck_machine_t
#include "nck/prep/5_slope/plan.h" // nck_plan_t nck_pieces_t

// Cells of a plan that are withheld, at most: the ring has room for others, too.
enum { NCK_OVERLAP_CELLS = NCK_CELL_MAX / 2 };

// How many of a plan's last cells wait for the plan behind its rest (nck_plan_t.withheld): all that
// it may overlap, none of those that are beside the plan before; 0: it may not. The plan is built.
// Cost: linear in those cells. Context: prep.
uint32_t nck_overlap_withheld(const nck_link_t *link, const nck_pieces_t *pieces,
                              const nck_plan_t *next);

// How long before the rest of `now` the plan `next`, which is built, begins [s], and in
// next->beside how many of its cells are beside it; 0: behind the rest, and nothing is withheld any
// longer. Cost: linear in the cells that overlap. Context: prep.
double nck_overlap_join(const nck_machine_t *machine, const nck_link_t *link,
                        const nck_pieces_t *pieces, const nck_wish_t *wish, nck_plan_t *now,
                        nck_plan_t *next);

#endif
