// SPDX-License-Identifier: MIT
// The prep task: the kernel's asynchronous rooms, a bounded step at a time.
#include "app/app.h"

#include "app/guard.h" // app_guard_tell

// Wait for the next tick if this one's steps are used up; planning ahead is not rationed.
static void ration(app_task_t *task) {
    app_t *const app = task->app;
    if (app->job.prep_steps == 0 || !app->supervisor.started) return;
    if (app->prep.budget == 0 && app->prep.budget_time == os_time()) (void)os_delay(task->cycle);
    if (app->prep.budget_time != os_time()) {
        app->prep.budget_time = os_time();
        app->prep.budget = app->job.prep_steps;
    }
    app->prep.budget--;
}

// Push what the kernel takes of the chunk at hand. No chunk within a tick: the kernel is asked
// again, because a hold or an abort may have come.
static void push_text(app_task_t *task) {
    app_t *const app = task->app;
    void *message = app->prep.chunk;
    if (!message && os_queue_pend(&app->text.filled, task->cycle, &message) != OS_OK) return;
    app_chunk_t *const chunk = message;
    app->prep.chunk = chunk;
    if (chunk->size == 0) {
        nck_end(app->nck);
        return;
    }
    size_t used = 0;
    (void)nck_push(app->nck, chunk->text + chunk->used, chunk->size - chunk->used, &used);
    chunk->used += (uint32_t)used;
    if (chunk->used < chunk->size) return;
    app->prep.chunk = NULL;
    (void)os_queue_post(&app->text.empty, chunk); // as many slots as chunks: never full
}

static void keep_diagnostics(app_t *app) {
    nck_diagnostic_t found;
    while (nck_diagnostic(app->nck, &found) == NCK_OK) {
        if (app->prep.diagnostic_count == APP_DIAGNOSTICS) continue;
        app->prep.diagnostic[app->prep.diagnostic_count] = found;
        app->prep.diagnostic_count++;
    }
}

void app_prepare(void *user) {
    app_task_t *const task = user;
    app_t *const app = task->app;
    for (;;) {
        app_suffer(app, task->priority);
        ration(task);
        app_guard_tell(app);
        const nck_status_t status = nck_prep(app->nck);
        app->prep.steps++;
        os_spend(app->job.prep_units);
        if (status < NCK_OK) app->prep.error = status;
        keep_diagnostics(app);
        if (status == NCK_EMPTY) push_text(task);
        if (status != NCK_FULL && status != NCK_DONE) continue;
        app->prep.done = status == NCK_DONE;
        app->prep.ready = 1;
        (void)os_delay(task->cycle);
    }
}
