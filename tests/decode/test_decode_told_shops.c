// SPDX-License-Identifier: MIT
// Room 1: words of shops: modes of a control, further work systems, slashes, printers' codes.
#include "told_check.h"

static told_t self;

static const told_row_t modes_rows[] = {
    {"G5 P10000\nG1 X1. F100.\nG5 P0\nG62\nG61\nX2.\nG61.1\nX3.\nG187 P2 E.2\nX4.\nG187\nX5.\n"
     "G187 P1\nG05.1 Q1\nG8 P1\nG5\nG5.1\nG5.1 Q1 X9.\nG187 E-1.\nG13.1 G23\nX6.\nG10.9\n"
     "G10.9 X1.\nX7.\n",
     "?1:1 mode-stays G 5/0; 2 line X1 F100; ?4:1 mode-stays G 62/0;"
     " 6 line X2 stop P0 Q0; ?7:1 mode-stays G 61.1/0; 8 line X3 smooth P0.01 Q0.01;"
     " 10 line X4 P0.2 Q0.2; 12 line X5 P0.01 Q0.01; ?13:1 mode-stays G 187/0;"
     " ?14:1 mode-stays G 5.1/0; ?15:1 mode-stays G 8/0; !16:1 word-missing P;"
     " !17:1 word-missing Q; !18:9 word-unused X; !19:6 number-range E -1/0; 21 line X6;"
     " !23:7 word-unused X; 24 line X7"},
};

static const told_row_t dwells_rows[] = {
    {"G4 P2.\nG4 P2000\nG4 P.5\nG4 X2.\n#1=3\nG4 P#1\nG82 X1. Z-1. R1. P1.5 F60.\nP1500 X2.\nG80\n"
     "G4 P2000000.\nG4 P-1.\n",
     "1 dwell for 2; 2 dwell for 2; 3 dwell for 0.5; 4 dwell for 2; 6 dwell for 0.003;"
     " 7 rapid~ Z1; 7 rapid~ X1; 7 line~ Z-1 F60; 7 dwell for 1.5; 7 rapid~ Z1;"
     " 8 rapid~ X2; 8 line~ Z-1; 8 dwell for 1.5; 8 rapid~ Z1;"
     " !10:4 number-range P 2000000/1000000; !11:4 number-range P -1/1000000"},
    {"G4 X#3007\nG4 X[#3008+1]\nG4 X#4014\nG59\nG4 X#4014\nG54.1 P2\nG4 X#4014\nG4 X#4010\nG99\n"
     "G4 X#4010\n#3007=1\nG4 X#3005\nG4 X#3009\n",
     "1 dwell for 0; 2 dwell for 1; 3 dwell for 54; 5 dwell for 59; 7 dwell for 54.1; 8 dwell for"
     " 98; 10 dwell for 99; !11:1 unsupported # 3007/0; !12:10 unsupported # 3005/0;"
     " !13:10 unsupported # 3009/0"},
};

static void points_of_dwells_and_parameters_of_the_control(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, dwells_rows);
}

static void modes_are_noted_once(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, modes_rows);
}

static const told_row_t explained_rows[] = {
    {"G5.1 Q1\nG1 X1. F100.\nG5.1 Q2\nX2.\nG5.1 Q0\nX3.\nG61\nG5.1 Q1\nX4.\nG64\nX5.\nG103 P1\n"
     "G103 X1.\nG103 M8\nX6.\n",
     "2 line X1 F100 P0.05 Q0.05; ?3:1 mode-stays G 5.1/0; 4 line X2; 6 line X3 P0.01 Q0.01; 9"
     " line X4 stop P0 Q0; 11 line X5 smooth P0.05 Q0.05; !13:6 word-unused X; 14 out M8; 15"
     " line X6 P0.01 Q0.01"},
};

static void a_machine_explains_its_modes(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.own_g_count = 2;
    self.machine.own_g[0] = (nck_own_g_t){0.05, 1, 51, 'Q', NCK_G_TOLERANCE};
    self.machine.own_g[1] = (nck_own_g_t){0.0, 0, 1030, 0, NCK_G_IGNORE};
    TOLD(check, &self, explained_rows);
}

