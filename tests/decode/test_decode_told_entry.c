// SPDX-License-Identifier: MIT
// A program begins at a line: which pass of a loop that is, and what a line is that jumps leave
// out.
#include "told_check.h"

static told_t self;

// A program that begins at a line, and what it is told to do.
typedef struct begun_row {
    uint32_t line;
    told_row_t row;
} begun_row_t;

static void begin(check_t *check, nck_dialect_t base, const begun_row_t *rows, size_t count) {
    for (size_t k = 0; k < count; k++) {
        told_begin(&self, base);
        told_bound(&self);
        self.machine.dialect.from_line = rows[k].line;
        told_check(check, &self, &rows[k].row, 1);
    }
}

#define BEGIN(check, base, rows) begin((check), (base), (rows), sizeof(rows) / sizeof *(rows))

// Three passes: the first goes on early, the second has a branch more; another is of no pass, and
// a loop inside has none.
#define PASSES                                                                              \
    "#1=0\no1 while [#1 lt 3]\n#1=[#1+1]\no2 if [#1 eq 2]\nG0 X5\no2 endif\n"               \
    "o3 if [#1 eq 9]\nG0 X6\no3 endif\no4 repeat [0]\nG0 X7\no4 endrepeat\n"                \
    "o5 if [#1 eq 1]\no1 continue\no5 endif\nG0 Y#1\no1 endwhile\n"                         \
    "o6 if [#1 eq 9]\nG0 X8\no6 endif\nG0 Z1\n"

static const begun_row_t pass_rows[] = {
    {5, {PASSES,
      "5 entry 0 stop P0 Q0; 5 entry 1; 5 entry 2 F100; 5 rapid X5 smooth P0.01"
      " Q0.01; 16 rapid Y2; 16 rapid Y3; 21 rapid Z1"}},
    {6, {PASSES,
      "7 entry 0 stop P0 Q0; 7 entry 1; 7 entry 2 F100; 5 rapid X5 smooth P0.01"
      " Q0.01; 16 rapid Y2; 16 rapid Y3; 21 rapid Z1"}},
    {8, {PASSES,
      "5 rapid X5; 16 rapid Y2; 16 rapid Y3; !18:0 label-missing N 8/0"}},
    {11, {PASSES,
      "5 rapid X5; 16 rapid Y2; 16 rapid Y3; !18:0 label-missing N 11/0"}},
    {12, {PASSES,
      "13 entry 0 stop P0 Q0; 13 entry 1; 13 entry 2 F100; 5 rapid X5 smooth"
      " P0.01 Q0.01; 16 rapid Y2; 16 rapid Y3; 21 rapid Z1"}},
    {14, {PASSES,
      "14 entry 0 stop P0 Q0; 14 entry 1; 14 entry 2 F100; 5 rapid X5 smooth"
      " P0.01 Q0.01; 16 rapid Y2; 16 rapid Y3; 21 rapid Z1"}},
    {15, {PASSES,
      "5 rapid X5; 16 entry 0 stop P0 Q0; 16 entry 1; 16 entry 2 F100; 16 rapid"
      " Y2 smooth P0.01 Q0.01; 16 rapid Y3; 21 rapid Z1"}},
    {17, {PASSES,
      "17 entry 0 stop P0 Q0; 17 entry 1; 17 entry 2 F100; 5 rapid X5 smooth"
      " P0.01 Q0.01; 16 rapid Y2; 16 rapid Y3; 21 rapid Z1"}},
    {19, {PASSES,
      "5 rapid X5; 16 rapid Y2; 16 rapid Y3; 21 entry 0 stop P0 Q0; 21 entry 1;"
      " 21 entry 2 F100; 21 rapid Z1 smooth P0.01 Q0.01"}},
    {20, {PASSES,
      "5 rapid X5; 16 rapid Y2; 16 rapid Y3; 21 entry 0 stop P0 Q0; 21 entry 1;"
      " 21 entry 2 F100; 21 rapid Z1 smooth P0.01 Q0.01"}},
};

static void in_a_loop_the_first_pass_counts_that_comes_to_the_line(check_t *check) {
    BEGIN(check, NCK_DIALECT_LINUXCNC, pass_rows);
}

// A call within a loop has lines behind the one that is asked for, which is behind the loop.
#define CALLS                                                                               \
    "o1 repeat [2]\no9 call\no1 endrepeat\no2 if [0]\nG0 X1\no2 endif\nG0 X2\nM2\n"         \
    "o9 sub\nG0 X3\no9 endsub\n"

static const begun_row_t call_rows[] = {
    {2, {CALLS,
      "2 entry 0 stop P0 Q0; 2 entry 1; 2 entry 2 F100; 10 rapid X3 smooth"
      " P0.01 Q0.01; 10 rapid; 7 rapid X2; 8 end M2"}},
    {5, {CALLS,
      "10 rapid X3; 10 rapid; 7 entry 0 stop P0 Q0; 7 entry 1; 7 entry 2 F100;"
      " 7 rapid X2 smooth P0.01 Q0.01; 8 end M2"}},
    {9, {CALLS,
      "10 entry 0 stop P0 Q0; 10 entry 1; 10 entry 2 F100; 10 rapid X3 smooth"
      " P0.01 Q0.01; 10 rapid; 7 rapid X2; 8 end M2"}},
    {11, {CALLS,
      "10 rapid X3; 11 entry 0 stop P0 Q0; 11 entry 1; 11 entry 2 F100; 10"
      " rapid smooth P0.01 Q0.01; 7 rapid X2; 8 end M2"}},
};

static void a_call_in_a_loop_passes_no_line_of_it(check_t *check) {
    BEGIN(check, NCK_DIALECT_LINUXCNC, call_rows);
}

#define JUMPS "G0 X1.\nGOTO 5\nX2.\nN5 X3.\nM98 P7\nX4.\nM30\nO7\nX5.\nM99\n"

static const begun_row_t jump_rows[] = {
    {3, {JUMPS,
      "1 rapid X1; 4 entry 0 stop P0 Q0; 4 entry 1; 4 entry 2 F100; 4 rapid X3"
      " smooth P0.01 Q0.01; 9 rapid X5; 6 rapid X4; 7 end M30"}},
    {4, {JUMPS,
      "1 rapid X1; 4 entry 0 stop P0 Q0; 4 entry 1; 4 entry 2 F100; 4 rapid X3"
      " smooth P0.01 Q0.01; 9 rapid X5; 6 rapid X4; 7 end M30"}},
    {8, {JUMPS,
      "1 rapid X1; 4 rapid X3; 9 entry 0 stop P0 Q0; 9 entry 1; 9 entry 2 F100;"
      " 9 rapid X5 smooth P0.01 Q0.01; 6 rapid X4; 7 end M30"}},
    {9, {JUMPS,
      "1 rapid X1; 4 rapid X3; 9 entry 0 stop P0 Q0; 9 entry 1; 9 entry 2 F100;"
      " 9 rapid X5 smooth P0.01 Q0.01; 6 rapid X4; 7 end M30"}},
};

static void where_a_jump_ends_the_program_may_begin(check_t *check) {
    BEGIN(check, NCK_DIALECT_FANUC, jump_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, in_a_loop_the_first_pass_counts_that_comes_to_the_line);
    CHECK_RUN(&check, a_call_in_a_loop_passes_no_line_of_it);
    CHECK_RUN(&check, where_a_jump_ends_the_program_may_begin);
    return check_end(&check);
}
