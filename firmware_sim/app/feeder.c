// SPDX-License-Identifier: MIT
// The feeder task: the program from its source, a chunk at a time.
#include "app/app.h"

#include "hal/hal.h" // hal_read

static void stay_silent(app_task_t *task) {
    while (task->app->text.pause > 0) {
        (void)os_delay(task->cycle);
        task->app->text.pause--;
    }
}

// Fill a chunk and hand it over. Returns 0 at the end of the program.
static int feed_chunk(app_task_t *task, app_chunk_t *chunk) {
    app_t *const app = task->app;
    stay_silent(task);
    chunk->used = 0;
    chunk->size = (uint32_t)hal_read(HAL_PROGRAM, chunk->text, sizeof chunk->text);
    os_spend(app->job.feeder_units);
    (void)os_queue_post(&app->text.filled, chunk); // as many slots as chunks: never full
    return chunk->size > 0;
}

// Here and not before os_start: some kernels let nobody post until they run. Never full, as above.
static void give_chunks(app_t *app) {
    for (int k = 0; k < APP_CHUNKS; k++) {
        (void)os_queue_post(&app->text.empty, &app->text.chunk[k]);
    }
}

void app_feed(void *user) {
    app_task_t *const task = user;
    int more = 1;
    give_chunks(task->app);
    for (;;) {
        void *message = NULL;
        app_suffer(task->app, task->priority);
        if (!more) (void)os_delay(task->cycle);
        else if (os_queue_pend(&task->app->text.empty, task->cycle, &message) == OS_OK) {
            more = feed_chunk(task, message);
        }
    }
}
