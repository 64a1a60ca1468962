// SPDX-License-Identifier: MIT
// In place of µC/CPU: prototypes as published (V1.32), as far as the glue uses them.
#ifndef CPU_CORE_MODULE_PRESENT
#define CPU_CORE_MODULE_PRESENT

#include <cpu.h>

void CPU_Init(void);

#endif
