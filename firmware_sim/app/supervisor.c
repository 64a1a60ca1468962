// SPDX-License-Identifier: MIT
// The supervisor task: the operator's commands, the state that he is shown, and what follows from a
// fault. Every fault ends at rest in a state of its own, which is safe: drives, spindle and coolant
// are off. The first one counts, but for the emergency stop, which ends everything.
#include "app/app.h"

#include "app/guard.h" // app_guard_set
#include "hal/hal.h"   // hal_make_safe hal_switch

enum {
    SETTLE_TICKS = 16,  // that a last state is watched for
    ALONE_TICKS = 1000, // at rest after the last command: nobody will resume any more
    PERCENT_MOST = 200  // of an override: what is more counts as much
};

static int is_over(const app_t *app) { return app->supervisor.state >= APP_DONE; }

// A last state: the setpoint stays as it is.
static void finish(app_t *app, uint32_t state) {
    app->supervisor.frozen = 1;
    if (state >= APP_SOFT_LIMIT) hal_make_safe();
    app_enter(app, state);
}

// Brake on the path, then end in the state goal.
static void end_in(app_t *app, uint32_t goal) {
    if (app->supervisor.goal != APP_IDLE) return;
    app->supervisor.goal = goal;
    nck_abort(app->nck);
}

// An override in millionths.
static uint32_t ppm_of(uint32_t percent) {
    return percent < PERCENT_MOST ? percent * NCK_PERCENT : PERCENT_MOST * NCK_PERCENT;
}

// Returns 1, or 0 if this machine cannot follow: a travel needs a joint.
static int execute(app_t *app, const app_command_t *command) {
    const app_range_t travel = {command->argument[1], command->argument[2], 1};
    const uint32_t first = (uint32_t)command->argument[0];
    const uint32_t second = (uint32_t)command->argument[1];
    switch (command->kind) {
    case APP_HOLD: nck_hold(app->nck); break;
    case APP_RESUME: nck_resume(app->nck); break;
    case APP_OVERRIDE: nck_set_override(app->nck, ppm_of(first), ppm_of(second)); break;
    case APP_SINGLE_BLOCK: nck_set_single_block(app->nck, first); break;
    case APP_ABORT: end_in(app, APP_ABORTED); break;
    case APP_ESTOP: finish(app, APP_EMERGENCY); break;
    case APP_TRAVEL: return app_guard_set(app, command->argument[0], &travel);
    case APP_FEEDER_PAUSE: app->text.pause = first; break;
    case APP_TICK_WORK:
        app->supervisor.work_units = first;
        app->supervisor.work_ticks = second;
        break;
    default:
        app->supervisor.harmed = first;
        app->supervisor.harm_units = second;
        app->supervisor.harm = command->kind;
        break;
    }
    return 1;
}

static void obey(app_t *app) {
    while (app->supervisor.command < app->job.command_count) {
        const app_command_t *const next = &app->job.command[app->supervisor.command];
        if (next->tick > app->tick.count) return;
        app->supervisor.command++;
        if (!is_over(app) && !execute(app, next)) app->supervisor.refused++;
    }
}

static void look_for_faults(app_t *app) {
    if (app->tick.beyond) finish(app, APP_SOFT_LIMIT);
    if (app->fault_stack) end_in(app, APP_FAULT_STACK);
    if (os_overruns() > 0) end_in(app, APP_FAULT_OVERRUN);
    if (nck_is_at_travel(app->nck)) end_in(app, APP_SOFT_LIMIT);
    const int starving = app->tick.state == NCK_TICK_STARVED && app->tick.resting > 0;
    app->supervisor.starved = starving ? app->supervisor.starved + 1 : 0;
    if (app->job.starve_ticks > 0 && app->supervisor.starved >= app->job.starve_ticks) {
        end_in(app, APP_FAULT_STARVED);
    }
}

// M0, M1, M6: the operator is there after a while.
static void wait_for_operator(app_t *app) {
    const int waits = app->tick.state == NCK_TICK_WAIT;
    if (!waits || app->supervisor.wait_seg != app->tick.pose.seg) app->supervisor.waited = 0;
    app->supervisor.wait_seg = app->tick.pose.seg;
    app->supervisor.waited += (uint32_t)waits;
    if (waits && app->supervisor.waited == app->job.wait_ticks) nck_resume(app->nck);
}

static uint32_t state_of_motion(const app_t *app) {
    switch (app->tick.state) {
    case NCK_TICK_WAIT: return APP_WAIT;
    case NCK_TICK_STARVED: return APP_STARVED;
    case NCK_TICK_HOLD: return app->tick.resting > 0 ? APP_HELD : APP_STOPPING;
    default: return APP_RUN;
    }
}

static void follow_motion(app_t *app) {
    const int drained = app->prep.done && app->tick.idle;
    if (app->supervisor.goal != APP_IDLE) {
        const int at_rest = drained || app->tick.resting >= APP_REST_TICKS;
        if (at_rest) finish(app, app->supervisor.goal);
        else app_enter(app, APP_STOPPING);
        return;
    }
    if (drained) finish(app, app->prep.error < NCK_OK ? APP_PROGRAM_ERROR : APP_DONE);
    else app_enter(app, state_of_motion(app));
}

// Ticks that the state must last before the run is ended; 0: it goes on.
static uint32_t patience(const app_t *app) {
    const int waits = app->supervisor.state == APP_HELD
                      || (app->supervisor.state == APP_WAIT && app->job.wait_ticks == 0);
    if (is_over(app)) return SETTLE_TICKS;
    return waits && app->supervisor.command == app->job.command_count ? ALONE_TICKS : 0;
}

static void end_run(app_t *app) {
    const int late = app->job.max_ticks > 0 && os_time() >= app->job.max_ticks;
    const uint32_t ticks = patience(app);
    app->supervisor.settled = ticks > 0 ? app->supervisor.settled + 1 : 0;
    if (late || (ticks > 0 && app->supervisor.settled >= ticks)) os_stop();
}

void app_enter(app_t *app, uint32_t state) {
    if (app->supervisor.state == state) return;
    app->supervisor.state = state;
    if (app->supervisor.event_count == APP_EVENTS) return;
    app_event_t *const event = &app->supervisor.event[app->supervisor.event_count];
    event->tick = app->tick.count;
    event->state = state;
    app->supervisor.event_count++;
}

static void begin_motion(app_t *app) {
    hal_switch(HAL_DRIVES, 1);
    app->supervisor.started = 1;
}

void app_supervise(void *user) {
    app_task_t *const task = user;
    app_t *const app = task->app;
    for (;;) {
        app->supervisor.seen = os_time();
        obey(app);
        if (app->tick.count > 0 && !is_over(app)) {
            wait_for_operator(app);
            look_for_faults(app);
        }
        if (app->tick.count > 0 && !is_over(app)) follow_motion(app);
        if (app->prep.ready && !app->supervisor.started) begin_motion(app);
        end_run(app);
        app_suffer(app, task->priority);
        (void)os_delay(task->cycle);
    }
}
