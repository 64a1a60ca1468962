// SPDX-License-Identifier: MIT
// What the Cortex-M port of µC/OS-II asks the application for: the priority bits of the boards in
// firmware_sim/board, and the highest interrupt priority from which the kernel may be called.
#ifndef APP_CFG_H
#define APP_CFG_H

#define CPU_CFG_NVIC_PRIO_BITS 3u
#define CPU_CFG_KA_IPL_BOUNDARY 1u

#endif
