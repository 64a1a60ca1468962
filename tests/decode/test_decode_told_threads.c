// SPDX-License-Identifier: MIT
// Room 1: passes and taps to the ends of the travel, of no length, and what they leave unsaid.
#include "told_check.h"

static told_t self;

// X ends at -10 and 100, Z at -30 and 50. A pass of G76 goes in 1 mm beside its straight way, or
// out, beyond where its own ends are.
static const told_row_t travel_rows[] = {
    {"G0 X20 Y5 Z5 S300 M3\nG33 Z-31 K1\nG33 Z-30 K1\nG33 X101 K1\nG33 X100 K1\nG33 Y201 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Y5 Z5; !2:5 travel Z -31/-30;"
     " 3 thread Z-30 of 1 lead 1 for 0.3481; !4:5 travel X 101/100;"
     " 5 thread X100 of 1 lead 1 for 0.3481; !6:5 travel Y 201/200"},
    {"G0 X-8 Z5 S300 M3\nG76 P1.5 Z-20 I-1 J1 K1 L1 E2\nG0 Z5\n"
     "G76 P1.5 Z-20 I-1 J1.5 K1.5 L1 E2\nG0 X-7.5 Z5\nG76 P1.5 Z-20 I-1 J1.5 K1.5 L2 E2\n"
     "G0 X98 Z5\nG76 P1.5 Z-20 I1 J1 K1 L1 E2\nG0 X97.5 Z5\nG76 P1.5 Z-20 I1 J2 K2 L2 E2\n",
     "1 out S300; 1 out M3 S300; 1 rapid X-8 Z5; 2 rapid~ X-9;"
     " 2 thread X-10 Z-20 of 25 lead 1.5 in -1 over 2 for 3.492; 2 rapid~ X-8; 3 rapid Z5;"
     " 4 rapid~ X-9; !4:0 travel X -10.5/-10; 5 rapid X-7.5; 6 rapid~ X-10;"
     " 6 thread X-7.5 Z-20 of 25 lead 1.5 out 2.5 over 2 for 3.492; 7 rapid X98 Z5; 8 rapid~ X99;"
     " 8 thread X100 Z-20 of 25 lead 1.5 in 1 over 2 for 3.492; 8 rapid~ X98; 9 rapid X97.5 Z5;"
     " !10:0 travel X 100.5/100"},
    {"G0 X20 Z5 S300 M3\nG33.1 Z-31 K1\nG33.1 Z-30 K1\nG33.1 X101 K1\nG33.1 X100 K1\n"
     "G33.1 Y-20 K1\nG33.1 Y-20.001 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Z5; !2:7 travel Z -31/-30;"
     " 3 tap by 0 0 -35 lead 1 for 14.2; !4:7 travel X 101/100; 5 tap by 80 0 0 lead 1 for 32.2;"
     " 6 tap by 0 -20 0 lead 1 for 8.196; !7:7 travel Y -20.001/-20"},
    {"G0 X-8 Z5 S300 M3\nG76 P1.5 Z-20 I-1 J1.5 K1.5 L3 E2\nG76 P1.5 Z-20 I-1 J1 K1 L3 E2\n",
     "1 out S300; 1 out M3 S300; 1 rapid X-8 Z5; 2 rapid~ X-9; !2:0 travel X -10.5/-10;"
     " 3 rapid~ Z-20; !3:1 thread-run-in Z 0.410791918/0"},
};

static void passes_and_taps_end_within_the_travel(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    TOLD(check, &self, travel_rows);
}

// X stands beyond its travel: what leaves it there may be cut.
static const told_row_t beyond_rows[] = {
    {"S300 M3\nG33 Z-5 K1\nG33 X119 K1\nG33 X100 K1\n",
     "1 out S300 X120; 1 out M3 S300; 2 thread Z-5 of 5 lead 1 for 1.148; !3:5 travel X 119/100;"
     " 4 thread X100 of 19 lead 1 for 3.948"},
};

static void what_stands_beyond_the_travel_may_stay(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.start_nm[NCK_AXIS_X] = 120 * NCK_COUNTS_PER_MM;
    TOLD(check, &self, beyond_rows);
}

