// SPDX-License-Identifier: MIT
// In place of µC/CPU's template of the same name: what the glue depends on, and as it is there.
#ifndef CPU_CFG_MODULE_PRESENT
#define CPU_CFG_MODULE_PRESENT

#define CPU_CFG_KA_IPL_BOUNDARY 4u

#if 0
#define CPU_CFG_NVIC_PRIO_BITS 4u
#endif

#endif