static const told_row_t systems_rows[] = {
    {"G54.1 P3\nG0 X1.\nG54 P4\nX1.\nG112 X1.\nG112\nG116\nX1.\nG54\nX1.\nG10 L20 P4 X50. Y2.\n"
     "G154 P4\nX1. Y1.\nG91 G10 L20 P4 X5.\nG90 X1.\nG54.1\nG54.1 P0\nG154 P100\nG54.1 P300\nX1.\n"
     "G10 L20 P301 X1.\nG10 L20 P1 X1. R1.\nG54.1 P1.5\nG54.1 G4 P5\n",
     "2 rapid X31; 4 rapid X1; !5:1 unsupported G 112/0; !6:1 unsupported G 112/0; 8 rapid;"
     " 10 rapid; 13 rapid X51 Y3; 15 rapid X56; !16:1 word-missing P; !17:7 number-range P 0/300;"
     " !18:6 number-range P 100/99; 20 rapid X1; !21:9 number-range P 301/300;"
     " !22:16 word-unused R; !23:7 number-range P 1.5/300; !24:10 word-shared P"},
};

static void further_systems_have_their_zeros(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.work_more_count = 1;
    self.machine.work_more[0].number = 3;
    self.machine.work_more[0].zero_nm[0] = 30000000;
    TOLD(check, &self, systems_rows);
}

static const told_row_t slash_rows[] = {
    {"G0 X1. /Y1.\nX2. /2 Y2.\nX3. / 2 Y3.\n/X4.\n/2 X5.\n/ 2 X6.\n/3 X7. /Y7.\nX8. /3/2 Y8.\n",
     "1 rapid X1 Y1; 2 rapid X2; 3 rapid X3; 4 rapid X4; 7 rapid X7 Y7; 8 rapid X8"},
};

static void a_switch_skips_lines_and_what_stands_behind(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.dialect.skip_switches = 1u << 2;
    TOLD(check, &self, slash_rows);
}

static const told_row_t drill_rows[] = {
    {"G1 F100. X1.\nG99 G83 Z-3. R1. Q3. P500\nG80 X5.\nX6.\nG81 Z-1. R1.\nG80\nX7.\nG2 X9. R1.\n"
     "G81 Z-1. R1.\nG80\nG0 X0.\nG83 Z-3. R1. Q3000\nG80\n#3001=0 #3004=7\nX1. #3003=1\n"
     "#100=#3001\nX#3003 Y#3004\n",
     "1 line X1 F100; 2 rapid~ Z1; 2 line~ Z-2; 2 rapid~ Z1; 2 rapid~ Z-1.746; 2 line~ Z-3;"
     " 2 dwell for 0.5; 2 rapid~ Z1; 3 line X5; 4 line X6; 5 line~ Z-1; 5 rapid~ Z1;"
     " 7 line X7; 8 arc X9 G17 about 8 0 by -180; 9 line~ Z-1; 9 rapid~ Z1; 11 rapid X0;"
     " !12:14 scale-unit Q 3000/0; 15 rapid X1; ?16:0 timer-read # 3001/0; 17 rapid Y7"},
    {"G31 X5. F100.\n#100=#5061\nG0 X[#100+1.]\nG31 Z-1.\nX1.\nG31\nX2.\n",
     "1 line X5 F100 stop; 3 rapid X6 smooth; 4 line Z-1 stop; 5 rapid X1 smooth;"
     " !6:1 word-missing X 31/0"},
    {"G41 H1 G1 X9. F100.\nG40 X0.\nG43 H2 G41 D1 X9.\nG40 X0.\nG41 H9\n",
     "1 comp G17 3.5 nose 0 0; 1 line X9 F100; 2 comp G17 0 nose 0 0; 2 line X0;"
     " 3 comp G17 3.5 nose 0 0; 3 line X9 Y-2 Z-20 tool X1 tool Y2 tool Z20;"
     " 4 comp G17 0 nose 0 0; 4 line X0; !5:5 tool-unknown H 9/0"},
};

static void cycles_and_probes_of_mills(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    told_tools(&self);
    self.machine.dialect.probe = NCK_PROBE_MISSES;
    TOLD(check, &self, drill_rows);
}

static const told_row_t clock_rows[] = {
    {"#100=#3001 #101=#3001\nG0 X#3001 Y#101\n#3001=90\nN4 IF[#3001LT95]GOTO4\nX#3001\n"
     "#3001=#0\nX#3001 Y[#3012+1] Z[#3011-20000100]\n#3002=2\nX#3002\n",
     "?1:0 timer-read # 3001/0; 2 rapid X1; 5 rapid X96; ?7:0 assumed-clock # 3012/0;"
     " 7 rapid X0 Y1 Z1; 9 rapid X2"},
};

