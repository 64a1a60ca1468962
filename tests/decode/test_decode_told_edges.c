// SPDX-License-Identifier: MIT
// Room 1: arcs at the ends of the travel, remarks, knots, systems of a lathe.
#include "told_check.h"

static told_t self;

static const told_row_t bulges_rows[] = {
    {"F9 G0 X90 Y0\nG3 X90 Y30 J15\nG0 X90 Y0\nG2 X90 Y30 J15\nG0 X90 Y190\nG2 X98 Y190 I4\n"
     "G2 X70 Y190 I-14\nG0 X0 Y0\nG2 X0 Y19 J9.5\nG2 X0 Y0 R10.5\nG3 X0 Y-19 J-9.5\n"
     "G3 X19 Y-19 I9.5\nG0 X95 Y50\nG2 I-5\nG2 I5\nG2 I-53\nG3 J75\nG3 J-36\nG18 G0 X50 Z40\n"
     "G2 X70 Z40 I10\nG3 X50 Z40 I-10\nG2 X74 I12\nG0 X90 Z0\nG2 Z10 K5\nG3 Z0 K-5\n"
     "G2 Z30 K15\nG0 X10 Z-20\nG3 X32 Z-20 I11\nG2 X10 Z-20 I-11\nG19 G0 Y190 Z0\nG3 Z15 K7.5\n"
     "G3 Z30 K7.5\nG3 Z52 K11\nG0 Y-15 Z0\nG2 Z8 K4\nG2 Z20 K6\nG17 G43.1 X5 Y5\nG0 X80 Y100\n"
     "G3 X80 Y130 J15\nG2 X80 Y100 J-15\nG3 X80 Y128 J14 P2 Z5\n",
     "1 rapid X90; !2:4 travel X 105/100; 3 rapid; 4 arc Y30 G17 about 90 15 by -180 F9;"
     " 5 rapid Y190; 6 arc X98 G17 about 94 190 by -180; 7 arc X70 G17 about 84 190 by -180;"
     " 8 rapid X0 Y0; 9 arc Y19 G17 about 0 9.5 by -180;"
     " 10 arc Y0 G17 about -4.47214 9.5 by -129.5825; 11 arc Y-19 G17 about 0 -9.5 by 180;"
     " !12:8 travel Y -28.5/-20; 13 rapid X95 Y50; 14 arc G17 about 90 50 by -360;"
     " !15:0 travel X 105/100; !16:0 travel X -11/-10; !17:0 travel X 170/100;"
     " !18:0 travel X 131/100; 19 rapid X50 Z40; 20 arc X70 G18 about 40 60 by -180;"
     " 21 arc X50 G18 about 40 60 by 180; 22 arc X74 G18 about 40 62 by -180; 23 rapid X90 Z0;"
     " 24 arc Z10 G18 about 5 90 by -180; 25 arc Z0 G18 about 5 90 by 180;"
     " !26:0 travel X 105/100; 27 rapid X10 Z-20; 28 arc X32 G18 about -20 21 by 180;"
     " 29 arc X10 G18 about -20 21 by -180; 30 rapid Y190 Z0;"
     " 31 arc Z15 G19 about 190 7.5 by 180; 32 arc Z30 G19 about 190 22.5 by 180;"
     " !33:4 travel Z 52/50; 34 rapid Y-15 Z0; 35 arc Z8 G19 about -15 4 by -180;"
     " !36:0 travel Y -21/-20; 38 rapid X80 Y100 Z20 tool X5 tool Y5;"
     " 39 arc Y130 G17 about 80 115 by 180; 40 arc Y100 G17 about 80 115 by -180;"
     " 41 arc Y128 Z5 G17 about 80 114 by 540"},
};

static void no_arc_leaves_the_travel(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    TOLD(check, &self, bulges_rows);
}

