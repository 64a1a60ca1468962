// SPDX-License-Identifier: MIT
// Outputs and their latch, on a board of the test's own.
#include "check.h"

#include "hal/switches.h" // the interface under test

enum { CHANGES = 16 };

static struct {
    hal_change_t change[CHANGES];
    int count;
    int interrupted; // 1: a fault's handler comes while the next change is written
} board;

uint32_t hal_unfed(void) { return 7; }

void hal_write_change(const hal_change_t *change) {
    board.change[board.count++] = *change;
    if (!board.interrupted) return;
    board.interrupted = 0;
    hal_make_safe();
}

static void a_change_is_written_once(check_t *check) {
    hal_switch(HAL_SPINDLE, 800);
    hal_switch(HAL_SPINDLE, 800);
    CHECK_INT(check, board.count, 1);
    CHECK_INT(check, board.change[0].output, HAL_SPINDLE);
    CHECK_INT(check, board.change[0].value, 800);
    CHECK_INT(check, board.change[0].unfed, 7);
    CHECK_INT(check, hal_switched(HAL_SPINDLE), 800);
    CHECK_INT(check, hal_is_safe(), 0);
}

static void a_handler_that_comes_between_wins_for_good(check_t *check) {
    hal_switch(HAL_DRIVES, 1);
    board.interrupted = 1;
    hal_switch(HAL_COOLANT, 1);
    CHECK_INT(check, hal_is_safe(), 1);
    hal_switch(HAL_DRIVES, 1);
    for (int k = 0; k < HAL_OUTPUTS; k++) {
        CHECK_INT(check, hal_switched((hal_output_t)k), 0);
    }
    const int count = board.count;
    hal_make_safe();
    CHECK_INT(check, board.count, count);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_change_is_written_once);
    CHECK_RUN(&check, a_handler_that_comes_between_wins_for_good);
    return check_end(&check);
}
