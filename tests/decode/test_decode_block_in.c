// SPDX-License-Identifier: MIT
// Room 1: blocks that come without text, and texts that end without M2.
#include <math.h> // INFINITY NAN

#include "nck/prep/1_decode/line/line.h" // nck_decode_block_good
#include "told_check.h"

static told_t self;

static void begin(nck_dialect_t base) {
    told_begin(&self, base);
    told_turns(&self);
}

// Push a block and tell what comes of it.
static void push(const nck_block_in_t *in) {
    nck_block_t block;
    nck_status_t status = nck_decode_push_block(&self.decode, in);
    if (status < 0) told_add(&self, "; %s", nck_status_id(status));
    while (status != NCK_E_ARGUMENT && status != NCK_EMPTY && status != NCK_DONE) {
        status = told_pull(&self, &block);
        told_findings(&self);
        if (status == NCK_OK) told_block(&self, &block);
    }
}

static void check_told(check_t *check, const char *want) {
    if (check_that(check, told_same(self.text, want), want, __FILE__, __LINE__)) return;
    printf("    got  %s\n", self.text);
}

#define ROWS(rows) (sizeof(rows) / sizeof *(rows))

static void tell(check_t *check, const nck_block_in_t *rows, size_t count, const char *want) {
    told_reset(&self);
    for (size_t k = 0; k < count; k++) push(&rows[k]);
    check_told(check, want);
}

static void aim(nck_block_in_t *block, int axis, double target) {
    if (axis < NCK_AXIS_MAX) block->target[axis] = target;
}

static void moves_go_where_they_say(check_t *check) {
    nck_block_in_t rows[] = {
        {.id = 5, .kind = NCK_IN_RAPID, .axes = 5, .target = {1.5, 9.0, -2.0}},
        {.id = 6, .kind = NCK_IN_LINE, .sets = 1, .feed = 100.0, .axes = 2, .target = {0.0, 3.0}},
        {.id = 7, .kind = NCK_IN_ARC, .axes = 1, .turns = -1, .plane = 17, .target = {11.5},
         .centre = {6.5, 3.0}},
        {.id = 8, .kind = NCK_IN_ARC, .axes = 1, .turns = 2, .plane = 17, .target = {1.5},
         .centre = {6.5, 3.0}},
        {.id = 9, .kind = NCK_IN_ARC, .axes = 5, .turns = 1, .plane = 18, .target = {3.5, 0, 0.0},
         .centre = {-2.0, 3.5}},
        {.id = 10, .kind = NCK_IN_ARC, .axes = 6, .turns = -1, .plane = 19,
         .target = {0, 5.0, 2.0}, .centre = {5.0, 0.0}},
        {.id = 11, .kind = NCK_IN_LINE, .axes = 8},
        {.id = 12, .kind = NCK_IN_LINE, .sets = 1, .feed_mode = NCK_FEED_INVERSE, .feed = 2.0,
         .axes = 1, .target = {1e6}},
        {.id = 13, .kind = NCK_IN_LINE, .axes = 1, .target = {2.0}},
        {.id = 14, .kind = NCK_IN_LINE, .axes = 64, .target = {0}},
        {.id = 15, .kind = NCK_IN_LINE, .axes = 1, .target = {1000000.5}},
        {.id = 16, .kind = NCK_IN_LINE, .axes = 16},
        {.id = 17, .kind = NCK_IN_RAPID, .axes = 16},
        {.id = 18, .kind = NCK_IN_SET},
    };
    begin(NCK_DIALECT_LINUXCNC);
    aim(&rows[6], NCK_AXIS_A, 0.5);
    aim(&rows[11], NCK_AXIS_B, -1000000.5);
    aim(&rows[12], NCK_AXIS_B, -1000000.0);
    tell(check, rows, ROWS(rows),
         "5 rapid X1.5 Z-2; 6 line Y3 F100; 7 arc X11.5 G17 about 6.5 3 by -180;"
         " 8 arc X1.5 G17 about 6.5 3 by 540; 9 arc X3.5 Z0 G18 about -2 3.5 by 90;"
         " 10 arc Y5 Z2 G19 about 5 0 by -90; 11 line A0.5; 12 line X1000000 F2 inverse;"
         " !13:0 feed-missing F; !14:0 axis-unknown U; !15:0 number-range X 1000000.5/1000000;"
         " !16:0 number-range B -1000000.5/1000000; 17 rapid X2 B-1000000");
}

