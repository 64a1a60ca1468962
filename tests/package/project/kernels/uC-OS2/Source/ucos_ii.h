// SPDX-License-Identifier: MIT
// In place of µC/OS-II: prototypes as published (V2.93), as far as the glue uses them.
#ifndef OS_uCOS_II_H
#define OS_uCOS_II_H

#include <app_cfg.h>
#include <os_cfg.h>
#include <os_cpu.h>
#include <stddef.h>

#define OS_ERR_NONE 0u
#define OS_ERR_TIMEOUT 10u
#define OS_ERR_Q_FULL 30u
#define OS_ERR_Q_EMPTY 31u
#define OS_TASK_OPT_SAVE_FP 0x0004u

typedef struct os_event {
    INT8U OSEventType;
} OS_EVENT;

typedef struct os_tcb {
    INT8U OSTCBPrio;
} OS_TCB;

extern OS_TCB *OSTCBHighRdy;

void OSInit(void);
void OSStart(void);
INT8U OSTaskCreateExt(void (*task)(void *p_arg), void *p_arg, OS_STK *ptos, INT8U prio, INT16U id,
                      OS_STK *pbos, INT32U stk_size, void *pext, INT16U opt);
void OSTimeDly(INT32U ticks);
OS_EVENT *OSQCreate(void **start, INT16U size);
void *OSQAccept(OS_EVENT *pevent, INT8U *perr);
void *OSQPend(OS_EVENT *pevent, INT32U timeout, INT8U *perr);
INT8U OSQPost(OS_EVENT *pevent, void *pmsg);

void App_TaskCreateHook(OS_TCB *ptcb);
void App_TaskDelHook(OS_TCB *ptcb);
void App_TaskIdleHook(void);
void App_TaskReturnHook(OS_TCB *ptcb);
void App_TaskStatHook(void);
void App_TaskSwHook(void);
void App_TCBInitHook(OS_TCB *ptcb);
void App_TimeTickHook(void);

#endif
