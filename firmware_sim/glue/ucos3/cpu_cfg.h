// SPDX-License-Identifier: MIT
// The user's cpu_cfg.h, or µC/CPU's template, is the next file of this name: what it says holds.
// The template leaves the priority bits out: here are those of the boards in firmware_sim/board.
#ifndef GLUE_CPU_CFG_H
#define GLUE_CPU_CFG_H

#include_next <cpu_cfg.h>

#ifndef CPU_CFG_NVIC_PRIO_BITS
#define CPU_CFG_NVIC_PRIO_BITS 3u
#endif

#endif
