// SPDX-License-Identifier: MIT
// The tick: one setpoint a period, in the interrupt.
#include "app/app.h"

#include <string.h> // memcmp

#include "app/guard.h"  // app_guard_lets
#include "app/output.h" // app_output_follow
#include "hal/hal.h"    // hal_write hal_make_safe hal_watchdog_feed

enum { SUPERVISOR_LATE = 50 }; // ticks without a cycle of the supervisor that are a fault

static const uint64_t fnv_prime = 1099511628211u; // FNV-1a of 64 bits: Fowler, Noll, Vo

uint64_t app_hash_begin(void) { return 14695981039346656037u; }

// Continue a hash with an integer, lowest byte first.
static uint64_t hash_integer(uint64_t hash, int64_t value) {
    uint64_t rest = (uint64_t)value;
    for (int byte = 0; byte < 8; byte++) {
        hash = (hash ^ (rest & 0xffu)) * fnv_prime;
        rest >>= 8;
    }
    return hash;
}

// Idle ticks do not count: how many there are depends on how soon prep goes on after a stop, and on
// when the run is ended.
static void count_setpoint(app_t *app) {
    app->tick.count++;
    if (app->supervisor.frozen) app->tick.state = NCK_TICK_IDLE;
    if (app->tick.state == NCK_TICK_IDLE) return;
    app->tick.used++;
    for (uint32_t k = 0; k < nck_joint_count(app->nck); k++) {
        app->tick.hash = hash_integer(app->tick.hash, app->tick.axes.joint_nm[k]);
    }
}

static void write_row(const app_t *app) {
    const app_row_t row = {
        app->tick.count, app->tick.pose.line, nck_queue_cells(app->nck),
        (uint8_t)app->supervisor.state, (uint8_t)app->tick.state, app->tick.pose.limit,
        hal_switched(HAL_DRIVES) != 0
    };
    uint8_t bytes[sizeof row + sizeof app->tick.axes.joint_nm];
    const size_t joints = nck_joint_count(app->nck) * sizeof app->tick.axes.joint_nm[0];
    memcpy(bytes, &row, sizeof row);
    memcpy(bytes + sizeof row, app->tick.axes.joint_nm, joints);
    hal_write(HAL_TRACE, bytes, sizeof row + joints);
}

// An override of nothing rests in the middle of the path as a late prep does, or before a block as
// an ended program does, but the operator wants it so.
static uint32_t state_of(const app_t *app, nck_tick_state_t state) {
    nck_command_t asked;
    nck_asked(app->nck, &asked);
    const int nothing = asked.feed_ppm == 0 || asked.rapid_ppm == 0;
    const int rests = state == NCK_TICK_STARVED || (state == NCK_TICK_IDLE && !app->prep.done);
    return nothing && rests ? NCK_TICK_HOLD : state;
}

static void count_lateness(app_t *app) {
    const int idle_early = app->tick.state == NCK_TICK_IDLE && !app->prep.done;
    app->tick.starved += app->tick.state == NCK_TICK_STARVED;
    app->tick.underruns += app->tick.state == NCK_TICK_STARVED || idle_early;
}

// Hand the next setpoint over, unless the guard says that the drives must not have it.
static void take_setpoint(app_t *app) {
    nck_pose_t pose;
    nck_axes_t axes;
    app->tick.state = state_of(app, nck_tick(app->nck, &pose, &axes));
    app->tick.idle = (uint32_t)nck_is_idle(app->nck);
    if (!app_guard_lets(app, &axes)) {
        hal_make_safe();
        app->supervisor.frozen = 1;
        app->tick.beyond = 1;
        return;
    }
    const int still = pose.v == 0.0 && memcmp(&axes, &app->tick.axes, sizeof axes) == 0;
    app->tick.resting = still ? app->tick.resting + 1 : 0;
    app_output_follow(app, pose.spindle_rpm, pose.kind == NCK_SEG_TAP);
    app->tick.pose = pose;
    app->tick.axes = axes;
    count_lateness(app);
}

static void do_other_work(app_t *app) {
    os_spend(app->job.tick_units);
    if (app->supervisor.work_ticks == 0) return;
    app->supervisor.work_ticks--;
    app_work(app->supervisor.work_units);
}

// Nobody else could end a run whose supervisor does not run any more.
static void watch_supervisor(app_t *app) {
    if (os_time() - app->supervisor.seen < SUPERVISOR_LATE) return;
    if (app->supervisor.goal == APP_IDLE) app->supervisor.goal = APP_FAULT_TASK;
    nck_abort(app->nck);
    if (app->tick.resting < APP_REST_TICKS && !app->supervisor.frozen) return;
    hal_make_safe();
    app_enter(app, app->fault_stack ? (uint32_t)APP_FAULT_STACK : app->supervisor.goal);
    os_stop();
}

// After an overrun a period is given away: the tasks get time to act on it, and the motion is
// stretched in time instead of jumping.
static int is_given_away(app_t *app) {
    const uint32_t overruns = os_overruns();
    if (overruns == app->tick.overruns) return 0;
    app->tick.overruns = overruns;
    app->tick.given_away++;
    return 1;
}

static void give_period(app_t *app) {
    const uint64_t begin = os_clock();
    watch_supervisor(app);
    if (!app->supervisor.started) return;
    if (!app->supervisor.frozen) take_setpoint(app);
    count_setpoint(app);
    if (app->job.trace) write_row(app);
    do_other_work(app);
    app_suffer(app, 0);
    const uint64_t units = os_clock() - begin;
    if (os_clock() > begin && units > app->tick.most_units) app->tick.most_units = units;
}

// Here alone the watchdog is fed: if a tick hangs, or none comes any more, the board goes to the
// safe state by itself. A supervisor that hangs is the tick's to see.
void app_tick(void *user) {
    app_t *const app = user;
    if (!is_given_away(app)) give_period(app);
    hal_watchdog_feed();
}
