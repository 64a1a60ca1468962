// SPDX-License-Identifier: MIT
// Nothing gets slower unseen: programs of every family on the exact path, under either slope that
// takes it, against the ticks that they took when the table was written. `test_pace write`
// prints the rows for pace.h; a number that grows needs a reason in the commit.
#include <stdlib.h> // EXIT_SUCCESS

#include "motion_check.h"
#include "pace.h" // pace_ticks

enum { WAYS = 2, BLOCKS = 120 };
#define SLACK 0.005 // of the ticks that may come on top

static const uint32_t ways[WAYS] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};

static motion_t motion;

// A short program of a family.
static uint64_t ticks_of(int family, uint32_t slope)
{
    motion_family_t few = motion_family[family];
    if (few.blocks > BLOCKS) few.blocks = BLOCKS;
    motion_begin(&motion, 70 + (uint64_t)family);
    motion.machine.slope = slope;
    motion_program(&motion, &few, 0.05);
    return motion_run(&motion, NULL) ? motion.ticks : UINT64_MAX;
}

static const uint32_t *table(int family)
{
    const int is_small = NCK_PROFILE < 1024;
    return pace_ticks[is_small][family];
}

static void no_program_takes_longer_than_it_did(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        for (int k = 0; k < WAYS; k++) {
            const uint64_t ticks = ticks_of(family, ways[k]);
            const double most = table(family)[k] * (1.0 + SLACK);
            if (CHECK(check, (double)ticks <= most)) continue;
            printf("    %s, slope %u: %llu ticks, were %u\n", motion_family[family].name, ways[k],
                   (unsigned long long)ticks, table(family)[k]);
        }
    }
}

static int write_table(void)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        const char *before = "        {";
        for (int k = 0; k < WAYS; k++) {
            printf("%s%llu", before, (unsigned long long)ticks_of(family, ways[k]));
            before = ", ";
        }
        printf("}, // %s\n", motion_family[family].name);
    }
    return EXIT_SUCCESS;
}

int main(int count, char **words)
{
    check_t check = {0};
    if (count == 2 && strcmp(words[1], "write") == 0) return write_table();
    CHECK_RUN(&check, no_program_takes_longer_than_it_did);
    return check_end(&check);
}
