// SPDX-License-Identifier: MIT
// In place of µC/OS-III: prototypes as published (V3.08), as far as the glue uses them. The tags
// are those of the original, two of which our own os.h has as well.
#ifndef OS_H
#define OS_H

#include <cpu_core.h>
#include <os_cfg.h>
#include <os_cfg_app.h>
#include <os_cpu.h>
#include <stddef.h>

typedef CPU_INT16U OS_MSG_QTY;
typedef CPU_INT16U OS_MSG_SIZE;
typedef CPU_INT16U OS_OPT;
typedef CPU_INT08U OS_PRIO;
typedef CPU_INT32U OS_TICK;
typedef void (*OS_TASK_PTR)(void *p_arg);
typedef void (*OS_APP_HOOK_VOID)(void);

typedef enum os_err {
    OS_ERR_NONE = 0u,
    OS_ERR_OS_NOT_RUNNING = 24201u,
    OS_ERR_PEND_WOULD_BLOCK = 25008u,
    OS_ERR_Q_MAX = 26003u,
    OS_ERR_SCHED_LOCKED = 28003u,
    OS_ERR_TIMEOUT = 29401u
} OS_ERR;

#define OS_OPT_PEND_BLOCKING (OS_OPT)(0x0000u)
#define OS_OPT_PEND_NON_BLOCKING (OS_OPT)(0x8000u)
#define OS_OPT_POST_FIFO (OS_OPT)(0x0000u)
#define OS_OPT_TASK_SAVE_FP (OS_OPT)(0x0004u)
#define OS_OPT_TIME_DLY (OS_OPT)(0x0000u)

typedef struct os_tcb {
    OS_PRIO Prio;
} OS_TCB;

typedef struct os_q {
    OS_MSG_QTY Entries;
} OS_Q;

typedef struct os_sem {
    CPU_INT32U Ctr;
} OS_SEM;

typedef struct os_mutex {
    OS_TCB *OwnerTCBPtr;
} OS_MUTEX;

extern CPU_STK OSCfg_ISRStk[OS_CFG_ISR_STK_SIZE];
extern OS_TCB *OSTCBHighRdyPtr;
extern OS_APP_HOOK_VOID OS_AppTaskSwHookPtr;
extern OS_APP_HOOK_VOID OS_AppTimeTickHookPtr;

void OSInit(OS_ERR *p_err);
void OSStart(OS_ERR *p_err);
void OSTaskCreate(OS_TCB *p_tcb, CPU_CHAR *p_name, OS_TASK_PTR p_task, void *p_arg, OS_PRIO prio,
                  CPU_STK *p_stk_base, CPU_STK_SIZE stk_limit, CPU_STK_SIZE stk_size,
                  OS_MSG_QTY q_size, OS_TICK time_quanta, void *p_ext, OS_OPT opt, OS_ERR *p_err);
void OSTimeDly(OS_TICK dly, OS_OPT opt, OS_ERR *p_err);
void OSQCreate(OS_Q *p_q, CPU_CHAR *p_name, OS_MSG_QTY max_qty, OS_ERR *p_err);
void *OSQPend(OS_Q *p_q, OS_TICK timeout, OS_OPT opt, OS_MSG_SIZE *p_msg_size, CPU_TS *p_ts,
              OS_ERR *p_err);
void OSQPost(OS_Q *p_q, void *p_void, OS_MSG_SIZE msg_size, OS_OPT opt, OS_ERR *p_err);

#endif
