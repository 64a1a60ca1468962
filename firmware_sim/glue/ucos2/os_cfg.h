// SPDX-License-Identifier: MIT
// The user's os_cfg.h, or µC/OS-II's template, is the next file of this name: what it says holds.
// Without the hooks there is no tick, and nothing would say so.
#ifndef GLUE_OS_CFG_H
#define GLUE_OS_CFG_H

#include_next <os_cfg.h>

#if !OS_CPU_HOOKS_EN || !OS_APP_HOOKS_EN
#error "os_cfg.h: OS_CPU_HOOKS_EN and OS_APP_HOOKS_EN must be 1"
#endif
#if !OS_TASK_SW_HOOK_EN || !OS_TIME_TICK_HOOK_EN
#error "os_cfg.h: OS_TASK_SW_HOOK_EN and OS_TIME_TICK_HOOK_EN must be 1"
#endif

#endif
