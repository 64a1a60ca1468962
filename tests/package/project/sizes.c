// SPDX-License-Identifier: MIT
// The size of the kernel as a caller of the installed headers sees it, to be read from the object.
#include "nck/nck_memory.h" // nck_t

extern const char kernel_size[sizeof(nck_t)];
const char kernel_size[sizeof(nck_t)] = {0};
