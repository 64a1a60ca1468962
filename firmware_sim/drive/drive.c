// SPDX-License-Identifier: MIT
// Places, speeds and torques of drives from setpoints.
#include "drive/drive.h"

#include <string.h> // memmove memset

static const double increments_most = 1e15; // a place is exact to less than one
static const double velocity_most = 2147483647.0;

static double clipped(double value, double most) {
    return value > most ? most : value < -most ? -most : value;
}

// To the nearest, modulo 2³².
static int32_t wrapped(double value) {
    const int64_t whole = (int64_t)(value < 0.0 ? value - 0.5 : value + 0.5);
    const uint32_t low = (uint32_t)(uint64_t)whole;
    return low <= INT32_MAX ? (int32_t)low : (int32_t)(low - 1u - INT32_MAX) + INT32_MIN;
}

static int32_t rounded(double value, double most) {
    const double kept = clipped(value, most);
    return (int32_t)(kept < 0.0 ? kept - 0.5 : kept + 0.5);
}

static int are_torques_good(const drive_motor_set_t *set) {
    return set->inertia >= 0.0 && set->viscous >= 0.0 && set->friction >= 0.0
           && set->torque_most >= 0.0 && set->torque_most <= INT16_MAX;
}

static int is_good(const drive_motor_set_t *set) {
    const double size = set->increments < 0.0 ? -set->increments : set->increments;
    return set->counts >= 1.0 && size > 0.0 && size < 1e9 && are_torques_good(set)
           && set->follow_most > 0.0 && set->periods > 0 && set->lag <= DRIVE_LAG_MOST
           && set->joint < NCK_AXIS_MAX;
}

int drive_init(drive_t *self, const drive_set_t *set, const nck_axes_t *axes, uint32_t places,
               const int32_t *actual) {
    memset(self, 0, sizeof *self);
    if (!(set->period_s > 0.0) || set->motors > DRIVE_MOTORS) return 0;
    self->period_s = set->period_s;
    self->motors = set->motors;
    self->places = places;
    for (uint32_t m = 0; m < set->motors; m++) {
        drive_motor_t *const motor = &self->motor[m];
        motor->set = set->motor[m];
        if (!is_good(&motor->set)) return 0;
        motor->scale = motor->set.increments / motor->set.counts;
        motor->zero = actual[m] - (double)axes->joint_nm[motor->set.joint] * motor->scale;
        for (uint32_t k = 0; k < DRIVE_PAST; k++) motor->past[k] = actual[m];
        for (uint32_t k = 0; k <= DRIVE_LAG_MOST; k++) motor->asked[k] = actual[m];
    }
    return 1;
}

// What the mass, the oil and the friction take, where the program is.
static double torque_of(const drive_motor_set_t *set, double speed, double acceleration) {
    const double sign = speed > 0.0 ? 1.0 : speed < 0.0 ? -1.0 : 0.0;
    const double torque = set->inertia * acceleration + set->viscous * speed
                          + set->friction * sign;
    return set->increments < 0.0 ? -torque : torque;
}

static void give(drive_motor_t *motor, double period_s, drive_target_t *out) {
    const double *const past = motor->past;
    const double unit = motor->set.increments; // its sign is the drive's
    const double velocity = (past[0] - past[2]) / (2.0 * period_s);
    const double change = (past[0] - 2.0 * past[1] + past[2]) / (period_s * period_s);
    out->position = wrapped(past[1]);
    out->velocity = rounded(velocity, velocity_most);
    out->torque = (int16_t)rounded(torque_of(&motor->set, velocity / unit, change / unit),
                                   motor->set.torque_most);
    memmove(motor->asked + 1, motor->asked, DRIVE_LAG_MOST * sizeof *motor->asked);
    motor->asked[0] = out->position;
}

void drive_period(drive_t *self, const nck_axes_t *axes, uint32_t places,
                  drive_target_t *target_out) {
    const int told = places != self->places;
    self->places = places;
    for (uint32_t m = 0; m < self->motors; m++) {
        drive_motor_t *const motor = &self->motor[m];
        const double at = (double)axes->joint_nm[motor->set.joint] * motor->scale;
        if (told) motor->zero = motor->past[0] - at;
        memmove(motor->past + 1, motor->past, (DRIVE_PAST - 1) * sizeof *motor->past);
        motor->past[0] = clipped(at + motor->zero, increments_most);
        give(motor, self->period_s, &target_out[m]);
    }
}

uint32_t drive_follow(drive_t *self, const int32_t *actual) {
    for (uint32_t m = 0; m < self->motors; m++) {
        drive_motor_t *const motor = &self->motor[m];
        const uint32_t apart = (uint32_t)motor->asked[motor->set.lag] - (uint32_t)actual[m];
        motor->error = wrapped((double)apart);
        const double off = motor->error / motor->set.increments;
        const double most = motor->set.follow_most;
        motor->beyond = off > most || off < -most ? motor->beyond + 1 : 0;
        if (motor->beyond >= motor->set.periods) self->faults |= 1u << m;
    }
    return self->faults;
}
