// SPDX-License-Identifier: MIT
// The whole kernel in three threads, for the thread sanitizer: prep, tick and an operator who
// holds, resumes and overrides without a pause. Nothing is in step, so that the tick starves often.
//
//     kernel_threads MACHINE PROGRAM
//
// Prints the ticks and the last setpoints. Exit status: 0, or 1 if a file is wrong or a status is
// not what the door promises.
#include <pthread.h> // pthread_create
#include <stdio.h>   // printf

#include "board/board.h" // files, arguments
#include "nck/nck_tools.h"     // the kernel

enum { NAME_MAX = 200, TEXT_MAX = 1 << 20, TICKS_BETWEEN = 50 };

static nck_t nck;
static nck_machine_t machine;
static char text[TEXT_MAX];
static size_t text_size;
static nck_axes_t axes;
static uint32_t ticks; // tick writes, the operator reads
static uint32_t prep_is_done, is_over, failed;

static void *run_tick(void *user) {
    nck_pose_t pose;
    while (!nck_fence_load(&prep_is_done) || !nck_is_idle(&nck)) {
        const nck_tick_state_t state = nck_tick(&nck, &pose, &axes);
        if (state == NCK_TICK_WAIT) nck_resume(&nck);
        nck_fence_store(&ticks, ticks + 1);
    }
    nck_fence_store(&is_over, 1);
    return user;
}

static void pause_for(uint32_t count) {
    const uint32_t from = nck_fence_load(&ticks);
    while (nck_fence_load(&ticks) - from < count && !nck_fence_load(&is_over)) continue;
}

static void *run_operator(void *user) {
    for (uint32_t n = 0; !nck_fence_load(&is_over); n++) {
        nck_hold(&nck);
        pause_for(TICKS_BETWEEN);
        nck_resume(&nck);
        pause_for(TICKS_BETWEEN);
        nck_set_override(&nck, (50 + n % 3 * 50) * NCK_PERCENT, 100 * NCK_PERCENT);
        pause_for(TICKS_BETWEEN);
    }
    return user;
}

static void run_prep(void) {
    size_t used = 0;
    nck_status_t status = NCK_OK;
    while (status != NCK_DONE) {
        status = nck_prep(&nck);
        if (status < NCK_OK) nck_fence_store(&failed, 1);
        if (status != NCK_EMPTY) continue;
        size_t taken = 0;
        if (used == text_size) {
            nck_end(&nck);
        } else {
            (void)nck_push(&nck, text + used, text_size - used, &taken);
        }
        used += taken;
    }
    nck_fence_store(&prep_is_done, 1);
}

static size_t read_argument(int k, void *data, size_t size) {
    char name[NAME_MAX];
    if (board_argument(k, name, sizeof name) < 0) return 0;
    const int file = board_open(name, BOARD_READ);
    return file < 0 ? 0 : board_read(file, data, size);
}

int main(void) {
    pthread_t tick_thread, operator_thread;
    text_size = read_argument(2, text, sizeof text);
    if (read_argument(1, &machine, sizeof machine) != sizeof machine || text_size == 0) return 1;
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 1;
    if (pthread_create(&tick_thread, NULL, run_tick, NULL) != 0) return 1;
    if (pthread_create(&operator_thread, NULL, run_operator, NULL) != 0) return 1;
    run_prep();
    (void)pthread_join(tick_thread, NULL);
    (void)pthread_join(operator_thread, NULL);
    printf("%u", ticks);
    for (int k = 0; k < NCK_AXIS_MAX; k++) printf(" %lld", (long long)axes.joint_nm[k]);
    printf("\n");
    return failed ? 1 : 0;
}
