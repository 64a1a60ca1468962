// SPDX-License-Identifier: MIT
// In place of µC/OS-II's template of the same name: it knows nothing of the Cortex-M port.
#ifndef APP_CFG_H
#define APP_CFG_H

#define APP_CFG_STARTUP_TASK_PRIO 3u
#define OS_TASK_TMR_PRIO (OS_LOWEST_PRIO - 2u)

#endif
