// SPDX-License-Identifier: MIT
// In place of FreeRTOS: prototypes of queues as published, as far as the glue uses them.
#ifndef QUEUE_H
#define QUEUE_H

typedef struct QueueDefinition *QueueHandle_t;

#define queueSEND_TO_BACK ((BaseType_t)0)
#define queueQUEUE_TYPE_BASE ((uint8_t)0u)

QueueHandle_t xQueueGenericCreateStatic(const UBaseType_t uxQueueLength,
                                        const UBaseType_t uxItemSize, uint8_t *pucQueueStorage,
                                        StaticQueue_t *pxStaticQueue, const uint8_t ucQueueType);
BaseType_t xQueueGenericSend(QueueHandle_t xQueue, const void *const pvItemToQueue,
                             TickType_t xTicksToWait, const BaseType_t xCopyPosition);
BaseType_t xQueueGenericSendFromISR(QueueHandle_t xQueue, const void *const pvItemToQueue,
                                    BaseType_t *const pxHigherPriorityTaskWoken,
                                    const BaseType_t xCopyPosition);
BaseType_t xQueueReceive(QueueHandle_t xQueue, void *const pvBuffer, TickType_t xTicksToWait);

#define xQueueCreateStatic(length, size, storage, buffer) \
    xQueueGenericCreateStatic((length), (size), (storage), (buffer), queueQUEUE_TYPE_BASE)
#define xQueueSend(queue, item, ticks) \
    xQueueGenericSend((queue), (item), (ticks), queueSEND_TO_BACK)
#define xQueueSendFromISR(queue, item, woken) \
    xQueueGenericSendFromISR((queue), (item), (woken), queueSEND_TO_BACK)

#endif
