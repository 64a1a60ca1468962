// SPDX-License-Identifier: MIT
// In place of µC/OS-II's Cortex-M port: its types and prototypes as published (V2.93), as far as
// the glue uses them.
#ifndef OS_CPU_H
#define OS_CPU_H

#if !defined(CPU_CFG_KA_IPL_BOUNDARY) || !defined(CPU_CFG_NVIC_PRIO_BITS)
#error "app_cfg.h must define CPU_CFG_KA_IPL_BOUNDARY and CPU_CFG_NVIC_PRIO_BITS"
#endif
#if CPU_CFG_KA_IPL_BOUNDARY == 0u || CPU_CFG_KA_IPL_BOUNDARY >= (1u << CPU_CFG_NVIC_PRIO_BITS)
#error "CPU_CFG_KA_IPL_BOUNDARY is no priority below the highest"
#endif

#ifndef OS_CPU_EXCEPT_STK_SIZE
#define OS_CPU_EXCEPT_STK_SIZE 256u
#endif

typedef unsigned char INT8U;
typedef unsigned short INT16U;
typedef unsigned int INT32U;
typedef unsigned int OS_STK;

extern OS_STK OS_CPU_ExceptStk[OS_CPU_EXCEPT_STK_SIZE];
extern OS_STK *OS_CPU_ExceptStkBase;

void OS_CPU_SysTickInit(INT32U cnts);
void OS_CPU_SysTickHandler(void);
void OS_CPU_PendSVHandler(void);

#endif
