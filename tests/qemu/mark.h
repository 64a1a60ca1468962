// SPDX-License-Identifier: MIT
// Where a measurement begins and ends: empty functions that the emulator's plugin (count.c) knows
// by their addresses.
#ifndef MARK_H
#define MARK_H

void mark_prep_begin(void);
void mark_prep_end(void);
void mark_tick_begin(void);
void mark_tick_end(void);

#endif
