// SPDX-License-Identifier: MIT
// What the program switches. Tools are the operator's: M6 waits for him.
#include "app/output.h"

#include "app/app.h" // app_t
#include "hal/hal.h" // hal_switch

static void set_spindle(app_t *app) {
    hal_switch(HAL_SPINDLE, app->spindle.turns * app->spindle.rpm);
}

static void turn(app_t *app, int32_t turns) {
    app->spindle.turns = turns;
    set_spindle(app);
}

static void execute(app_t *app, int code) {
    switch (code) {
    case 3: turn(app, 1); break;
    case 4: turn(app, -1); break;
    case 5: turn(app, 0); break;
    case 7:
    case 8: hal_switch(HAL_COOLANT, 1); break;
    case 9: hal_switch(HAL_COOLANT, 0); break;
    default: break;
    }
}

static void set_speed(app_t *app, double rpm) {
    app->spindle.rpm = rpm < (double)INT32_MAX ? (int32_t)rpm : INT32_MAX;
    set_spindle(app);
}

void app_output(void *user, const nck_output_t *output) {
    app_t *const app = user;
    if (output->kind == NCK_OUTPUT_M) execute(app, (int)output->value);
    if (output->kind == NCK_OUTPUT_SURFACE_SPEED) app->spindle.follows = 1;
    if (output->kind != NCK_OUTPUT_SPINDLE_SPEED) return;
    app->spindle.follows = 0;
    set_speed(app, output->value);
}

void app_output_follow(void *user, double rpm, int taps) {
    app_t *const app = user;
    const int follows = app->spindle.follows || app->spindle.taps || taps;
    app->spindle.taps = (uint32_t)taps;
    if (follows && (int32_t)rpm != app->spindle.rpm) set_speed(app, rpm);
}