static void words_set_and_hand_over(check_t *check) {
    static const nck_block_in_t rows[] = {
        {.id = 1, .kind = NCK_IN_S, .value = 500.0}, {.id = 2, .kind = NCK_IN_M, .value = 3.0},
        {.id = 3, .kind = NCK_IN_T, .value = 7.0}, {.id = 4, .kind = NCK_IN_DWELL, .value = 1.5},
        {.id = 5, .kind = NCK_IN_M, .value = 6.0}, {.id = 6, .kind = NCK_IN_M, .value = 999.0},
        {.id = 7, .kind = NCK_IN_SET, .sets = 2, .path_mode = NCK_PATH_CONTINUOUS,
         .tolerance = 0.5},
        {.id = 8, .kind = NCK_IN_RAPID, .axes = 1, .target = {1.0}},
        {.id = 9, .kind = NCK_IN_RAPID, .sets = 2, .path_mode = NCK_PATH_STOP, .tolerance = 7.0,
         .axes = 1, .target = {2.0}},
        {.id = 10, .kind = NCK_IN_RAPID, .sets = 2, .path_mode = NCK_PATH_CONTINUOUS,
         .tolerance = 1e-5, .axes = 1, .target = {3.0}},
        {.id = 11, .kind = NCK_IN_SET, .sets = 1, .feed_mode = NCK_FEED_PER_REV, .feed = 0.25},
        {.id = 12, .kind = NCK_IN_LINE, .axes = 1, .target = {4.0}},
        {.id = 13, .kind = NCK_IN_M, .value = 4.0},
        {.id = 14, .kind = NCK_IN_LINE, .axes = 1, .target = {5.0}},
        {.id = 15, .kind = NCK_IN_DWELL, .value = 0.0}, {.id = 16, .kind = NCK_IN_M, .value = 30.0},
        {.id = 17, .kind = NCK_IN_M, .value = 8.0},
    };
    begin(NCK_DIALECT_LINUXCNC);
    tell(check, rows, ROWS(rows),
         "1 out S500; 2 out M3 S500; 3 out T7; 4 dwell for 1.5; 5 out M5 S0; 5 wait M6;"
         " !6:0 m-unknown M 999/0; 8 rapid X1 P0.5 Q0.5; 9 rapid X2 stop P0 Q0;"
         " ?10:0 no-tolerance P 1e-05/0; 10 rapid X3 smooth P1e-05 Q1e-05;"
         " !12:0 feed-missing S; 13 out M4 X4 per-rev S500; 14 line X5 F0.25; 15 dwell for 0;"
         " 16 end M30; state");
}

static void what_is_no_block_is_refused(check_t *check) {
    const nck_block_in_t good = {.kind = NCK_IN_ARC, .axes = 1, .turns = 1, .plane = 17,
                                 .sets = 3, .feed = 1.0, .centre = {2e6, -2e6}};
    nck_block_in_t bad[30];
    size_t n = 0;
    for (size_t k = 0; k < ROWS(bad); k++) bad[k] = good;
    bad[n++].kind = 8;
    bad[n++].sets = 4;
    bad[n++].turns = 0;
    bad[n++].turns = NCK_DECODE_TURNS_MAX + 1;
    bad[n++].turns = -NCK_DECODE_TURNS_MAX - 1;
    bad[n++].plane = 16;
    bad[n++].plane = 20;
    bad[n++].feed = 0.0;
    bad[n++].feed = 2e9;
    bad[n++].feed_mode = 3;
    bad[n++].path_mode = 4;
    bad[n].path_mode = NCK_PATH_CONTINUOUS;
    bad[n++].tolerance = -1.0;
    bad[n].path_mode = NCK_PATH_CONTINUOUS;
    bad[n++].tolerance = 1000001.0;
    bad[n++].centre[0] = 2000001.0;
    bad[n++].centre[0] = -2000001.0;
    bad[n++].centre[1] = 2000001.0;
    bad[n++].centre[1] = (double)NAN;
    bad[n++].target[0] = (double)INFINITY;
    bad[n++].target[0] = (double)NAN;
    for (int kind = NCK_IN_DWELL; kind <= NCK_IN_T; kind++) {
        bad[n].kind = (uint8_t)kind;
        bad[n++].value = -1.0;
        bad[n].kind = (uint8_t)kind;
        bad[n++].value = kind == NCK_IN_DWELL ? 1000001.0 : 2e9;
    }
    bad[n].kind = NCK_IN_M;
    bad[n++].value = 1.5;
    bad[n].kind = NCK_IN_T;
    bad[n++].value = 1.5;
    CHECK(check, n <= ROWS(bad));
    begin(NCK_DIALECT_LINUXCNC);
    CHECK(check, nck_decode_block_good(&good));
    for (size_t k = 0; k < n; k++) CHECK(check, !nck_decode_block_good(&bad[k]));
    nck_block_in_t edge = good;
    edge.turns = -NCK_DECODE_TURNS_MAX;
    edge.target[1] = (double)NAN; // of an axis that does not count
    edge.feed = 1e9;
    edge.path_mode = NCK_PATH_CONTINUOUS;
    edge.tolerance = 1e6;
    CHECK(check, nck_decode_block_good(&edge));
}

