// SPDX-License-Identifier: MIT
// The guard of the travel.
#include "app/guard.h"

// How long planned motion goes on after a hold is asked for, before it begins to brake [ticks].
enum { HOLD_TICKS = 40 };

void app_guard_init(app_t *app) {
    for (uint32_t k = 0; k < nck_joint_count(&app->nck); k++) {
        const uint32_t driven = nck_joint_axis(&app->nck, k);
        const nck_axis_t *const axis = &nck_machine_of(&app->nck)->axis[driven];
        app->travel[k].least = axis->min_nm;
        app->travel[k].most = axis->max_nm;
    }
}

int app_guard_set(app_t *app, int64_t joint, const app_range_t *travel) {
    if (joint < 0 || joint >= (int64_t)nck_joint_count(&app->nck)) return 0;
    if (travel->least > travel->most) return 0;
    const uint32_t before = os_critical_enter();
    app->travel[joint] = *travel;
    os_critical_exit(before);
    return 1;
}

// The weakest of the path's and the axes' limits holds on every path.
static double weakest(const nck_machine_t *machine, int jerk) {
    double limit = jerk ? machine->path.j_max : machine->path.a_max;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double of_axis = jerk ? machine->axis[x].j_max : machine->axis[x].a_max;
        if (machine->axis[x].present && of_axis < limit) limit = of_axis;
    }
    return limit;
}

// Half of the time that braking from v takes, v/A + A/J, is the time that its distance takes at v;
// this much again for jerk that must first undo an acceleration of A.
static double seconds_to_stop(const nck_machine_t *machine, double v) {
    const double a = weakest(machine, 0);
    const double to_full = machine->slope == NCK_SLOPE_LINEAR ? 0.0 : a / weakest(machine, 1);
    return (double)HOLD_TICKS * machine->period_s + (v / a + to_full) / 2.0 + to_full;
}

app_guard_t app_guard_check(const app_t *app, const nck_pose_t *pose, const nck_axes_t *next) {
    app_guard_t found = APP_GUARD_FAR;
    const nck_machine_t *const machine = nck_machine_of(&app->nck);
    const double periods = seconds_to_stop(machine, pose->v) / machine->period_s;
    for (uint32_t k = 0; k < nck_joint_count(&app->nck); k++) {
        const app_range_t *const travel = &app->travel[k];
        const int64_t at = next->joint_nm[k];
        const int64_t step = at - app->tick.axes.joint_nm[k];
        if (step != 0 && (at < travel->least || at > travel->most)) return APP_GUARD_BEYOND;
        const double end = (double)at + (double)step * periods;
        const int inside = end >= (double)travel->least && end <= (double)travel->most;
        if (travel->narrowed && !inside) found = APP_GUARD_NEAR;
    }
    return pose->v > 0.0 ? found : APP_GUARD_FAR;
}