static const told_row_t said_clock_rows[] = {
    {"G0 X#3001 Y#3002 Z[#3011-20301200]\nX[#3012-235900]\nX#3001\n#3001=#3001-50\nX#3001\n",
     "?1:0 timer-read # 3001/0; 1 rapid X50 Y1.5 Z31; 2 rapid X58; 3 rapid X51; 5 rapid X2"},
};

static void clocks_tell_what_the_machine_knows(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, clock_rows);
    NCK_IF_VARIABLES(self.machine.clock = (nck_wall_clock_t){20301231, 235958, 50, 5400};)
    TOLD(check, &self, said_clock_rows);
}

static const told_row_t printer_rows[] = {
    {"M84 X Y E\nM73 P5 R2\nM115 U3.11.0\nM862.3 P \"MK3S\"\nM862.7\nM862\nG28 W\nG29 A\nG10\n"
     "G28 X Y\nM300 S40 P10\nM600\nM0 wait for me\nG28 Z W ; home\n",
     "1 out M84; 2 out M73; 3 out M115; 4 out M862; !5:1 m-unknown M 862.7/0;"
     " !6:1 m-unknown M 862/0; 7 rapid; 7 rapid; ?8:1 mode-stays G 29/0;"
     " ?9:1 mode-stays G 10/0; 10 rapid; 10 rapid;"
     " 11 out M300; 12 wait M600; 13 wait M0; 14 rapid; 14 rapid"},
    {"N1 G0 X1*97\nN2 G0 X2*96\nN3 M117 50*2 of it*\nG0 X3*\nG0 X4 *5 X6\n",
     "1 rapid X1; !2:9 number-range * 96/97; 3 out M117; !4:6 number *; !5:7 number *"},
    {"G28 O\nG28 O X R5 L\nG28 XR3Y\nM116\nG10 P0 S210 R180\nG11 P1\nM220 R\nM220 S80\nM220 B\n"
     "M220 S100\nM220 R\nM220 S50 B\nM220 R\nM220\nM220 S-1\nG92 O\nM221 B\n",
     "1 rapid; 1 rapid; 2 rapid; 2 rapid; 3 rapid; 3 rapid; 4 wait M116; !6:5 word-unused P;"
     " 8 out M220=80; 10 out M220=100; 11 out M220=80; 12 out M220=50; 13 out M220=80;"
     " !15:6 number-range S -1/10000; !16:6 other-base 0/7; !17:6 number B"},
};

static void printers_have_codes_that_move_nothing(check_t *check) {
    told_begin(&self, NCK_DIALECT_MARLIN);
    TOLD(check, &self, printer_rows);
}

static const told_row_t linuxcnc_rows[] = {
    {"o1 sub\no2 if [#1 gt 0]\no2 return [#1+1]\no2 end if\nG0 X9\no1 end sub [7]\no1 call [1]\n"
     "G0 X#<_value>\no1 c a l l [0]\nG0 Y#<_value>\n#5599=1\no3 re turn\n",
     "8 rapid X2; 5 rapid X9; 10 rapid Y7; !12:0 flow"},
    {"M61 Q3\nG0 X#5400\nM61\nM61 Q1.5\n#5598=1\n",
     "2 rapid X3; !3:1 word-missing Q; !4:5 number-range Q 1.5/1e+09; !5:1 unsupported # 5598/0"},
};

static void subprograms_end_by_any_return(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, linuxcnc_rows);
}

static const told_row_t overrides_rows[] = {
    {"M50 P0\nM50\nM51 P1\nM52 P0 G0 X1\nM53 P2\nM53 P.5\nM53 Q1\nM48 M50\n",
     "1 out M50=0; 2 out M50=1; 3 out M51=1; 4 out M52=0; 4 rapid X1; !5:5 number-range P 2/1;"
     " !6:5 number-range P 0.5/1; !7:5 word-unused Q; !8:5 modal-group M 50/0"},
};

static void overrides_are_switched_one_by_one(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, overrides_rows);
}

