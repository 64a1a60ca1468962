// SPDX-License-Identifier: MIT
// What a test does to the controller: faults on purpose, in a task or in the tick.
#include "app/app.h"

// On a board time passes by itself, on the host by os_spend. The clock may step back where a tick
// was lost.
void app_work(uint32_t units) {
    uint64_t last = os_clock(), spent = 0;
    os_spend(units);
    while (spent < units) {
        const uint64_t now = os_clock();
        if (now > last) spent += now - last;
        last = now;
    }
}

static void leave_stack(void) {
    volatile uint8_t frame[sizeof((app_task_t *)0)->stack - OS_STACK_GUARD / 2];
    for (size_t k = 0; k < sizeof frame; k++) frame[k] = (uint8_t)k;
}

static void work_alone(uint32_t units) {
    const uint32_t before = os_critical_enter();
    app_work(units);
    os_critical_exit(before);
}

void app_suffer(app_t *app, uint32_t priority) {
    const uint32_t harm = app->supervisor.harm;
    if (harm == 0 || app->supervisor.harmed != priority) return;
    app->supervisor.harm = 0;
    switch (harm) {
    case APP_STACK_WORK: leave_stack(); break;
    case APP_TASK_WORK: app_work(app->supervisor.harm_units); break;
    case APP_MASKED_WORK: work_alone(app->supervisor.harm_units); break;
    default: __builtin_trap();
    }
}
