// SPDX-License-Identifier: MIT
// Where a board's start-up code goes: one controller, one run.
#include "app/app.h" // app_run
#include "hal/hal.h" // hal_init hal_exit
#include "nck/nck_memory.h" // nck_t: reserved here

static app_t app;
static nck_t nck;

int main(void) {
    if (!hal_init()) hal_exit(APP_EXIT_STREAMS);
    hal_exit(app_run(&app, &nck));
    return 0;
}
