// SPDX-License-Identifier: MIT
// In place of µC/OS-III's template of the same name: what the glue depends on.
#ifndef OS_CFG_APP_H
#define OS_CFG_APP_H

#define OS_CFG_ISR_STK_SIZE 128u
#define OS_CFG_MSG_POOL_SIZE 32u

#endif
