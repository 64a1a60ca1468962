// SPDX-License-Identifier: MIT
// What µC/OS-II and its Cortex-M port ask the application for. The user's app_cfg.h, or the
// checkout's template, is the next file of this name: what it says holds, the rest is here.
#ifndef GLUE_APP_CFG_H
#define GLUE_APP_CFG_H

#if __has_include_next(<app_cfg.h>)
#include_next <app_cfg.h>
#endif

// The priority bits of the boards in firmware_sim/board, and the highest interrupt priority from
// which the kernel may be called.
#ifndef CPU_CFG_NVIC_PRIO_BITS
#define CPU_CFG_NVIC_PRIO_BITS 3u
#endif
#ifndef CPU_CFG_KA_IPL_BOUNDARY
#define CPU_CFG_KA_IPL_BOUNDARY 1u
#endif

// Below all tasks of the app; the kernel keeps the last two for itself.
#ifndef OS_TASK_TMR_PRIO
#define OS_TASK_TMR_PRIO (OS_LOWEST_PRIO - 2u)
#endif

// Interrupts run on a stack of the port's, of 256 words unless told. The tick needs more.
#ifndef OS_CPU_EXCEPT_STK_SIZE
#define OS_CPU_EXCEPT_STK_SIZE 640u
#endif

#endif
