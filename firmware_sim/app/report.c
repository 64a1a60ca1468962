// SPDX-License-Identifier: MIT
// The report of a run: lines of words, the first of which says what the others are.
#include "app/report.h"

#include <string.h> // memcpy strlen

#include "hal/hal.h" // hal_write

static const char *const state_names[APP_STATES] = {
    "idle", "run", "stopping", "hold", "wait", "starved",
    "done", "aborted", "program_error", "soft_limit", "estop",
    "fault_overrun", "fault_stack", "fault_starved", "fault_task", "fault_machine",
};

static void put(const char *text) { hal_write(HAL_REPORT, text, strlen(text)); }

static void put_name(const char *name) {
    put("\n");
    put(name);
}

static void put_count(uint64_t value) {
    char text[24];
    size_t k = sizeof text;
    do {
        k--;
        text[k] = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    put(" ");
    hal_write(HAL_REPORT, text + k, sizeof text - k);
}

static void put_integer(int64_t value) {
    if (value >= 0) {
        put_count((uint64_t)value);
        return;
    }
    put(" -");
    char text[24];
    size_t k = sizeof text;
    uint64_t rest = 0u - (uint64_t)value;
    for (; rest > 0; rest /= 10) {
        k--;
        text[k] = (char)('0' + rest % 10);
    }
    hal_write(HAL_REPORT, text + k, sizeof text - k);
}

// Sixteen hexadecimal digits.
static void put_bits(uint64_t value) {
    static const char digits[] = "0123456789abcdef";
    char text[17] = " ";
    for (int k = 16; k > 0; k--) {
        text[k] = digits[value & 15u];
        value >>= 4;
    }
    hal_write(HAL_REPORT, text, sizeof text);
}

static void put_real(double value) {
    uint64_t bits = 0;
    memcpy(&bits, &value, sizeof bits);
    put_bits(bits);
}

static void report_counts(const app_t *app) {
    const struct {
        const char *name;
        uint64_t value;
    } counts[] = {
        {"ticks", app->tick.used},
        {"setpoints", app->tick.count},
        {"overruns", os_overruns()},
        {"given_away", app->tick.given_away},
        {"underruns", app->tick.underruns},
        {"starved_ticks", app->tick.starved},
        {"refused", app->supervisor.refused},
        {"prep_steps", app->prep.steps},
        {"tick_most_units", app->tick.most_units},
        {"tick_units", os_interrupt_units()},
        {"clock_units", os_clock()},
        {"clock_hz", hal_clock_hz()},
        {"axis_max", NCK_AXIS_MAX},
        {"window", NCK_WINDOW},
        {"nck_bytes", sizeof app->nck},
        {"app_bytes", sizeof *app},
    };
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
        put_name(counts[k].name);
        put_count(counts[k].value);
    }
}

// Of every task: name, priority, cycle, units it ran, switches, bytes of stack never used, fault.
static void report_tasks(const app_t *app) {
    for (int k = 0; k < APP_TASKS; k++) {
        os_task_report_t found;
        size_t left = 0;
        const app_task_t *const task = &app->task[k];
        if (os_task_report(task->priority, &found) != OS_OK) continue;
        (void)os_stack_left(task->priority, &left);
        put_name("task ");
        put(found.name);
        put_count(task->priority);
        put_count(task->cycle);
        put_count(found.run_units);
        put_count(found.switches);
        put_count(left);
        put_count((uint64_t)found.fault);
    }
}

static void report_program(const app_t *app) {
    for (uint32_t k = 0; k < app->prep.diagnostic_count; k++) {
        const nck_diagnostic_t *const found = &app->prep.diagnostic[k];
        put_name("diagnostic");
        put_integer(found->code);
        put_count(found->line);
        put_count(found->column);
        put_integer(found->letter);
        put_real(found->value);
        put_real(found->limit);
    }
    put_name("error");
    put_integer(app->prep.error);
}

static void report_states(const app_t *app) {
    put_name("names");
    for (int k = 0; k < APP_STATES; k++) {
        put(" ");
        put(state_names[k]);
    }
    for (uint32_t k = 0; k < app->supervisor.event_count; k++) {
        put_name("event");
        put_count(app->supervisor.event[k].tick);
        put_count(app->supervisor.event[k].state);
    }
}

void app_report(const app_t *app) {
    put("state ");
    put(state_names[app->supervisor.state]);
    put_name("hash");
    put_bits(app->tick.hash);
    put_name("joints");
    for (uint32_t k = 0; k < nck_joint_count(app->nck); k++) {
        put_integer(app->tick.axes.joint_nm[k]);
    }
    put_name("line");
    put_count(app->tick.pose.line);
    report_counts(app);
    report_tasks(app);
    report_program(app);
    report_states(app);
    put("\n");
}

void app_report_job(uint32_t line, app_job_status_t status) {
    put("job_error");
    put_count(line);
    put_integer(status);
    put("\n");
}