static const told_row_t excuses_rows[] = {
    {"G1 X1 F!\nX2\nG1 X3 F5\n",
     "!1:7 number F; 3 line X3 F5"},
    {"G1 X1 Q1\nX2\nF9 X3\n",
     "!1:7 word-unused Q"},
    {"G1 X1 Q1 (F5)\nX2\n",
     "!1:7 word-unused Q"},
    {"G1 X1 Q1 ; F5\nX2\n",
     "!1:7 word-unused Q"},
    {"G1 X1 (a) F5 Q1\nX2\n",
     "!1:14 word-unused Q"},
    {"G95 F1 G1 S! M3\nX1\n",
     "!1:11 number S"},
    {"G95 F1 G1 M3 Q5\nX1\n",
     "!1:14 word-unused Q"},
    {"G0! X1\nX2\nG0 X3\n",
     "!1:3 character 33/0; 3 rapid X3"},
    {"Q5\nX1\n",
     "!1:1 word-unused Q; !2:1 no-motion X"},
    {"G80 Q1\nX2\n",
     "!1:5 word-unused Q"},
    {"G43 Q1\nX2\nFOO\nX3\n",
     "!1:5 word-unused Q; !3:2 expression"},
    {"G1 f5 q1\nX5\ng94 X6\n",
     "!1:7 word-unused Q"},
    {"F5 G1 X1\nG93 X2\nX3\nG94 X4\nG95 X5\nX6\n",
     "1 line X1 F5; !2:0 feed-missing F; !4:0 feed-missing F; !5:0 feed-missing F"},
    {"SIN 5\nG1 X5\n",
     "!1:2 expression; !2:0 feed-missing F"},
};

static void one_mistake_is_one_finding(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, excuses_rows);
}

static const told_row_t remarks_rows[] = {
    {"N5 (abort, x)\nG0 X1\n",
     "?1:4 abort (; 1 end M2"},
    {"N 10 (ABORT, x)\nG0 X1\n",
     "?1:6 abort (; 1 end M2"},
    {"n10 ( a b o r t , x)\nG0 X1\n",
     "2 rapid X1"},
    {" (abort)\nG0 X1\n",
     "2 rapid X1"},
    {"G0 X1 (abort, x)\nX2\n",
     "?1:7 abort (; 1 end M2"},
    {"(abortx, y)\nG0 X1\n",
     "2 rapid X1"},
    {"/(abort, x)\nG0 X1\n",
     "?1:2 abort (; 1 end M2"},
    {"(a(b)\nG0 X1\n(a\nX2\n(a) (b) X3 (c)\nX4 (a) ; (b\n(msg,a) X5\n;(abort, x)\nX6\n()X7()\n"
     "(;) X8\n; ( X9\nX9 (\nX10\n",
     "!1:3 comment (; 2 rapid X1; !3:1 comment; 4 rapid X2; 5 rapid X3; 6 rapid X4; 7 rapid X5;"
     " 9 rapid X6; 10 rapid X7; 11 rapid X8; !13:4 comment; 14 rapid X10"},
    {"#1=5 (debug, #1)\nG0 X#1 (print, #1)\n(log, #1)\n(logopen, x)\n(probeopen x)\n(py, x)\n"
     "X6\n",
     "2 rapid X5; 7 rapid X6"},
};

static void a_remark_is_no_word(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, remarks_rows);
}

static const told_row_t fremarks_rows[] = {
    {"(a(b)\nG0 X1.\n(abort, x)\nX2.\n(a ) b)\nX3.\n(x) X4. (y) Y5.\n;X5.\nX6. ; Y7.\n<a>\n"
     "\"x\"\nX7.\n",
     "2 rapid X1; 4 rapid X2; !5:6 number B; 6 rapid X3; 7 rapid X4 Y5; 9 rapid X6;"
     " !11:1 character 34/0; 12 rapid X7"},
};

static void a_remark_of_fanucs_is_no_word(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, fremarks_rows);
}

