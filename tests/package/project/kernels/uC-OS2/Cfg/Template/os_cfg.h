// SPDX-License-Identifier: MIT
// In place of µC/OS-II's template of the same name: what the glue depends on.
#ifndef OS_CFG_H
#define OS_CFG_H

#define OS_APP_HOOKS_EN 1u
#define OS_CPU_HOOKS_EN 1u
#define OS_TASK_SW_HOOK_EN 1u
#define OS_TIME_TICK_HOOK_EN 1u
#define OS_LOWEST_PRIO 63u
#define OS_MAX_EVENTS 10u
#define OS_MAX_QS 4u
#define OS_TMR_EN 1u

#endif
