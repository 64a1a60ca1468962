// SPDX-License-Identifier: MIT
// A job: the machine, the operator's commands at given ticks and the conditions of one run, read
// from text, a statement a line:
//
//     # a comment
//     set axis.v_max 0 0 0x1.f4p+8     a number of the machine: name, row, column, value
//     prep_steps 4                     a condition of the run
//     at 250 override 50 100           a command, behind the setpoint of tick 250
//
// Numbers are decimal integers, or reals as C's %a writes them: exact, and read without a library.
#ifndef APP_JOB_H
#define APP_JOB_H

#include <stddef.h> // size_t

#include "nck/nck.h" // nck_machine_t

// Bounds of a job.
enum {
    APP_JOB_LINE_MAX = 120,   // bytes of a line
    APP_JOB_COMMANDS = 64     // commands of a job
};

// What reading a job returns.
typedef enum app_job_status {
    APP_JOB_OK = 0,
    APP_JOB_E_WORD = -1,    // an unknown statement, setting or command
    APP_JOB_E_NUMBER = -2,  // not a number, or outside of its range
    APP_JOB_E_COUNT = -3,   // too few or too many words, or too many commands
    APP_JOB_E_ORDER = -4,   // commands must come in the order of their ticks
    APP_JOB_E_LENGTH = -5   // a line longer than APP_JOB_LINE_MAX
} app_job_status_t;

// What the operator does, and what a test does to the controller.
typedef enum app_command_kind {
    APP_HOLD = 0,         // feed hold
    APP_RESUME = 1,       // cycle start: after a hold, a wait or a single block
    APP_OVERRIDE = 2,     // feed percent, rapid percent
    APP_SINGLE_BLOCK = 3, // 1 on, 0 off
    APP_ABORT = 4,        // brake on the path and drop the rest
    APP_ESTOP = 5,        // no further setpoint, drives off
    APP_TRAVEL = 6,       // joint, lowest, highest [nm]: the guard's travel from now on
    APP_FEEDER_PAUSE = 7, // the program's source is silent for so many ticks
    APP_TICK_WORK = 8,    // units of other work in the tick interrupt, for so many ticks
    APP_STACK_WORK = 9,   // the task of this priority overruns its stack
    APP_TASK_WORK = 10,   // priority (0: the tick), units: it keeps the processor
    APP_MASKED_WORK = 11, // priority, units: it keeps the processor, and interrupts out
    APP_TRAP = 12,        // priority: it executes an instruction that does not exist
    APP_COMMAND_KINDS = 13
} app_command_kind_t;

// One command of the job.
typedef struct app_command {
    uint32_t tick;       // takes effect behind the setpoint of this tick; 0: before the first
    uint32_t kind;       // app_command_kind_t
    int64_t argument[3];
} app_command_t;

// What a run is to do.
typedef struct app_job {
    nck_machine_t machine;
    uint32_t prep_steps;     // prep steps in a tick at most; 0: as many as there is time for
    uint32_t prep_units;     // what a prep step lasts where time is virtual [units of os_clock]
    uint32_t tick_units;     // what a tick lasts there
    uint32_t feeder_units;   // what reading a chunk of text lasts there
    uint32_t wait_ticks;     // M0, M1, M6: the operator resumes after so many ticks; 0: never
    uint32_t starve_ticks;   // at rest in the middle of the path for so long is a fault; 0: never
    uint32_t max_ticks;      // the run ends then in any case; 0: never
    uint32_t trace;          // 1: write a row a tick
    uint32_t command_count;
    app_command_t command[APP_JOB_COMMANDS];
} app_job_t;

// A job that does nothing: a machine of zeros, no command, a wait resumed after one tick.
// Cost: constant. Context: any.
void app_job_init(app_job_t *job);

// Take one line of n bytes, without its line feed.
// Returns an app_job_status_t. Cost: linear in n and in the settings there are. Context: any.
app_job_status_t app_job_line(app_job_t *job, const char *line, size_t n);

#endif
