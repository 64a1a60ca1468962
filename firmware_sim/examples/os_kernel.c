// SPDX-License-Identifier: MIT
// libnck on the kernel in ../os: a feeder task brings text, a prep task of lower priority plans,
// the tick hook is the tick context. What ../app does on top: commands, states, faults.
//
//     os_kernel PROGRAM SETPOINTS      files, where a machine has a serial line and drives
//
// SETPOINTS gets nck_axes_t as it lies in memory, one for every period.
#include "board/board.h"
#include "nck/nck_memory.h" // nck_t
#include "os/os.h"

enum { CORE_HZ = 25000000, LOG_PERIODS = 200000, CHUNKS = 2, CHUNK_BYTES = 512 };
enum { STACK_BYTES = 4096 };

// The feeder waits for its source nearly always; prep takes all the time that is left.
enum { FEEDER = 2, PREP = 4 };

typedef struct chunk {
    size_t first, count; // count 0: the end of the program
    char text[CHUNK_BYTES];
} chunk_t;

static nck_machine_t machine;
static nck_t nck;
static int program;
static os_stack_t feeder_stack[OS_STACK_WORDS(STACK_BYTES)];
static os_stack_t prep_stack[OS_STACK_WORDS(STACK_BYTES)];

// Chunks travel full from the feeder to prep, and empty back.
static chunk_t chunks[CHUNKS];
static void *filled_slots[CHUNKS], *empty_slots[CHUNKS];
static os_queue_t filled, empty;

// In place of the drives: a log, because a file would hold up the interrupt.
static nck_axes_t drives[LOG_PERIODS] __attribute__((section(".bulk")));

static volatile uint32_t is_prefilled; // prep writes: motion may begin
static volatile uint32_t periods;      // the tick writes
static volatile uint32_t is_idle;      // the tick writes, prep clears
static volatile uint32_t found;        // os_fault_t; the kernel's fault hook writes

static void tick(void *user) {
    nck_pose_t pose;
    (void)user;
    if (!is_prefilled || periods == LOG_PERIODS) return;
    is_idle = nck_is_idle(&nck) != 0;
    if (is_idle) return;
    if (nck_tick(&nck, &pose, &drives[periods]) == NCK_TICK_WAIT) nck_resume(&nck);
    periods = periods + 1;
}

static void fault(void *user, os_fault_t kind, uint32_t priority) {
    (void)user;
    (void)priority;
    found = kind;
    os_stop();
}

static void feed(void *user) {
    void *message = NULL;
    (void)user;
    while (os_queue_pend(&empty, OS_FOREVER, &message) == OS_OK) {
        chunk_t *const chunk = message;
        chunk->first = 0;
        chunk->count = board_read(program, chunk->text, sizeof chunk->text);
        (void)os_queue_post(&filled, chunk); // as many slots as chunks: never full
        if (chunk->count == 0) return;
    }
}

// Hand over what the kernel has room for. Returns the chunk if text is left in it, else NULL.
static chunk_t *push(chunk_t *chunk) {
    size_t used = 0;
    if (chunk->count == 0) {
        nck_end(&nck);
        return NULL;
    }
    (void)nck_push(&nck, chunk->text + chunk->first, chunk->count - chunk->first, &used);
    chunk->first += used;
    if (chunk->first < chunk->count) return chunk;
    (void)os_queue_post(&empty, chunk);
    return NULL;
}

static void prepare(void *user) {
    chunk_t *chunk = NULL;
    void *message = NULL;
    (void)user;
    for (;;) {
        const nck_status_t status = nck_prep(&nck);
        if (status == NCK_EMPTY) {
            if (!chunk && os_queue_pend(&filled, OS_FOREVER, &message) == OS_OK) chunk = message;
            if (chunk) chunk = push(chunk);
        } else if (status == NCK_FULL) {
            is_prefilled = 1;
            (void)os_delay(1);
        } else if (status == NCK_DONE) {
            break;
        }
    }
    is_prefilled = 1;
    is_idle = 0;
    while (!is_idle && periods < LOG_PERIODS) (void)os_delay(1);
    os_stop();
}

static os_status_t run(void) {
    const os_hooks_t hooks = {.tick = tick, .fault = fault};
    os_init(&hooks);
    (void)os_queue_create(&filled, filled_slots, CHUNKS);
    (void)os_queue_create(&empty, empty_slots, CHUNKS);
    for (int k = 0; k < CHUNKS; k++) (void)os_queue_post(&empty, &chunks[k]);
    os_status_t status = os_task_create(FEEDER, "feeder", feed, NULL, feeder_stack,
                                        sizeof feeder_stack / sizeof feeder_stack[0]);
    if (status != OS_OK) return status;
    status = os_task_create(PREP, "prep", prepare, NULL, prep_stack,
                            sizeof prep_stack / sizeof prep_stack[0]);
    if (status != OS_OK) return status;
    return os_start((uint32_t)(machine.period_s * (double)CORE_HZ + 0.5));
}

int main(void) {
    char name[256];
    if (board_argument(1, name, sizeof name) < 0) return 2;
    program = board_open(name, BOARD_READ);
    if (board_argument(2, name, sizeof name) < 0) return 2;
    const int log = board_open(name, BOARD_WRITE);
    if (program < 0 || log < 0) return 2;
    if (nck_selftest() != NCK_SELFTEST) return 2; // arithmetic is not as it has to be
    nck_machine_default(&machine); // then change what differs
    machine.slope = NCK_SLOPE_LINEAR; // doubles are software on an M4F: jerk would starve there
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 2;
    if (run() != OS_OK) return 3;
    const size_t size = periods * sizeof drives[0];
    const int is_whole = board_write(log, drives, size) == size && periods < LOG_PERIODS;
    if (found == OS_FAULT_OVERRUN) return BOARD_EXIT_OVERRUN;
    return is_whole && found == OS_FAULT_NONE ? 0 : 1;
}
