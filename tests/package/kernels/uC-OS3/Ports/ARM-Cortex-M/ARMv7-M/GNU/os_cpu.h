// SPDX-License-Identifier: MIT
// In place of µC/OS-III's Cortex-M port: prototypes as published (V3.08), as far as the glue uses
// them.
#ifndef OS_CPU_H
#define OS_CPU_H

void OS_CPU_SysTickInit(CPU_INT32U cnts);
void OS_CPU_SysTickHandler(void);
void OS_CPU_PendSVHandler(void);

#endif
