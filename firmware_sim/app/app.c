// SPDX-License-Identifier: MIT
// The firmware: which tasks there are, what they share, and one run from job to report.
#include "app/app.h"

#include <string.h> // memset

#include "app/guard.h"  // app_guard_init
#include "app/output.h" // app_output
#include "app/report.h" // app_report
#include "hal/hal.h"    // hal_read hal_clock_hz hal_make_safe hal_exit

// 0 is the highest. The tick is above all of them: an interrupt.
enum {
    SUPERVISOR = 1, // sees a command or a fault within a tick, whatever the others do; it is short
    FEEDER = 3,     // short too: it waits for its source, and prep must not run dry behind it
    PREP = 5        // has work for all the time that is left
};

// Without a whole tick for so long the watchdog takes over: more than the longest overrun that can
// still be braked from.
enum { WATCHDOG_TICKS = 16 };

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

// A kernel that refuses what it must do cannot be braked with either.
static void note_fault(void *user, os_fault_t fault, uint32_t priority) {
    app_t *const app = user;
    if (fault == OS_FAULT_STACK) app->fault_stack = priority + 1;
    if (fault == OS_FAULT_KERNEL) hal_exit(APP_EXIT_KERNEL);
}

// The end of every run whose tasks have run.
static void end_run(void *user) {
    hal_make_safe();
    app_report(user);
    hal_exit(0);
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

static int make_queues(app_t *app) {
    const os_status_t filled =
        os_queue_create(&app->text.filled, app->text.filled_slots, APP_CHUNKS);
    const os_status_t empty =
        os_queue_create(&app->text.empty, app->text.empty_slots, APP_CHUNKS);
    return filled == OS_OK && empty == OS_OK;
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

// It comes back only if the tasks cannot run: the hook end_run ends a run.
static void start(app_t *app) {
    const os_hooks_t hooks = {app_tick, note_fault, app, end_run};
    os_init(&hooks);
    if (!make_queues(app) || !make_tasks(app)) return;
    const double units = nck_machine_of(app->nck)->period_s * (double)hal_clock_hz();
    const uint32_t tick_units = (uint32_t)(units + 0.5);
    hal_watchdog_start(tick_units * WATCHDOG_TICKS);
    (void)os_start(tick_units);
}

int app_run(app_t *app, nck_t *nck) {
    memset(app, 0, sizeof *app);
    app->nck = nck;
    if (nck_selftest() != NCK_SELFTEST) return APP_EXIT_BITS;
    if (!read_job(&app->job)) return APP_EXIT_JOB;
    app->tick.hash = app_hash_begin();
    const nck_hooks_t hooks = {.user = app, .on_output = app_output};
    if (nck_init(app->nck, &app->job.machine, &hooks) != NCK_OK) {
        app->supervisor.state = APP_FAULT_MACHINE;
        app_report(app);
        return 0;
    }
    app_guard_init(app);
    (void)nck_position(app->nck, &app->tick.pose, &app->tick.axes);
    start(app);
    return APP_EXIT_SYSTEM;
}