static const told_row_t empty_rows[] = {
    {"G0 X20 Z5 S300 M3\nG76 P1.5 Z5 I-2 J1 K1\nG33 Z5 K1\nG33 Z4.9999995 K1\nG33.1 Z5 K1\n"
     "G33.1 X21 Y1 K1\nG33.1 X19 Y1 Z6 K1\nG33.1 Y1 Z6 K1\nG33.1 X21 Z6 K1\nZ0 K1\n"
     "G33.1 X19 Y-1 Z4 K1\nX19 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Z5; 2 rapid~ X17;"
     " !2:1 thread-run-in Z 0.410791918/0; 6 tap by 4 1 0 lead 1 for 1.845;"
     " 7 tap by 2 1 1 lead 1 for 1.176; 8 tap by 0 1 1 lead 1 for 0.7619;"
     " 9 tap by 4 0 1 lead 1 for 1.845; 10 tap by 0 0 -5 lead 1 for 2.196;"
     " 11 tap by 2 -1 -1 lead 1 for 1.176; 12 tap by 2 0 0 lead 1 for 0.9962"},
    {"G0 Z5 S300 M3 F300\nG84 X1 Z1 R1\nG84 X1 Z-1 R1\nG84 X1 Z0.999 R1\n",
     "1 out S300; 1 out M3 S300; 1 rapid Z5; 2 rapid~ X1; 2 rapid~ Z1;"
     " !2:1 thread-run-in R 0.223606798/0; 3 tap by 0 0 -2 lead 1 for 0.9962;"
     " !4:1 thread-run-in R 0.240585224/0.001"},
    {"G0 X1 Z1 S9 M3\nG33 X1.01 K1000000\nG33 X1.01 K1000000.1\nG20 G33 X2 K39370.078\n",
     "1 out S9; 1 out M3 S9; 1 rapid X1 Z1; !2:1 thread-speed F 150000/95.2380952;"
     " !3:11 number-range K 1000000.1/1000000; !4:5 thread-speed F 149999.997/95.2380952"},
};

static void a_way_of_no_length_is_none(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, empty_rows);
}

static const told_row_t unsaid_rows[] = {
    {"S300 M3\nG33 Z-5 K1\nG33.1 Z-9 K1\n",
     "1 out S300; 1 out M3 S300; ?2:0 assumed-units; ?2:0 assumed-distance;"
     " 2 thread Z-5 of 5 lead 1 for 1.148; 3 tap by 0 0 -4 lead 1 for 1.796"},
    {"S300 M3\nG33.1 Z-5 K1\nG33 Z-9 K1\n",
     "1 out S300; 1 out M3 S300; ?2:0 assumed-units; ?2:0 assumed-distance;"
     " 2 tap by 0 0 -5 lead 1 for 2.196; 3 thread Z-9 of 9 lead 1 for 1.948"},
    {"S300 M3\nG33 Z-5\nZ-6 K1\nG33 Z-7 K1\nZ-8 K1\nG33.1 Z-9 K1\nZ-12 K2\nG33.1 Z-9\nZ-8 K1\n",
     "1 out S300; 1 out M3 S300; ?2:0 assumed-units; ?2:0 assumed-distance;"
     " !2:1 word-missing K 33/0; 4 thread Z-7 of 7 lead 1 for 1.548;"
     " 5 thread Z-8 of 1 lead 1 for 0.3481; 6 tap by 0 0 -1 lead 1 for 0.5962;"
     " 7 tap by 0 0 -4 lead 2 for 1.036; !8:1 word-missing K 33.1/0"},
    {"S300 M3\nG33\nG33.1\n",
     "1 out S300; 1 out M3 S300; !3:1 word-missing Z 33.1/0"},
};

static void what_a_thread_leaves_unsaid_is_told(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.notes = 1;
    TOLD(check, &self, unsaid_rows);
}

// X may go at 105 mm/s, and at 5 % more than 100 with a spindle that turns faster.
static const told_row_t fast_rows[] = {
    {"G0 Z5 S6000 M3\nG33 X60 K1\nG33 X0 K1.0001\nG33.1 X60 K1\nG33.1 X-1 K1.0001\n",
     "1 out S6000; 1 out M3 S6000; 1 rapid Z5; 2 thread X60 of 60 lead 1 for 0.8202;"
     " !3:1 thread-speed F 100.01/100; 4 tap X0 by 60 0 0 lead 1 for 1.635;"
     " !5:1 thread-speed F 100.01/100"},
    {"S.001 M3\nG33 Z-1 K1\nS.0009\nG33 Z0 K1\nS.001\nG33.1 Z-2 K1\n",
     "1 out S0.001; 1 out M3 S0.001; 2 thread Z-1 of 1 lead 1 for 9e+04; 3 out S0.0009 S0.0009;"
     " !4:1 thread-speed S; 5 out S0.001 S0.001; 6 tap by 0 0 -1 lead 1 for 1.5e+05"},
};

