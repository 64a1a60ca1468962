// SPDX-License-Identifier: MIT
// In place of µC/CPU's Cortex-M port: its types as published (V1.32), as far as the glue uses them.
#ifndef CPU_MODULE_PRESENT
#define CPU_MODULE_PRESENT

#include <cpu_cfg.h>

typedef char CPU_CHAR;
typedef unsigned char CPU_INT08U;
typedef unsigned short CPU_INT16U;
typedef unsigned int CPU_INT32U;
typedef CPU_INT32U CPU_STK;
typedef CPU_INT32U CPU_STK_SIZE;
typedef CPU_INT32U CPU_TS;

#endif
