// SPDX-License-Identifier: MIT
// Step and direction: planned once a period, added up in the fast interrupt.
#include "pulse/pulse.h"

#include <string.h> // memset

#include "nck/base/fence.h" // nck_fence_load nck_fence_store

#define PARTS 2147483648.0 // of a step

enum { HALF_SHIFT = 30, STEP_SHIFT = 31 };

static const double parts_most = 4.0e18; // a position fits into 64 bits

// ---- once a period

static int64_t parts_of(const pulse_motor_t *motor, const nck_axes_t *axes) {
    return (int64_t)((double)axes->joint_nm[motor->joint] * motor->scale);
}

// What of the backlash is made up for, a little in every period.
static void take_up(pulse_motor_t *motor, int64_t way) {
    if (way == 0 || motor->backlash == 0) return;
    const int64_t goal = way > 0 ? motor->backlash : 0;
    const int64_t left = goal - motor->slack;
    const int64_t most = motor->slack_most;
    motor->slack += left > most ? most : left < -most ? -most : left;
}

// Evenly in so many interrupts; the rest stays. Returns 0 if it is too fast.
static int plan(pulse_motor_t *motor, uint32_t *by_out, int64_t way, uint32_t interrupts) {
    const int64_t most = (int64_t)1 << HALF_SHIFT;
    int64_t by = way / (int64_t)interrupts;
    const int fits = by <= most && by >= -most;
    if (!fits) by = by > 0 ? most : -most;
    *by_out = (uint32_t)by;
    motor->at += by * (int64_t)interrupts;
    return fits;
}

static int plan_motor(pulse_t *self, uint32_t m, const nck_axes_t *axes, int told) {
    pulse_motor_t *const motor = &self->motor[m];
    const int64_t to = parts_of(motor, axes);
    if (told) motor->zero += motor->seen - to;
    else take_up(motor, to - motor->seen);
    motor->seen = to;
    if (motor->held) motor->zero = motor->at - to - motor->slack;
    const int64_t way = to + motor->zero + motor->slack - motor->at;
    const int64_t least = (int64_t)self->interrupts; // what is less is for later
    const int down = way <= -least || (way < least && motor->down);
    const int turns = down != motor->down;
    motor->down = (uint8_t)down;
    if (turns) self->turned |= 1u << m;
    if (down != motor->reversed) self->next_directions &= ~(1u << m);
    else self->next_directions |= 1u << m;
    return plan(motor, &self->next[m], way, self->interrupts - (turns ? self->setup : 0u));
}

int pulse_period(pulse_t *self, const nck_axes_t *axes, uint32_t places) {
    const int told = places != self->places;
    int fits = 1;
    if (nck_fence_load(&self->ready)) return 1; // the last one was not taken: its way is not lost
    self->turned = 0;
    for (uint32_t m = 0; m < self->motors; m++) fits &= plan_motor(self, m, axes, told);
    self->places = places;
    if (!fits) self->fast = 1;
    nck_fence_store(&self->ready, 1);
    return fits;
}

void pulse_hold(pulse_t *self, uint32_t motor, uint32_t on) {
    self->motor[motor].held = on != 0;
}

// ---- in the fast interrupt

static void stand(pulse_t *self) {
    for (uint32_t m = 0; m < self->motors; m++) self->lane[m].by = 0;
    self->until = 0;
    self->left = self->interrupts;
    nck_fence_store(&self->late, self->late + 1);
}

// A period begins. A motor that turns round sets off when its direction line has stood.
static void begin(pulse_t *self) {
    if (!nck_fence_load(&self->ready)) {
        stand(self);
        return;
    }
    for (uint32_t m = 0; m < self->motors; m++) {
        const int turns = (self->turned >> m & 1u) != 0;
        self->lane[m].by = turns && self->setup > 0 ? 0 : self->next[m];
    }
    self->directions = self->next_directions;
    self->left = self->interrupts;
    self->until = self->turned != 0 && self->setup > 0 ? self->setup : 0;
    if (self->until == 0) nck_fence_store(&self->ready, 0);
}

static void set_off(pulse_t *self) {
    self->until--;
    if (self->until > 0) return;
    for (uint32_t m = 0; m < self->motors; m++) self->lane[m].by = self->next[m];
    nck_fence_store(&self->ready, 0);
}

uint32_t pulse_interrupt(pulse_t *self) {
    uint32_t high = 0;
    if (self->left == 0) begin(self);
    else if (self->until > 0) set_off(self);
    self->left--;
    for (uint32_t m = 0; m < self->motors; m++) {
        pulse_lane_t *const lane = &self->lane[m];
        const uint32_t was = lane->phase, is = was + lane->by;
        lane->phase = is;
        high |= ((is ^ was) >> STEP_SHIFT) << m;
    }
    return high;
}

// ---- settings

static uint32_t interrupts_of(const pulse_set_t *set, double time) {
    const double count = time / set->period_s * set->interrupts;
    const uint32_t whole = (uint32_t)count;
    return whole + ((double)whole < count ? 1u : 0u);
}

static int is_good(const pulse_set_t *set) {
    if (set->motors > PULSE_MOTORS || set->interrupts == 0 || !(set->period_s > 0.0)) return 0;
    if (!(set->setup_s >= 0.0 && set->setup_s < set->period_s)) return 0;
    if (set->pulse_s * set->interrupts > set->period_s) return 0;
    return interrupts_of(set, set->setup_s) < set->interrupts;
}

static int begin_motor(pulse_motor_t *motor, const pulse_set_t *set, const pulse_motor_set_t *is) {
    const double parts = is->steps * PARTS;
    const double slow = is->backlash_speed * set->period_s;
    if (!(is->steps > 0.0 && is->counts > 0.0) || is->joint >= NCK_AXIS_MAX) return 0;
    if (!(is->backlash >= 0.0 && is->backlash * parts < parts_most)) return 0;
    if (is->backlash > 0.0 && !(slow > 0.0 && slow * parts < parts_most)) return 0;
    motor->scale = parts / is->counts;
    motor->backlash = (int64_t)(is->backlash * parts);
    motor->slack_most = is->backlash > 0.0 ? (int64_t)(slow * parts) : 0;
    motor->joint = is->joint;
    motor->reversed = is->reversed != 0;
    return 1;
}

int pulse_init(pulse_t *self, const pulse_set_t *set, const nck_axes_t *axes, uint32_t places) {
    memset(self, 0, sizeof *self);
    if (!is_good(set)) return 0;
    self->motors = set->motors;
    self->interrupts = set->interrupts;
    self->setup = interrupts_of(set, set->setup_s);
    self->places = places;
    for (uint32_t m = 0; m < self->motors; m++) {
        pulse_motor_t *const motor = &self->motor[m];
        if (!begin_motor(motor, set, &set->motor[m])) return 0;
        motor->seen = motor->at = parts_of(motor, axes);
        self->lane[m].phase = (uint32_t)(uint64_t)motor->at + (1u << HALF_SHIFT);
        if (!motor->reversed) self->directions |= 1u << m;
    }
    self->next_directions = self->directions;
    return 1;
}

uint32_t pulse_duty(double rpm, double most_rpm, uint32_t top) {
    const double size = rpm < 0.0 ? -rpm : rpm;
    if (!(size < most_rpm)) return top;
    return (uint32_t)(size / most_rpm * (double)top + 0.5);
}
