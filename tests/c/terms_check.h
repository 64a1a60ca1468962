// SPDX-License-Identifier: MIT
// What a room under test gets to know of its machine's slope.
#ifndef TERMS_CHECK_H
#define TERMS_CHECK_H

#include "nck/prep/5_slope/slope.h" // nck_slope_terms

// The machine's terms; they stay until the next call.
static inline const nck_terms_t *terms_of(const nck_machine_t *machine)
{
    static nck_terms_t terms;
    nck_slope_terms(machine, &terms);
    return &terms;
}

#endif
