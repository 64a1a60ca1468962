// SPDX-License-Identifier: MIT
// The board of the firmware in docs/firmware.md: a serial line that is a file, drives that print
// the setpoints, and a panel that is operated at given periods:
//
//     firmware PROGRAM [PERIOD hold|start|half|full|abort]…
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nck/nck.h"

enum { PREFILL = 100000, STEPS = 200, PERIODS_MAX = 100000 };

// What the page has the reader write, and what it defines.
size_t line_read(char *text, size_t size);
int line_is_closed(void);
void drives_write(const int64_t *joint_nm);
void spindle_set(double rpm);
void coolant_set(int on);
nck_status_t motion_init(const int64_t *position_nm);
int motion_plan(void);
int motion_tick(void);
void panel_hold(void);
void panel_start(void);
nck_status_t panel_override(uint32_t feed, uint32_t rapid);
void panel_abort(void);

static FILE *line;

size_t line_read(char *text, size_t size) { return fread(text, 1, size, line); }
int line_is_closed(void) { return feof(line); }
void spindle_set(double rpm) { printf("spindle %g\n", rpm); }
void coolant_set(int on) { printf("coolant %d\n", on); }

void drives_write(const int64_t *joint_nm) {
    printf("%lld %lld %lld\n", (long long)joint_nm[0], (long long)joint_nm[1],
           (long long)joint_nm[2]);
}

static void operate(const char *word) {
    if (strcmp(word, "hold") == 0) panel_hold();
    if (strcmp(word, "start") == 0) panel_start();
    if (strcmp(word, "abort") == 0) panel_abort();
    if (strcmp(word, "half") == 0 && panel_override(50, 100) != NCK_OK) exit(3);
    if (strcmp(word, "full") == 0 && panel_override(100, 100) != NCK_OK) exit(3);
}

// Run until nothing is left, or the panel rests in a hold. Returns 0 if all was executed.
static int run(int count, char **arguments) {
    int is_planning = 1;
    for (int n = 0; n < PREFILL && is_planning; n++) is_planning = motion_plan();
    for (int period = 1; period <= PERIODS_MAX; period++) {
        for (int k = 2; k + 1 < count; k += 2) {
            if (atoi(arguments[k]) == period) operate(arguments[k + 1]);
        }
        const int is_moving = motion_tick();
        for (int n = 0; n < STEPS && is_planning; n++) is_planning = motion_plan();
        if (!is_moving && !is_planning) return 0;
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