static const told_row_t lines_rows[] = {
    {"M97 P50 L2\nG0 X1.\nM97 P60\nM98 P8\nM30\nN50 G0 X2.\nM97 P60\nX3.\nM99\n"
     "N60 Y#1\n#1=#1+1\nIF[#1EQ2]GOTO60\nM99\nO8\nM97 P60 L2\nM99\nN60 Z1.\nM99\n",
     "6 rapid X2; 8 rapid X3; 6 rapid X2; 10 rapid Y1; 10 rapid Y2; 8 rapid X3; 2 rapid X1;"
     " 10 rapid Y3; 17 rapid Z1; 17 rapid; 5 end M30"},
    {"O1\nM97 P7\nM30\nO2\nN7 G0 X1.\nM99\n", "!2:0 label-missing 7/0; ?2:0 called-from"},
    {"M97\nM97 P0\nM97 P1.5\nM97 P123456 L0\nG0 X1.\nM97 P123456\nN123456 X2.\nM30\n",
     "!1:1 word-missing P; !2:1 word-missing P; !3:5 number-range P 1.5/99999999; 5 rapid X1;"
     " 7 rapid X2; 8 end M30"},
    {"G0 X1.\nM97 P3 X2.\nM30\nN1 X3.\nIF[#1EQ2]GOTO5\n#1=2\nN3 GOTO1\nN5 M99\n",
     "1 rapid X1; 2 rapid X2; 4 rapid X3; 4 rapid; 3 end M30"},
    {"GOTO60\nX7.\nN60 G0 X1.\nM98 P8\nM30\nO8\nGOTO60\nX9.\nN60 X3.\nM99\n",
     "3 rapid X1; 9 rapid X3; 5 end M30"},
};

static void lines_of_the_program_are_called(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, lines_rows);
}

static const told_row_t ends_rows[] = {
    {"G0 X-12 Y5 F600\nG91 G1 X-1\nG1 X5 Z-31 E1\nG90 G1 X101 Y201 Z51\nG1 X-99 F0\nX3 U2\n"
     "G28 X\nG92 X50\nG1 X-20\nM211 S0\nG1 X-20\nM211\nX-21\nM211 S1\nX-20\n",
     "?1:4 travel-end X -12/-10; 1 rapid X-10 Y5 F600; 2 line F600; 3 line X-5 Z-30 U1;"
     " 4 line X100 Y200 Z50; ?5:9 feed-kept F; 5 line X-10; 6 line X3 U2; 7 rapid; 7 rapid X0;"
     " 9 line X-10; ?10:0 ends-off; 10 out M211; 11 line X-70; 12 out M211; 13 line X-71;"
     " 14 out M211; 15 line X-10"},
};

static void a_printers_axes_stay_at_their_ends(check_t *check) {
    told_begin(&self, NCK_DIALECT_MARLIN);
    told_extruder(&self);
    told_bound(&self);
    TOLD(check, &self, ends_rows);
}

static const told_row_t polar_rows[] = {
    {"G0 @10 ^90\n^180\n@20\nG91 ^-90\n@-5\nG90 @2 X1\n@1 @2\nG92 X0 Y0\nG91 @1\n"
     "G90 G0 ^0\nG92.1 G0 X0 Y5\nG91 G81 ^90 Z-1 R0 L3\nG80\nG18 @1\nG18\n@1\n",
     "1 rapid Y10; 2 rapid X-10 Y0; 3 rapid X-20; 4 rapid X0 Y20; 5 rapid Y15;"
     " !6:5 word-shared @; !7:4 word-twice @; !9:5 value @; 10 rapid; 11 rapid Y5;"
     " 12 rapid~ X-5 Y0; 12 line~ Z-1; 12 rapid~ Z0; 12 rapid~ X0 Y-5; 12 line~ Z-1; 12 rapid~ Z0;"
     " 12 rapid~ X5 Y0; 12 line~ Z-1; 12 rapid~ Z0; !14:5 incremental @; !16:1 unsupported @"},
};

static void polar_words_are_places(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.dialect.feed_default = 9.0;
    TOLD(check, &self, polar_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, points_of_dwells_and_parameters_of_the_control);
    CHECK_RUN(&check, modes_are_noted_once);
    CHECK_RUN(&check, a_machine_explains_its_modes);
    CHECK_RUN(&check, further_systems_have_their_zeros);
    CHECK_RUN(&check, a_switch_skips_lines_and_what_stands_behind);
    CHECK_RUN(&check, cycles_and_probes_of_mills);
    CHECK_RUN(&check, clocks_tell_what_the_machine_knows);
    CHECK_RUN(&check, printers_have_codes_that_move_nothing);
    CHECK_RUN(&check, subprograms_end_by_any_return);
    CHECK_RUN(&check, overrides_are_switched_one_by_one);
    CHECK_RUN(&check, lines_of_the_program_are_called);
    CHECK_RUN(&check, a_printers_axes_stay_at_their_ends);
    CHECK_RUN(&check, polar_words_are_places);
    return check_end(&check);
}
