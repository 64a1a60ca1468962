// SPDX-License-Identifier: MIT
// The exceptions that the Cortex-M ports of µC/OS-II and µC/OS-III take, by the names of the
// board's vector table. Either kernel's file includes this: in a file of their own the linker would
// not look for them, because the board has weak ones.
#ifndef GLUE_EXCEPTIONS_H
#define GLUE_EXCEPTIONS_H

#include "glue/glue.h" // PendSV_Handler SysTick_Handler

void OS_CPU_SysTickHandler(void);

// A branch, not a call: the port's handler reads the exception's return address from LR.
__attribute__((naked)) void PendSV_Handler(void) { __asm__ volatile("b OS_CPU_PendSVHandler"); }
void SysTick_Handler(void) { OS_CPU_SysTickHandler(); }

#endif
