// SPDX-License-Identifier: MIT
// The firmware of a controller: a feeder task, a prep task, the tick and a supervisor task around
// one nck_t. The same source on every board; what differs is behind os.h and hal.h.
#ifndef APP_H
#define APP_H

#include "app/job.h"     // app_job_t
#include "app/outcome.h" // app_row_t app_exit_t
#include "nck/nck_session.h" // nck_t
#include "os/os.h"       // os_queue_t os_stack_t

// Sizes of the app.
enum {
    APP_CHUNKS = 4,          // pieces of text between the feeder and prep
    APP_CHUNK_BYTES = 512,
    APP_STACK_BYTES = 6144,  // of every task
    APP_EVENTS = 64,         // changes of state that are kept for the report
    APP_DIAGNOSTICS = 16,    // findings in the program that are kept for the report
    APP_REST_TICKS = 16,     // without motion before rest is believed in
    APP_TASKS = 3
};

// What the operator is shown. From APP_DONE on the run is over and the setpoint stays.
typedef enum app_state {
    APP_IDLE = 0,       // planning ahead, no tick so far
    APP_RUN,            // on the path
    APP_STOPPING,       // braking on the path: a hold, an abort or a fault
    APP_HELD,           // at rest until the operator resumes
    APP_WAIT,           // M0, M1, M6: at rest until the operator resumes
    APP_STARVED,        // on the stop tail, or at rest until the next text comes
    APP_DONE,           // the whole program is executed
    APP_ABORTED,        // the operator's wish
    APP_PROGRAM_ERROR,  // everything before the error is executed
    APP_SOFT_LIMIT,     // the guard's travel would have been left
    APP_EMERGENCY,      // the operator's wish: drives off
    APP_FAULT_OVERRUN,  // a tick took longer than its period
    APP_FAULT_STACK,    // a task left its stack
    APP_FAULT_STARVED,  // no text for too long
    APP_FAULT_TASK,     // the supervisor did not run when it had to
    APP_FAULT_MACHINE,  // the machine's numbers make no sense
    APP_STATES
} app_state_t;

// When a state began.
typedef struct app_event {
    uint32_t tick;
    uint32_t state; // app_state_t
} app_event_t;

// A piece of program text on its way from the feeder to prep.
typedef struct app_chunk {
    uint32_t size;               // 0: the end of the program
    uint32_t used;               // by prep
    char text[APP_CHUNK_BYTES];
} app_chunk_t;

// A joint's travel.
typedef struct app_range {
    int64_t least, most; // [nm, ndeg]
    volatile uint32_t untold; // 1: changed by the operator, and the kernel does not know it yet
} app_range_t;

// The app, below.
struct app;

// What a task is handed. There is room below its stack, so that a task that overruns it on purpose
// destroys nobody else's.
typedef struct app_task {
    struct app *app;
    uint32_t priority;
    uint32_t cycle;              // [ticks]
    os_stack_t spare[APP_STACK_BYTES / sizeof(os_stack_t)];
    os_stack_t stack[OS_STACK_WORDS(APP_STACK_BYTES)];
} app_task_t;

// The whole app: one static instance.
typedef struct app {
    nck_t *nck;
    app_job_t job;

    struct {                      // feeder ─▶ prep, and the empty ones back
        app_chunk_t chunk[APP_CHUNKS];
        os_queue_t filled, empty;
        void *filled_slots[APP_CHUNKS], *empty_slots[APP_CHUNKS];
        uint32_t pause;           // ticks that the source stays silent; the supervisor sets it
    } text;

    struct {                      // written by prep
        app_chunk_t *chunk;       // being pushed, or NULL
        uint64_t steps;           // so far
        uint32_t budget;          // steps left in this tick
        uint32_t budget_time;     // the tick it was given for
        volatile uint32_t ready;  // 1: it has had to wait for the tick: motion may begin
        volatile uint32_t done;   // 1: all is handed over
        volatile int32_t error;   // of the program, NCK_OK: none
        uint32_t diagnostic_count;
        nck_diagnostic_t diagnostic[APP_DIAGNOSTICS];
    } prep;

    struct {                      // written by the tick
        volatile uint32_t count;  // setpoints so far
        uint32_t used;            // of them not idle
        volatile uint32_t state;  // nck_tick_state_t of the last
        volatile uint32_t idle;   // 1: nck_is_idle after the last
        volatile uint32_t resting;// ticks that the setpoint has not changed at speed 0
        volatile uint32_t beyond; // 1: the guard has kept a setpoint back
        uint32_t overruns;        // seen so far
        uint32_t given_away;      // periods without a setpoint, after an overrun
        uint32_t starved;         // ticks in NCK_TICK_STARVED
        uint32_t underruns;       // ticks that prep owed a setpoint: starved, or idle too early
        uint64_t most_units;      // of one tick
        uint64_t hash;            // of the setpoints that were not idle
        nck_pose_t pose;
        nck_axes_t axes;          // what the drives have
    } tick;

    struct {                      // written by the supervisor; by the tick if it is dead
        volatile uint32_t started;// 1: the tick may take setpoints
        volatile uint32_t frozen; // 1: the setpoint stays
        volatile uint32_t seen;   // os_time of its last cycle
        volatile uint32_t work_units, work_ticks; // other work in the tick
        volatile uint32_t harm;                   // app_command_kind_t of a test, 0: none
        volatile uint32_t harmed, harm_units;     // to this priority, 0 being the tick
        uint32_t command;         // next of the job
        uint32_t refused;         // commands that this machine cannot follow
        uint32_t state;           // app_state_t
        uint32_t goal;            // app_state_t to end in, APP_IDLE: none
        uint32_t waited;          // ticks in WAIT, in this seg
        uint32_t wait_seg;
        uint32_t starved;         // ticks at rest in STARVED
        uint32_t settled;         // ticks that nothing more was to come
        uint32_t event_count;
        app_event_t event[APP_EVENTS];
    } supervisor;

    struct {                      // written by the tick: what the program wants of the spindle
        int32_t rpm;              // S
        int32_t turns;            // M3: 1, M4: -1, M5: 0
        uint32_t follows;         // 1: G96, rpm follows the position
        uint32_t taps;            // 1: the tick before was one of a tap
    } spindle;

    volatile uint32_t fault_stack; // priority + 1 of a task that left its stack; the kernel's hook
    app_range_t travel[NCK_AXIS_MAX]; // of every joint; in a critical section
    app_task_t task[APP_TASKS];
} app_t;

// Read the job, make the kernel and the tasks, run until the run is over, write the report and end.
// Returns an exit status if it does not come to a run: 0 for a machine that the report refuses.
// Context: before os_start.
int app_run(app_t *app, nck_t *nck);

// The tasks; user is the app_task_t. Context: task.
void app_feed(void *user);
void app_prepare(void *user);
void app_supervise(void *user);

// The tick; user is the app_t. Cost: bounded, as nck_tick. Context: tick.
void app_tick(void *user);

// What the hash of no setpoint is. Cost: constant. Context: any.
uint64_t app_hash_begin(void);

// Show another state and note when it came. Cost: constant. Context: supervisor; the tick once the
// supervisor is dead.
void app_enter(app_t *app, uint32_t state);

// Do to the caller, a task of this priority or the tick (0), what a test wants: a fault on purpose.
// Cost: constant, but for the harm. Context: task, tick.
void app_suffer(app_t *app, uint32_t priority);

// Keep the processor busy for so many units of os_clock. Cost: that. Context: task, tick.
void app_work(uint32_t units);

#endif