static const told_row_t fknots_rows[] = {
    {"G6.2 P3 K0. Z0. Y0. X0. F9.\nK0. X2. Y2. Z1.\nK1. X4. Y0. Z2.\nK2. X6. Y2. Z3.\nK2.\n"
     "K2.\nK2.\n",
     "!7:1 spline K"},
    {"G6.2 P3 K0. X0. F9.\nK0. X2.\nK1. X4.\nK1.\nK1.\n",
     "!1:1 spline M 6.2/0"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK0. X2. Y2.\nK0. X4. Y0.\nK1. X5.\n",
     "!4:0 word-missing Y 6.2/0"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK0. X2. Y2.\nK0. X4. Y0.\nK1.\nK1. X5. Y1.\n",
     "!5:1 spline K"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK0. X2. Y2. R1001.\nK0. X4. Y0. R1000001.\n",
     "!3:13 number-range R 1000001/1000000"},
    {"G6.2 P3 K0. X0. Y0.\nK0. X2. Y2.\nK0. X4. Y0.\nK1.\nK1.\nK1.\n",
     "!6:0 feed-missing F"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK1. X2. Y2.\nK1. X4. Y0.\nK2.\nK2.\nK2.\n",
     "!6:1 spline K"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK0. X2. Y2.\nK0. X4. Y0.\nK1.\nK1.\nK2.\n",
     "!6:1 spline K"},
    {"G6.2 P3 K0. X0. Y0. F9.\nK0. X2. Y2.\nK0. X4. Y0.\nK0.\nK0.\nK0.\n",
     "!6:1 spline K"},
    {"G6.2 P2 K0. X0. Y0. R2. F9.\nK0. X2. Y2. R1.\nK1.\nK1.\nG0 X5.\nK1.\n",
     "4 line X2 Y2 F9; 5 rapid X5; !6:1 word-unused K"},
    {"G17 G41 D1\nG6.2 P2 K0. X0. Y0. R2. F9.\n",
     "?1:9 assumed-length D 1/0; !2:0 comp-on G 6.2/0"},
    {"G18 G6.2 P2 K0. X0. Y0. F9.\nK0. X2. Y2.\nK1.\nK1.\n",
     "4 line X2 Y2 F9"},
    {"G6.2 P2 K0. X0. Y0. A1. F9.\n",
     "!1:21 axis-unknown A"},
    {"G6.2 P2 K0. X1. Y0. F9.\nK0. X2. Y2.\nK1.\nK1.\n",
     "!1:6 spline P 6.2/0"},
    {"G0 X5. Y5. Z5.\nG6.2 P2 K0. X5. Y5. Z5. F9.\nK0. X7. Y9. Z6.\nK.5 X9. Y5. Z5.\nK1.\nK1.\n"
     "Y0\n",
     "1 rapid X5 Y5 Z5; 6 line X7 Y9 Z6 F9; 6 line X9 Y5 Z5; !7:0 spline K"},
    {"G6.2 P2 K0. X0. Y0. F9.\nK0. X2. Y2.\nK1. M8\nK1.\n",
     "3 out M8; 4 line X2 Y2 F9"},
    {"G6.2 P2 K0. X0. Y0. F9.\nF10.\nK0. X2. Y2. F20.\nK1.\nK1.\n",
     "5 line X2 Y2 F20"},
};

static void knots_say_where_a_spline_goes(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.path.chord_error = 0.5;
    TOLD(check, &self, fknots_rows);
}

