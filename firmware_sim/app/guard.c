// SPDX-License-Identifier: MIT
// The guard of the travel.
#include "app/guard.h"

void app_guard_init(app_t *app) {
    for (uint32_t k = 0; k < nck_joint_count(app->nck); k++) {
        const uint32_t driven = nck_joint_axis(app->nck, k);
        const nck_axis_t *const axis = &nck_machine_of(app->nck)->axis[driven];
        app->travel[k].least = axis->min_nm;
        app->travel[k].most = axis->max_nm;
    }
}

int app_guard_set(app_t *app, int64_t joint, const app_range_t *travel) {
    if (joint < 0 || joint >= (int64_t)nck_joint_count(app->nck)) return 0;
    if (travel->least > travel->most) return 0;
    const uint32_t before = os_critical_enter();
    app->travel[joint] = *travel;
    os_critical_exit(before);
    return 1;
}

void app_guard_tell(app_t *app) {
    for (uint32_t k = 0; k < nck_joint_count(app->nck); k++) {
        if (!app->travel[k].untold) continue;
        const uint32_t before = os_critical_enter();
        const app_range_t travel = app->travel[k];
        app->travel[k].untold = 0;
        os_critical_exit(before);
        (void)nck_set_travel(app->nck, nck_joint_axis(app->nck, k), travel.least, travel.most);
    }
}

int app_guard_lets(const app_t *app, const nck_axes_t *next) {
    for (uint32_t k = 0; k < nck_joint_count(app->nck); k++) {
        const app_range_t *const travel = &app->travel[k];
        const int64_t at = next->joint_nm[k];
        const int moves = at != app->tick.axes.joint_nm[k];
        if (moves && (at < travel->least || at > travel->most)) return 0;
    }
    return 1;
}
