// SPDX-License-Identifier: MIT
// The board of the firmware in docs/firmware.md: a serial line that is a file, drives that print
// the setpoints, and a panel that is operated at given periods:
//
//     firmware PROGRAM [PERIOD hold|start|half|full|abort]…
//
// Prints on standard error what the operator is told, then how often it has planned before the
// first period.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nck/nck.h"

enum { PREFILL_MAX = 100000, STEPS = 200, PERIODS_MAX = 1000000 };

// What the page has the reader write, and what it defines.
size_t line_read(char *text, size_t size);
int line_is_closed(void);
void drives_write(const int64_t *joint_nm);
void spindle_set(double rpm);
void coolant_set(int on);
void operator_told(uint32_t place, uint32_t column, const char *id);
nck_status_t motion_init(const int64_t *position_nm);
nck_status_t motion_plan(void);
int motion_tick(void);
void panel_hold(void);
void panel_start(void);
void panel_override(uint32_t feed, uint32_t rapid);
void panel_abort(void);

static FILE *line;

size_t line_read(char *text, size_t size) { return fread(text, 1, size, line); }
int line_is_closed(void) { return feof(line); }
void spindle_set(double rpm) { printf("spindle %g\n", rpm); }
void operator_told(uint32_t place, uint32_t column, const char *id) {
    fprintf(stderr, "line %u, column %u: %s\n", (unsigned)place, (unsigned)column, id);
}
void coolant_set(int on) { printf("coolant %d\n", on); }

void drives_write(const int64_t *joint_nm) {
    printf("%lld %lld %lld\n", (long long)joint_nm[0], (long long)joint_nm[1],
           (long long)joint_nm[2]);
}

static void operate(const char *word) {
    if (strcmp(word, "hold") == 0) panel_hold();
    if (strcmp(word, "start") == 0) panel_start();
    if (strcmp(word, "abort") == 0) panel_abort();
    if (strcmp(word, "half") == 0) panel_override(50, 100);
    if (strcmp(word, "full") == 0) panel_override(100, 100);
}

// Plan until the tick must go first, so many steps at most. Returns how many it were, and whether
// nothing is left to plan.
static int plan(int steps_max, int *is_done_out) {
    nck_status_t status = NCK_OK;
    int n = 0;
    while (n < steps_max && status != NCK_FULL && status != NCK_DONE) {
        status = motion_plan();
        n++;
    }
    *is_done_out = status == NCK_DONE;
    return n;
}

// Run until nothing is left, or the panel rests in a hold. Returns 0 if all was executed.
static int run(int count, char **arguments) {
    int is_done = 0;
    const int planned = plan(PREFILL_MAX, &is_done);
    for (int period = 1; period <= PERIODS_MAX; period++) {
        for (int k = 2; k + 1 < count; k += 2) {
            if (atoi(arguments[k]) == period) operate(arguments[k + 1]);
        }
        const int is_moving = motion_tick();
        if (!is_done) (void)plan(STEPS, &is_done);
        if (!is_moving && is_done) {
            fprintf(stderr, "%d\n", planned);
            return 0;
        }
    }
    return 1;
}

int main(int count, char **arguments) {
    const int64_t position_nm[3] = {0, 0, 0};
    line = count > 1 ? fopen(arguments[1], "rb") : NULL;
    if (!line) return 2;
    if (motion_init(position_nm) != NCK_OK) return 2;
    return run(count, arguments);
}