static void coordinates_are_the_programs(check_t *check) {
    static const nck_block_in_t rows[] = {
        {.id = 1, .kind = NCK_IN_RAPID, .axes = 7, .target = {1.0, 2.0, 3.0}},
        {.id = 2, .kind = NCK_IN_ARC, .sets = 1, .feed = 9.0, .axes = 1, .turns = 1, .plane = 17,
         .target = {3.0}, .centre = {2.0, 2.0}},
        {.id = 3, .kind = NCK_IN_LINE, .axes = 1, .target = {999995.0}},
    };
    begin(NCK_DIALECT_LINUXCNC);
    self.machine.work_nm[0][0] = 10000000;
    self.machine.work_nm[0][1] = 20000000;
    tell(check, rows, ROWS(rows),
         "1 rapid X11 Y22 Z3; 2 arc X13 G17 about 12 22 by 180 F9;"
         " !3:0 number-range X 999995/1000000");
}

// ---- a text without M2

static const told_row_t ends[] = {
    {"G0 X1\n", "1 rapid X1; ?1:0 no-end; 1 end M2"},
    {"G0 X1", "1 rapid X1; ?1:0 no-end; 1 end M2"},
    {"G0 X1\nM2", "1 rapid X1; 2 end M2"},
    {"G0 X1\nM30\n\n%\n \n", "1 rapid X1; 2 end M30"},
    {"G0 X1\nM30\n\nG0\n", "1 rapid X1; ?4:0 after-end; 2 end M30"},
    {"G0 X1\nM30\n(a;b) (\n%\n; c) d\n", "1 rapid X1; 2 end M30"},
    {"G0 X1\nM30\n;\nG0\n", "1 rapid X1; ?4:0 after-end; 2 end M30"},
    {"G0 X1\nM30\n()G0\n", "1 rapid X1; ?3:0 after-end; 2 end M30"},
    {"%\nG0 X1\n%\n", "2 rapid X1; 3 end M2"},
    {"%\nG0 X1\n%\nX2\n", "2 rapid X1; ?4:0 after-end; 3 end M2"},
    {"G0 X1\r\nX2\rX3\n\rX4", "1 rapid X1; 2 rapid X2; 3 rapid X3; 5 rapid X4; ?5:0 no-end;"
                              " 5 end M2"},
    {"", "!0:0 no-program"},
    {"\n\n", "!2:0 no-program"},
    {"%\n%\n", "!2:0 no-program"},
    {"N5\n", "!1:0 no-program"},
    {"(only this)\n", "!1:0 no-program"},
    {"F9 G5.2 X1 Y1 P1\n", "!1:4 spline M 5.2/0"},
    {"%\nF9 G5.2 X1 Y1 P1\n%\n", "!2:4 spline M 5.2/0"},
    {"o1 sub\nG0 X1\no1 endsub", "?3:0 no-end; 3 end M2"},
    {"o1 if [1]\nG0 X1", "2 rapid X1; ?2:0 no-end; 2 end M2"},
};

static void a_text_ends_where_its_lines_do(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.bare = 1;
    self.notes = 2;
    TOLD(check, &self, ends);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, moves_go_where_they_say);
    CHECK_RUN(&check, words_set_and_hand_over);
    CHECK_RUN(&check, what_is_no_block_is_refused);
    CHECK_RUN(&check, coordinates_are_the_programs);
    CHECK_RUN(&check, a_text_ends_where_its_lines_do);
    return check_end(&check);
}