static const told_row_t systems_rows[] = {
    {"G90 G0 X10. Z5.\nG91 X2. Z-1.\nG90 G77 X8. Z-5. F.1\nG78 X8. Z-5. F1.\nG79 X4. Z-2.\n"
     "G94 F100. G1 X20.\nG95 F.2 X22.\nS9 M3 X24.\nG77 X8. Z-5.\nG78 X8. Z-5. F1.\n"
     "G79 X4. Z-2.\nG92 X5.\nG0 X5.\nG92 S50\nG98\nG99\nG81 Z-9. R1. F1.\nG20\nG70\nG71\nG21\n"
     "G72\nG76\nG33 Z-9. F1.\nG32 Z-9. F1.\nG50\nG50 S5\nU1. W1.\nG28 U0\nG90 G28 X0\nG74 R1.\n"
     "G75 R1.\nG73 U1. W1. R2\nG24 X1. Z1.\n",
     "1 rapid X5 Z5 per-rev; 2 rapid X6 Z4; !3:0 feed-missing S; !4:1 thread-speed S;"
     " 6 line X10 F100 per-min; 8 out S9 X11 per-rev; 8 out M3 S9; 8 line X12 F0.2;"
     " 9 rapid~ X4; 9 line~ Z-5; 9 line~ X12; 9 rapid~ Z4; 10 rapid~ X4;"
     " 10 thread Z-5 of 9 lead 1 for 63.34; 10 rapid~ X12; 10 rapid~ Z4; 11 rapid~ Z-2;"
     " 11 line~ X2 F1; 11 line~ Z4; 11 rapid~ X12; 13 rapid axis9.5; "
     "  !17:1 unsupported G 81/0; !19:1 word-missing P;"
     " 24 thread Z-9 of 13 lead 1 for 90.01; !25:1 other-base G 32/16;"
     " !26:1 unsupported G 50/0; !27:1 unsupported G 50/0; !28:1 axis-unknown U;"
     " !29:5 axis-unknown U; 30 rapid X9.5; 30 rapid X0; !34:1 g-unknown G 24/0"},
};

static void system_b_has_its_codes(check_t *check) {
    told_turning(&self);
    self.machine.dialect.system = NCK_SYSTEM_B;
    TOLD(check, &self, systems_rows);
}

static const told_row_t systems_c_rows[] = {
    {"G90 G0 X10. Z5.\nG91 X2. Z-1.\nG90 G77 X8. Z-5. F.1\nG78 X8. Z-5. F1.\nG79 X4. Z-2.\n"
     "G94 F100. G1 X20.\nG95 F.2 X22.\nS9 M3 X24.\nG77 X8. Z-5.\nG78 X8. Z-5. F1.\n"
     "G79 X4. Z-2.\nG92 X5.\nG0 X5.\nG92 S50\nG98\nG99\nG81 Z-9. R1. F1.\nG20\nG70\nG71\nG21\n"
     "G72\nG76\nG33 Z-9. F1.\nG32 Z-9. F1.\nG50\nG50 S5\nU1. W1.\nG28 U0\nG90 G28 X0\nG74 R1.\n"
     "G75 R1.\nG73 U1. W1. R2\nG24 X1. Z1.\n",
     "1 rapid X5 Z5 per-rev; 2 rapid X6 Z4; !3:5 word-missing P 75/0; !4:1 word-missing P 78/0;"
     " !5:1 unsupported G 79/0; 6 line X10 F100 per-min; !7:0 feed-missing S;"
     " 8 out S9 X11 per-rev; 8 out M3 S9; 8 line X12 F0.2; !9:1 word-missing P 75/0;"
     " !10:1 word-missing P 78/0; !11:1 unsupported G 79/0; 13 rapid axis9.5;"
     "   !17:1 unsupported G 81/0;"
     " !21:1 word-missing X 21/0; !22:1 word-missing P; !23:1 word-missing R 74/0;"
     " 24 thread Z-9 of 13 lead 1 for 90.01; !25:1 other-base G 32/16;"
     " !26:1 unsupported G 50/0; !27:1 unsupported G 50/0; !28:1 axis-unknown U;"
     " !29:5 axis-unknown U; 30 rapid X9.5; 30 rapid X0; !32:5 number-range R 1/2;"
     " !33:9 word-unused W; 34 rapid~ Z1; 34 line~ X10 F1; 34 line~ Z-9; 34 rapid~ X0"},
};

static void system_c_has_its_codes(check_t *check) {
    told_turning(&self);
    self.machine.dialect.system = NCK_SYSTEM_C;
    TOLD(check, &self, systems_c_rows);
}

