// SPDX-License-Identifier: MIT
// In place of FreeRTOS' port for the Cortex-M4F (and, copied by the test, for the Cortex-M7): types
// and prototypes as published, as far as the glue uses them.
#ifndef PORTMACRO_H
#define PORTMACRO_H

typedef uint32_t StackType_t;
typedef long BaseType_t;
typedef unsigned long UBaseType_t;
typedef uint32_t TickType_t;

#define portMAX_DELAY ((TickType_t)0xffffffffUL)
#define portYIELD_FROM_ISR(is_higher_awake) \
    do { \
        if ((is_higher_awake) != 0) *(volatile uint32_t *)0xe000ed04u = 1u << 28; \
    } while (0)

BaseType_t xPortIsInsideInterrupt(void);
void vPortSVCHandler(void);
void xPortPendSVHandler(void);
void xPortSysTickHandler(void);

#endif
