// SPDX-License-Identifier: MIT
// A controller in one loop, the same source on the host and on the emulated boards: NC program in,
// hash of all setpoints out.
//
//     setpoints MACHINE PROGRAM SUMMARY [ROWS [HOLD]]
//
// MACHINE is an nck_machine_t as it stands in memory, SUMMARY becomes the numbers of `summary_t`,
// ROWS every tick's setpoints. A hold is asked for at the tick HOLD, and rests for a while. Exit
// status: 0; 1 if an argument or a file is wrong; 2 if the program has not ended after a million
// ticks.
#include <string.h> // memcpy

#include "board/board.h" // files, arguments
#include "mark.h"        // mark_*
#include "nck/nck_tools.h"     // the kernel

enum {
    NAME_MAX = 200,
    TEXT_MAX = 128,  // bytes of program in memory
    TICK_MAX = 1000000,
    RESTS = 300,     // ticks of a hold, the brake's among them
    PREP_STEPS = 256 // between two ticks, as pycnc.run has it
};

typedef struct summary {
    uint64_t hash;         // of all setpoints, tick by tick
    uint64_t ticks;
    uint64_t starved;      // ticks in which the path was waited for
    uint64_t prep_steps;
    int64_t error;         // nck_status_t of a program error, else 0
    uint64_t kernel_bytes; // sizeof(nck_t)
    uint64_t stack_bytes;  // used at most, from main on
} summary_t;

typedef struct controller {
    int program; // file
    int rows;    // file, -1: none
    char text[TEXT_MAX];
    size_t text_size, text_used;
    nck_status_t prep_status;
    uint64_t hold; // the tick that a hold is asked for at; 0: none
    int rests;     // ticks that it has rested for
    summary_t summary;
} controller_t;

static nck_t nck;
static nck_machine_t machine;
static controller_t controller;

static void feed(controller_t *self) {
    if (self->text_used == self->text_size) {
        self->text_size = board_read(self->program, self->text, sizeof self->text);
        self->text_used = 0;
    }
    if (self->text_size == 0) {
        nck_end(&nck);
        return;
    }
    size_t used = 0;
    (void)nck_push(&nck, self->text + self->text_used, self->text_size - self->text_used, &used);
    self->text_used += used;
}

// One step of prep. Returns 1 if another one has something to do.
static int prep(controller_t *self) {
    if (self->prep_status == NCK_DONE) return 0;
    mark_prep_begin();
    const nck_status_t status = nck_prep(&nck);
    mark_prep_end();
    self->prep_status = status;
    self->summary.prep_steps++;
    if (status < NCK_OK) self->summary.error = status;
    if (status == NCK_EMPTY) feed(self);
    return status != NCK_FULL && status != NCK_DONE;
}

// FNV-1a over words of 64 bits (Fowler, Noll, Vo, Eastlake: The FNV Non-Cryptographic Hash
// Algorithm, 2012), with its constants.
static void hash_setpoints(summary_t *summary, const nck_axes_t *axes) {
    for (int k = 0; k < NCK_AXIS_MAX; k++) {
        summary->hash = (summary->hash ^ (uint64_t)axes->joint_nm[k]) * 0x100000001b3u;
    }
}

// The hold begins, or it has rested for long enough.
static void hold(controller_t *self, nck_tick_state_t state) {
    if (self->summary.ticks == self->hold) nck_hold(&nck);
    self->rests += state == NCK_TICK_HOLD;
    if (self->rests == RESTS) nck_resume(&nck);
}

static void tick(controller_t *self) {
    nck_pose_t pose;
    nck_axes_t axes;
    mark_tick_begin();
    const nck_tick_state_t state = nck_tick(&nck, &pose, &axes);
    mark_tick_end();
    if (state == NCK_TICK_WAIT) nck_resume(&nck);
    if (self->hold > 0) hold(self, state);
    self->summary.starved += state == NCK_TICK_STARVED;
    self->summary.ticks++;
    hash_setpoints(&self->summary, &axes);
    if (self->rows >= 0) (void)board_write(self->rows, &axes, sizeof axes);
}

// Returns 1 when the program has ended.
static int run(controller_t *self) {
    while (prep(self)) continue;
    while (self->prep_status != NCK_DONE || !nck_is_idle(&nck)) {
        if (self->summary.ticks == TICK_MAX) return 0;
        tick(self);
        for (int n = 0; n < PREP_STEPS && prep(self); n++) continue;
    }
    return 1;
}

static int open_argument(int k, board_mode_t mode) {
    char name[NAME_MAX];
    return board_argument(k, name, sizeof name) < 0 ? -1 : board_open(name, mode);
}

static uint64_t read_number(int k) {
    char digits[NAME_MAX];
    uint64_t number = 0;
    if (board_argument(k, digits, sizeof digits) < 0) return 0;
    for (const char *at = digits; *at >= '0' && *at <= '9'; at++) {
        number = 10 * number + (uint64_t)(*at - '0');
    }
    return number;
}

// The image must have this build's size: then capacities and layout are the same.
static int read_machine(void) {
    char beyond;
    const int file = open_argument(1, BOARD_READ);
    if (file < 0 || board_read(file, &machine, sizeof machine) != sizeof machine) return 0;
    return board_read(file, &beyond, 1) == 0;
}

int main(void) {
    controller.program = open_argument(2, BOARD_READ);
    const int file = open_argument(3, BOARD_WRITE);
    controller.rows = open_argument(4, BOARD_WRITE);
    controller.hold = read_number(5);
    if (controller.program < 0 || file < 0 || !read_machine()) return 1;
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 1;
    controller.summary.hash = 0xcbf29ce484222325u;
    controller.summary.kernel_bytes = sizeof nck;
    board_stack_paint();
    if (!run(&controller)) return 2;
    controller.summary.stack_bytes = board_stack_used();
    const size_t size = sizeof controller.summary;
    return board_write(file, &controller.summary, size) == size ? 0 : 1;
}
