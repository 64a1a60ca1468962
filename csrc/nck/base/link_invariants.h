// SPDX-License-Identifier: MIT
// What always holds of the link.
#ifndef NCK_BASE_LINK_INVARIANTS_H
#define NCK_BASE_LINK_INVARIANTS_H

#include "nck/base/link.h" // nck_link_t

// Every invariant of the link, for tests: 1 if all hold. Rings are no fuller than they can be.
// Every final cell goes on at the speed of the one before, and so does the tail, which ends at
// rest. Cost: linear in the cells. Context: any, while neither side works.
int nck_link_invariants(const nck_link_t *self);

#endif
