// SPDX-License-Identifier: MIT
// The user's os_cfg_app.h, or µC/OS-III's template, is the next file of this name: what it says
// holds, but for a stack of interrupts too small for the tick. The template's has 128 words.
#ifndef GLUE_OS_CFG_APP_H
#define GLUE_OS_CFG_APP_H

#include_next <os_cfg_app.h>

#if OS_CFG_ISR_STK_SIZE < 640u
#undef OS_CFG_ISR_STK_SIZE
#define OS_CFG_ISR_STK_SIZE 640u
#endif

#endif
