// SPDX-License-Identifier: MIT
// In place of µC/OS-III's template of the same name: what the glue depends on.
#ifndef OS_CFG_H
#define OS_CFG_H

#define OS_CFG_APP_HOOKS_EN 1u
#define OS_CFG_INVALID_OS_CALLS_CHK_EN 1u

#endif
