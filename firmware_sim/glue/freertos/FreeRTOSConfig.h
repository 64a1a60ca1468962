// SPDX-License-Identifier: MIT
// FreeRTOS as glue/freertos.c needs it: static, preemptive, the tick hook and the switch trace.
// configCPU_CLOCK_HZ and the priority bits are those of the boards in firmware_sim/board.
#ifndef FREERTOS_CONFIG_H
#define FREERTOS_CONFIG_H

#include "glue/glue.h" // GLUE_TASKS glue_switch glue_refused

#define configUSE_PREEMPTION 1
#define configUSE_TIME_SLICING 0
#define configUSE_PORT_OPTIMISED_TASK_SELECTION 1
#define configCPU_CLOCK_HZ 25000000ul
#define configTICK_RATE_HZ 1000u // until glue_clock_start says otherwise
#define configMAX_PRIORITIES (GLUE_TASKS + 3)
#define configMINIMAL_STACK_SIZE 256u
#define configMAX_TASK_NAME_LEN 8
#define configUSE_16_BIT_TICKS 0
#define configSTACK_DEPTH_TYPE uint32_t
#define configSUPPORT_STATIC_ALLOCATION 1
#define configSUPPORT_DYNAMIC_ALLOCATION 0
#define configUSE_IDLE_HOOK 0
#define configUSE_TICK_HOOK 1
#define configUSE_MUTEXES 0
#define configUSE_TIMERS 0
#define configCHECK_FOR_STACK_OVERFLOW 0 // os.c paints and looks
#define configASSERT(holds) \
    do { \
        if (!(holds)) glue_refused(); \
    } while (0)
#define INCLUDE_vTaskDelay 1

// The kernel may be called from interrupts at 0x20 and below; the highest can never be kept out.
#define configKERNEL_INTERRUPT_PRIORITY 0xe0u
#define configMAX_SYSCALL_INTERRUPT_PRIORITY 0x20u

#define vPortSVCHandler SVC_Handler
#define xPortPendSVHandler PendSV_Handler
#define xPortSysTickHandler SysTick_Handler

// Here the highest number is the highest priority; 0 is the idle task's.
#define GLUE_TURN(priority) (configMAX_PRIORITIES - 1u - (priority))
void vApplicationTickHook(void);
#define traceTASK_SWITCHED_IN() glue_switch((uint32_t)GLUE_TURN(pxCurrentTCB->uxPriority))

#endif