static const told_row_t subs2_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 entry 0 stop P0 Q0; 2 entry 1; 2 entry 2 F100;"
     " 2 rapid X3 smooth P0.01 Q0.01; 3 line Z-1 F9; 4 line Z1; 2 rapid X5; 3 line Z-1;"
     " 4 line Z1; 11 line X7; 11 line X8; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_2(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 2;
    TOLD(check, &self, subs2_rows);
}

static const told_row_t subs4_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 rapid X3; 3 line Z-1 F9; 4 entry 0 stop P0 Q0; 4 entry 1; 4 entry 2 F100;"
     " 4 line Z1 F9 smooth P0.01 Q0.01; 2 rapid X5; 3 line Z-1; 4 line Z1; 11 line X7;"
     " 11 line X8; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_4(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 4;
    TOLD(check, &self, subs4_rows);
}

static const told_row_t subs7_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 7 entry 0 stop P0 Q0; 7 entry 1; 7 entry 2 F100;"
     " 2 rapid X3 smooth P0.01 Q0.01; 3 line Z-1 F9; 4 line Z1; 2 rapid X5; 3 line Z-1;"
     " 4 line Z1; 11 line X7; 11 line X8; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_7(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 7;
    TOLD(check, &self, subs7_rows);
}

static const told_row_t subs8_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 rapid X3; 3 line Z-1 F9; 4 line Z1; 8 entry 0 stop P0 Q0; 8 entry 1;"
     " 8 entry 2 F100; 2 rapid X5 smooth P0.01 Q0.01; 3 line Z-1 F9; 4 line Z1; 11 line X7;"
     " 11 line X8; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_8(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 8;
    TOLD(check, &self, subs8_rows);
}

static const told_row_t subs11_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 rapid X3; 3 line Z-1 F9; 4 line Z1; 2 rapid X5; 3 line Z-1; 4 line Z1;"
     " 11 entry 0 stop P0 Q0; 11 entry 1; 11 entry 2 F100; 11 line X7 F9 smooth P0.01 Q0.01;"
     " 11 line X8; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_11(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 11;
    TOLD(check, &self, subs11_rows);
}

static const told_row_t subs12_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 rapid X3; 3 line Z-1 F9; 4 line Z1; 2 rapid X5; 3 line Z-1; 4 line Z1;"
     " 11 line X7; 12 entry 0 stop P0 Q0; 12 entry 1; 12 entry 2 F100;"
     " 11 line X8 F9 smooth P0.01 Q0.01; 14 line Z9; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_12(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 12;
    TOLD(check, &self, subs12_rows);
}

static const told_row_t subs14_rows[] = {
    {"o1 sub\nG0 X#1\nG1 Z-1 F9\nZ1\no1 endsub\nG0 Z5\no1 call [3]\no1 call [5]\n#1=7\n"
     "o2 repeat [2]\nX#1\n#1=[#1+1]\no2 endrepeat\nZ9\nM2\n",
     "6 rapid Z5; 2 rapid X3; 3 line Z-1 F9; 4 line Z1; 2 rapid X5; 3 line Z-1; 4 line Z1;"
     " 11 line X7; 11 line X8; 14 entry 0 stop P0 Q0; 14 entry 1; 14 entry 2 F100;"
     " 14 line Z9 F9 smooth P0.01 Q0.01; 15 end M2"},
};

static void a_program_with_calls_begins_at_line_14(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 14;
    TOLD(check, &self, subs14_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, no_arc_leaves_the_travel);
    CHECK_RUN(&check, one_mistake_is_one_finding);
    CHECK_RUN(&check, a_remark_is_no_word);
    CHECK_RUN(&check, a_remark_of_fanucs_is_no_word);
    CHECK_RUN(&check, knots_say_where_a_spline_goes);
    CHECK_RUN(&check, system_b_has_its_codes);
    CHECK_RUN(&check, system_c_has_its_codes);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_2);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_4);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_7);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_8);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_11);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_12);
    CHECK_RUN(&check, a_program_with_calls_begins_at_line_14);
    return check_end(&check);
}
