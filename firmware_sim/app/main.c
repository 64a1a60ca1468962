// SPDX-License-Identifier: MIT
// Where a board's start-up code goes: one controller, one run.
#include "app/app.h" // app_run
#include "hal/hal.h" // hal_init hal_exit

static app_t app;

int main(void) {
    if (!hal_init()) hal_exit(APP_EXIT_STREAMS);
    hal_exit(app_run(&app));
    return 0;
}
