// SPDX-License-Identifier: MIT
// The user's os_cfg.h, or µC/OS-III's template, is the next file of this name: what it says holds.
// Without the hooks there is no tick, and nothing would say so.
#ifndef GLUE_OS_CFG_H
#define GLUE_OS_CFG_H

#include_next <os_cfg.h>

#if !OS_CFG_APP_HOOKS_EN
#error "os_cfg.h: OS_CFG_APP_HOOKS_EN must be 1"
#endif

#endif
