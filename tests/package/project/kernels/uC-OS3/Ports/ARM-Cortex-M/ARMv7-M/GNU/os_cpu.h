// SPDX-License-Identifier: MIT
// In place of µC/OS-III's Cortex-M port: prototypes as published (V3.08), as far as the glue uses
// them.
#ifndef OS_CPU_H
#define OS_CPU_H

#if !defined(CPU_CFG_KA_IPL_BOUNDARY) || !defined(CPU_CFG_NVIC_PRIO_BITS)
#error "cpu_cfg.h must define CPU_CFG_KA_IPL_BOUNDARY and CPU_CFG_NVIC_PRIO_BITS"
#endif
#if CPU_CFG_KA_IPL_BOUNDARY == 0u || CPU_CFG_KA_IPL_BOUNDARY >= (1u << CPU_CFG_NVIC_PRIO_BITS)
#error "CPU_CFG_KA_IPL_BOUNDARY is no priority below the highest"
#endif

extern CPU_STK *OS_CPU_ExceptStkBase;

void OS_CPU_SysTickInit(CPU_INT32U cnts);
void OS_CPU_SysTickHandler(void);
void OS_CPU_PendSVHandler(void);

#endif