static void a_spindle_turns_as_fast_as_the_axes_can_follow(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.axis[NCK_AXIS_X].v_max = 105.0;
    TOLD(check, &self, fast_rows);
}

// A lead is a length along X, Y and Z. A stands beyond its travel, and stays there.
static const told_row_t rotary_rows[] = {
    {"S300 M3\nG33.1 A5 K1\nG33.1 A5 Z-1 K1\nG33 A5 Z-2 K1\nG33.1 Z-1 K1\nG33 Z-2 K1\n",
     "1 out S300 A5; 1 out M3 S300; !2:7 word-unused A; !3:7 word-unused A; !4:5 word-unused A;"
     " 5 tap by 0 0 -1 lead 1 for 0.5962; 6 thread Z-2 of 2 lead 1 for 0.5481"},
};

static void no_rotary_axis_has_a_lead(check_t *check) {
    const int a = NCK_AXIS_MAX > NCK_AXIS_A ? (int)NCK_AXIS_A : 0;
    if (NCK_AXIS_MAX <= NCK_AXIS_A) return; // only larger builds have the axis
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_turns(&self);
    self.machine.axis[a].max_nm = NCK_COUNTS_PER_DEG;
    self.machine.start_nm[a] = 5 * (int64_t)NCK_COUNTS_PER_DEG;
    TOLD(check, &self, rotary_rows);
}

static const told_row_t a_rows[] = {
    {"G0 X30. Z2. S500 M3\nG32 Z-10.\nG32 W-.5 F.1\nG32 U1. W-.4 F.1\nG32 Z-9. Q360000 F1.\n"
     "G32 Z-8. Q359999 F1.\nG32 Z-7. Q0\nZ-6.\nG0 X30. Z0.\nG92 X28. Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 32/0;"
     " 3 thread Z1.5 of 0.5 lead 0.1 for 0.6796; 4 thread X15.5 Z1.1 of 0.5 lead 0.1 for 0.6822;"
     " 5 thread Z-9 of 10.1 lead 1 for 1.334; 6 thread Z-8 of 1 lead 1 at 0.999997 for 0.2421;"
     " 7 thread Z-7 of 1 lead 1 for 0.2421; 8 thread Z-6 of 1 lead 1 for 0.2421; 9 rapid X15 Z0;"
     " 10 rapid~ X14; 10 thread Z-10 of 10 lead 1 for 1.322; 10 rapid~ X15; 10 rapid~ Z0"},
    {"G0 X30. Z2. S500 M3\nG92 X28. Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 92/0"},
};

static const told_row_t b_rows[] = {
    {"G0 X30. Z2. S500 M3\nG33 Z-10.\nG33 Z-9. F1.\nG78 X28. Z-10. F.5\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 33/0;"
     " 3 thread Z-9 of 11 lead 1 for 1.442; 4 rapid~ X14; 4 thread Z-10 of 1 lead 0.5 for 0.3439;"
     " 4 rapid~ X15; 4 rapid~ Z-9"},
    {"G0 X30. Z2. S500 M3\nG78 X28. Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 78/0"},
};

static const told_row_t c_rows[] = {
    {"G0 X30. Z2. S500 M3\nG33 Z-10.\nG33 Z-9. F1.\nG21 X28. Z-10. F.5\nG78 X28.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 33/0;"
     " 3 thread Z-9 of 11 lead 1 for 1.442; 4 rapid~ X14; 4 thread Z-10 of 1 lead 0.5 for 0.3439;"
     " 4 rapid~ X15; 4 rapid~ Z-9; !5:1 word-missing Z 78/0"},
    {"G0 X30. Z2. S500 M3\nG21 X28. Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 21/0"},
};

static void a_lead_counts_along_the_axis_that_moves_further(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, a_rows);
    self.machine.dialect.system = NCK_SYSTEM_B;
    TOLD(check, &self, b_rows);
    self.machine.dialect.system = NCK_SYSTEM_C;
    TOLD(check, &self, c_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, passes_and_taps_end_within_the_travel);
    CHECK_RUN(&check, what_stands_beyond_the_travel_may_stay);
    CHECK_RUN(&check, a_way_of_no_length_is_none);
    CHECK_RUN(&check, what_a_thread_leaves_unsaid_is_told);
    CHECK_RUN(&check, a_spindle_turns_as_fast_as_the_axes_can_follow);
    CHECK_RUN(&check, no_rotary_axis_has_a_lead);
    CHECK_RUN(&check, a_lead_counts_along_the_axis_that_moves_further);
    return check_end(&check);
}
