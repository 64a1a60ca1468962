// SPDX-License-Identifier: MIT
// Three drives that follow two periods late and turn round now and then. Exit status: 0 if none of
// them is a fault and all are where the setpoints lead.
#include "drive/drive.h"
#include "mark.h"

enum { DRIVES = 3, PERIODS = 400, TURN = 50, INCREMENTS = 10000 };

static drive_t drive;

int main(void) {
    static const int fastest[DRIVES] = {201000, 150000, 7};
    drive_set_t set = {.period_s = 1e-3, .motors = DRIVES};
    drive_target_t target[DRIVES], late[DRIVES];
    int32_t actual[DRIVES] = {0};
    nck_axes_t axes = {{0}};
    for (uint8_t m = 0; m < DRIVES; m++) {
        set.motor[m] = (drive_motor_set_t){
            .counts = 1e6, .increments = INCREMENTS, .inertia = 0.02, .viscous = 0.1,
            .friction = 5.0, .torque_most = 1000.0, .follow_most = 0.01, .periods = 3, .lag = 1,
            .joint = m};
    }
    if (!drive_init(&drive, &set, &axes, 1, actual)) return 1;
    for (uint32_t m = 0; m < DRIVES; m++) late[m].position = 0;
    for (int n = 0; n < PERIODS; n++) {
        const int way = n % TURN == 0 ? 0 : n / TURN % 2 == 0 ? 1 : -1;
        for (int m = 0; m < DRIVES; m++) axes.joint_nm[m] += way * fastest[m];
        mark_tick_begin();
        drive_period(&drive, &axes, 1, target);
        mark_tick_end();
        for (uint32_t m = 0; m < DRIVES; m++) actual[m] = late[m].position;
        mark_prep_begin();
        const uint32_t faults = drive_follow(&drive, actual);
        mark_prep_end();
        if (faults != 0) return 1;
        for (uint32_t m = 0; m < DRIVES; m++) late[m] = target[m];
    }
    return actual[0] < 2 * INCREMENTS && actual[0] > -2 * INCREMENTS ? 0 : 2;
}
