// SPDX-License-Identifier: MIT
// What a library of the kernel shows of its build. It knows no records, so that a caller needs none
// of its capacities.
#ifndef SIM_DOOR_H
#define SIM_DOOR_H

// Tell the build that this library is. build: sim_build_t, to be filled in.
// Cost: constant. Context: any.
void sim_build_tell(void *build);

#endif
