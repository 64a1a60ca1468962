// SPDX-License-Identifier: MIT
// In place of FreeRTOS: types as published (V10 and V11), as far as the glue uses them. The sizes
// of the static buffers are the real ones' concern.
#ifndef INC_FREERTOS_H
#define INC_FREERTOS_H

#include <stddef.h>
#include <stdint.h>

#include <FreeRTOSConfig.h>
#include <portmacro.h>

#ifdef configASSERT
#define configASSERT_DEFINED 1
#else
#define configASSERT_DEFINED 0
#define configASSERT(holds)
#endif

#define pdFALSE ((BaseType_t)0)
#define pdPASS ((BaseType_t)1)

typedef void (*TaskFunction_t)(void *arg);

typedef struct xSTATIC_TCB {
    void *pxDummy1;
} StaticTask_t;

typedef struct xSTATIC_QUEUE {
    void *pvDummy1[3];
} StaticQueue_t;

#endif
