// SPDX-License-Identifier: MIT
// The firmware: which tasks there are, what they share, and one run from job to report.
#include "app/app.h"

#include <string.h> // memset

#include "app/guard.h"  // app_guard_init
#include "app/report.h" // app_report
#include "hal/hal.h"    // hal_read hal_clock_hz

// 0 is the highest. The tick is above all of them: an interrupt.
enum {
    SUPERVISOR = 1, // sees a command or a fault within a tick, whatever the others do; it is short
    FEEDER = 3,     // short too: it waits for its source, and prep must not run dry behind it
    PREP = 5        // has work for all the time that is left
};

enum { EXIT_JOB = 2, EXIT_SYSTEM = 3 };

static const struct {
    const char *name;
    uint32_t priority;
    uint32_t cycle; // [ticks]
    void (*entry)(void *user);
} tasks[APP_TASKS] = {
    {"supervisor", SUPERVISOR, 1, app_supervise}, // commands name ticks
    {"feeder", FEEDER, 1, app_feed},              // its queue wakes it earlier
    {"prep", PREP, 1, app_prepare},               // when it has to wait for the tick
};

void app_overrun_stack(app_task_t *task) {
    if (task->app->supervisor.overrun_stack != task->priority + 1) return;
    volatile uint8_t frame[sizeof task->stack - OS_STACK_GUARD / 2];
    for (size_t k = 0; k < sizeof frame; k++) frame[k] = (uint8_t)k;
    task->app->supervisor.overrun_stack = 0;
}

static void note_fault(void *user, os_fault_t fault, uint32_t priority) {
    app_t *const app = user;
    if (fault == OS_FAULT_STACK) app->fault_stack = priority + 1;
}

// Put a line together from the pieces that the job comes in. Returns 1 at the end of a line.
static int read_line(char *line, size_t *length_out) {
    *length_out = 0;
    char letter = 0;
    while (hal_read(HAL_JOB, &letter, 1) == 1) {
        if (letter == '\n') return 1;
        if (*length_out > APP_JOB_LINE_MAX) continue;
        line[*length_out] = letter;
        ++*length_out;
    }
    return *length_out > 0;
}

static int read_job(app_job_t *job) {
    char line[APP_JOB_LINE_MAX + 1];
    size_t length = 0;
    uint32_t number = 0;
    app_job_init(job);
    while (read_line(line, &length)) {
        number++;
        const app_job_status_t status = app_job_line(job, line, length);
        if (status == APP_JOB_OK) continue;
        app_report_job(number, status);
        return 0;
    }
    return 1;
}

// Give every chunk to the feeder.
static void make_queues(app_t *app) {
    (void)os_queue_create(&app->text.filled, app->text.filled_slots, APP_CHUNKS);
    (void)os_queue_create(&app->text.empty, app->text.empty_slots, APP_CHUNKS);
    for (int k = 0; k < APP_CHUNKS; k++) {
        (void)os_queue_post(&app->text.empty, &app->text.chunk[k]);
    }
}

static int make_tasks(app_t *app) {
    os_status_t status = OS_OK;
    for (int k = 0; k < APP_TASKS && status == OS_OK; k++) {
        app_task_t *const task = &app->task[k];
        task->app = app;
        task->priority = tasks[k].priority;
        task->cycle = tasks[k].cycle;
        status = os_task_create(tasks[k].priority, tasks[k].name, tasks[k].entry, task, task->stack,
                                sizeof task->stack / sizeof task->stack[0]);
    }
    return status == OS_OK;
}

static int start(app_t *app) {
    const os_hooks_t hooks = {app_tick, note_fault, app};
    os_init(&hooks);
    make_queues(app);
    if (!make_tasks(app)) return 0;
    const double units = app->nck.machine.period_s * (double)hal_clock_hz();
    return os_start((uint32_t)(units + 0.5)) == OS_OK;
}

int app_run(app_t *app) {
    memset(app, 0, sizeof *app);
    if (!read_job(&app->job)) return EXIT_JOB;
    app->tick.hash = app_hash_begin();
    if (nck_init(&app->nck, &app->job.machine, NULL) != NCK_OK) {
        app->supervisor.state = APP_FAULT_MACHINE;
        app_report(app);
        return 0;
    }
    app_guard_init(app);
    nck_transform_tick(&app->nck.transform, &app->nck.interpolate.pose, &app->tick.axes);
    if (!start(app)) return EXIT_SYSTEM;
    app_report(app);
    return 0;
}
