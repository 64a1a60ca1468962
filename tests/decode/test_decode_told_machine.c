// SPDX-License-Identifier: MIT
// Room 1: what goes by the machine: travel, tools, ports, other languages, where a program begins.
#include "told_check.h"

static told_t self;

static const told_row_t bound_rows[] = {
    {"G0 X100 Y200 Z50\nX-10 Y-20 Z-30\nX100.000001\nY-20.000001\nX100 Z50.000001\nG91 X1\n"
     "G90 X0 Y0 Z0\nF100 G1 X-11\nX0\nG2 X20 R10\nG3 X0 R10\nG2 X40 I20\nX0 Y0\n"
     "G3 X0 Y39 J19.5\nG3 X0 Y0 J-19.5\nG0 X0 Y-15\nG3 X12 I6\nG3 X13 I.5\nG2 X2 I-5.5\n"
     "G2 I-5\nG2 I-6\nG2 I-6.5\nG10 L2 P1 X50\nG0 X50\nX50.5\nG43.1 Z20\nZ30\nZ30.5\n"
     "G18 G2 X30 Z30 I-10\nG53 G0 X100.5\nG28 X60\nG28 X0\nG81 X0 Y0 Z-51 R1\nG81 Z-50 R31\n"
     "G81 Z-50 R30\nG91 X30 L2\nG90 G81 X0 Y0 Z0 R1\nG0\n",
     "1 rapid X100 Y200 Z50; 2 rapid X-10 Y-20 Z-30; !3:1 travel X 100.000001/100;"
     " !4:1 travel Y -20.000001/-20; !5:6 travel Z 50.000001/50; !6:5 travel X 101/100;"
     " 7 rapid X0 Y0 Z0; !8:9 travel X -11/-10; 9 line F100; 10 arc X20 G17 about 10 0 by -180;"
     " 11 arc X0 G17 about 10 0 by 180; 12 arc X40 G17 about 20 0 by -180; !13:0 arc-centre;"
     " 14 arc X0 Y39 G17 about 0 19.5 by 180; !15:4 travel X -19.5/-10; 16 rapid Y-15;"
     " !17:0 travel Y -21/-20; 18 arc X13 G17 about 12.5 -15 by 180; !19:0 travel Y -20.5/-20;"
     " 20 arc X2 G17 about -3 -15 by -360; !21:0 travel Y -21/-20; !22:0 travel X -11/-10;"
     " 24 rapid X100; !25:1 travel X 100.5/100; 27 rapid X100.5 Z30 tool Z20;"
     " !28:1 travel Z 50.5/50; !29:5 arc-radius 10.511898/10; !30:8 travel X 100.5/100;"
     " !31:5 travel X 110/100; 32 rapid X50; 32 rapid X0; !33:11 travel Z -31/-30;"
     " 34 rapid~ Y31; 34 rapid~ Z-50; 34 line~ Y0; 34 rapid~ Y31; 35 rapid~ Y30; 35 line~ Y0;"
     " 35 rapid~ Y30; 36 rapid~ X30; 36 rapid~ Y15; 36 line~; 36 rapid~ X60; 36 line~;"
     " 37 rapid~ X50 Z0; 37 rapid~ Y1; 37 line~ Y0; 37 rapid~ Y1"},
};

static void nothing_leaves_the_travel(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    TOLD(check, &self, bound_rows);
}

static const told_row_t tools_rows[] = {
    {"T1 M6 G43\nG0 Z5\nG43 H2\nZ5\nG49\nZ5\nG43 H0\nG43 H1\nG43.2 H2\nZ5\nG43 H9\nT9 M6\n"
     "T2 M6 G43 G0 X0 Y0 Z0\nT7\nG43 G0 X1\n",
     "1 out T1; 1 out M5; 1 wait M6; 2 rapid Z5 tool Z10;"
     " 4 rapid X-1 Y-2 tool X1 tool Y2 tool Z20; 6 rapid X0 Y0 tool X0 tool Y0 tool Z0;"
     " 10 rapid X-1 Y-2 tool X1 tool Y2 tool Z30; !11:5 tool-unknown H 9/0;"
     " !12:1 tool-unknown T 9/0; 13 out T2; 13 out M5; 13 wait M6; 13 rapid X0 Y0 Z0 tool Z20;"
     " 14 out T7; 15 rapid X1"},
    {"G41 D1 F100\nG1 X10\nG40\nX11\nG42 D1\nG40\nG41 D8\nG40\nG42.1 D8\nG40\nG42.1 D-4\n"
     "G41 D7\nG40\nG41.1 D5 L3\nG18 G41.1 D5 L3\nG40\nG17 G41 D2\nG41\nG40\nT1 M6\nG41\nG40\n"
     "T1.5\nG41 D-1\nG41.1\nG41.1 D5 L-1\nG41.1 D5 L1.5\nG41.1 D0\nG41 D0\nG42 D0\nG40 D1\n"
     "G41.1 D2000001\n",
     "1 comp G17 3.5 nose 0 0; 2 line X10 F100; 3 comp G17 0 nose 0 0; 4 line X11;"
     " 5 comp G17 -3.5 nose 0 0; 6 comp G17 0 nose 0 0; 7 comp G17 1.75 nose 0 0;"
     " 8 comp G17 0 nose 0 0; 9 comp G17 -4 nose 0 0; 10 comp G17 0 nose 0 0;"
     " 11 comp G17 2 nose 0 0; !12:1 comp-on G 41/0; 13 comp G17 0 nose 0 0;"
     " !14:1 comp-plane G 3/0; 15 comp G18 2.5 nose -2.5 2.5; 16 comp G18 0 nose 0 0;"
     " !18:1 comp-on G 41/0; 20 out T1; 20 out M5; 20 wait M6; 21 comp G17 3.5 nose 0 0;"
     " 22 comp G17 0 nose 0 0; !23:1 number-range T 1.5/1e+09; !24:5 number-range D -1/1e+09;"
     " !25:1 word-missing D; !26:10 number-range L -1/9; !27:10 number-range L 1.5/9;"
     " !29:1 comp-on G 41/0; !30:1 comp-on G 42/0; !31:5 word-unused D; !32:1 comp-on G 41.1/0"},
    {"G10 L1 P1 Z5 R2\nG10 L1 P2 X1 Y2 Z3\nG43 H1 G0 Z0\nG43 H2 X0 Y0 Z0\nG41 D1\nG40\n"
     "G10 L10 P1 Z7\nG43 H1 Z1\nG10 L11 P1 Z7\nG43 H1 Z1\nG10 L1 P1 R-1\nG10 L1 P7 Q10\n"
     "G10 L1 P7 Q5 R1.5\nG18 G41 D7\nG40\n",
     "3 rapid tool Z5; 4 rapid tool X1 tool Y2 tool Z3; 5 comp G17 2.5 nose 0 0;"
     " 6 comp G17 0 nose 0 0; 8 rapid X1 Y2 Z1 tool X0 tool Y0 tool Z-4; 10 rapid tool Z-10;"
     " !12:11 number-range Q 10/9; 14 comp G18 1.5 nose 1.5 0; 15 comp G18 0 nose 0 0"},
    {"G41 D1 F100\nG17\nG18\nG54\nG43 H1\nG92 X1\nG28\nG53 G0 X1\nT2 M6\nG81 X1 Z-1 R1\n"
     "G10 L2 P1 X1\nG52 X1\nG33 Z1 K1\nM70\nG41 D8\nG5 X1 I1 J1 P1 Q1\nG2 X1 R5\nG40\n",
     "1 comp G17 3.5 nose 0 0; !3:1 comp-on G 18/0; !4:1 comp-on G 54/0; !5:1 comp-on G 43/0;"
     " !6:1 comp-on G 92/0; !7:1 comp-on G 28/0; !8:1 comp-on G 53/0; !9:4 comp-on M 6/0;"
     " !10:0 comp-on G 81/0; !11:1 comp-on G 10/0; !12:1 comp-on G 52/0; !13:0 comp-on G 33/0;"
     " !15:1 comp-on G 41/0; !16:0 comp-on G 5/0; !17:7 arc-centre R 5/0;"
     " 18 comp G17 0 nose 0 0 X1"},
};

static void tools_have_offsets_and_radii(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_tools(&self);
    TOLD(check, &self, tools_rows);
}

static const told_row_t lathetools_rows[] = {
    {"G41 D7 F100\nG40\nG42 D7\nG40\nG17 G41 D7\nG18 G41.1 D2 L1\nG40\nG41.1 D2 L2\nG40\n"
     "G41.1 D2 L3\nG40\nG41.1 D2 L4\nG40\nG41.1 D2 L5\nG40\nG41.1 D2 L6\nG40\nG41.1 D2 L7\n"
     "G40\nG41.1 D2 L8\nG40\nG41.1 D2 L9\nG40\nG41.1 D2 L10\n",
     "1 comp G18 0.8 nose -0.8 0.8; 2 comp G18 0 nose 0 0; 3 comp G18 -0.8 nose -0.8 0.8;"
     " 4 comp G18 0 nose 0 0; !5:5 comp-plane G 3/0; 6 comp G18 1 nose 1 -1;"
     " 7 comp G18 0 nose 0 0; 8 comp G18 1 nose -1 -1; 9 comp G18 0 nose 0 0;"
     " 10 comp G18 1 nose -1 1; 11 comp G18 0 nose 0 0; 12 comp G18 1 nose 1 1;"
     " 13 comp G18 0 nose 0 0; 14 comp G18 1 nose 1 0; 15 comp G18 0 nose 0 0;"
     " 16 comp G18 1 nose 0 -1; 17 comp G18 0 nose 0 0; 18 comp G18 1 nose -1 0;"
     " 19 comp G18 0 nose 0 0; 20 comp G18 1 nose 0 1; 21 comp G18 0 nose 0 0;"
     " 22 comp G18 1 nose 0 0; 23 comp G18 0 nose 0 0; !24:10 number-range L 10/9"},
};

static void a_nose_points_where_it_says(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_tools(&self);
    told_lathe(&self);
    TOLD(check, &self, lathetools_rows);
}

static const told_row_t ports_rows[] = {
    {"M62 P3\nM63 P3\nM64 P0\nM65 P63\nM67 E2 Q1.5\nM68 E15 Q-2\nM66 P5\nM66 P5 L3 Q2\nM66 E1\n"
     "M66 E1 L0\nM66 P0 L4 Q.5\nM66 P1 L1 Q1 G0 X1\n",
     "1 out digital 3=1; 2 out digital 3=0; 3 out digital 0=1; 4 out digital 63=0;"
     " 5 out analogue 2=1.5; 6 out analogue 15=-2; 7 out input 5=0; 8 wait input 305=2;"
     " 9 out input 1001=0; 10 out input 1001=0; 11 wait input 400=0.5; 12 wait input 101=1;"
     " 12 rapid X1"},
    {"M62\nM62 P64\nM62 P-1\nM62 P1.5\nM62 P1 Q1\nM67 E2\nM67 Q2\nM67 E16 Q1\nM67 E1 Q1e9\n"
     "M67 E1 Q1000000000\nM67 E1 Q10000000000\nM66\nM66 P1 E1\nM66 P1 L1\nM66 P1 L1 Q0\n"
     "M66 P1 L5 Q1\nM66 P1 L-1\nM66 E1 L1 Q1\nM66 P1 Q-1\nM62 P1 M63 P2\nM62 P1 G4 P1\n",
     "!1:1 word-missing P 62/0; !2:5 number-range P 64/63; !3:5 number-range P -1/63;"
     " !4:5 number-range P 1.5/63; !5:8 word-unused Q; !6:1 word-missing Q 67/0;"
     " !7:1 word-missing E 67/0; !8:5 number-range E 16/15; !9:10 word-twice E;"
     " 10 out analogue 1=1e+09; !11:8 number-range Q 1e+10/1e+09; !12:1 word-missing P 66/0;"
     " !13:8 word-shared E; !14:1 word-missing Q 66/0; !15:1 word-missing Q 66/0;"
     " !16:8 number-range L 5/4; !17:8 number-range L -1/4; !18:8 number-range L 1/0;"
     " !19:8 number-range Q -1/1e+09; !20:8 modal-group M 63/0; !21:11 word-twice P"},
    {"M19\nM19 R90\nM41\nM61 Q1\nM100\nM6\nM199\nM30 X1\n",
     "!1:1 unsupported M 19/0; !2:1 unsupported M 19/0; !3:1 unsupported M 41/0;"
     " !5:1 m-unknown M 100/0; 6 out M5; 6 wait M6;"
     " !7:1 m-unknown M 199/0; !8:5 no-motion X"},
};

static void ports_are_handed_over(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, ports_rows);
}

static const told_row_t grbl_rows[] = {
    {"X1\nG0 X1\nG38.2 X2\nG43.1 Z1\nM7\nM3 S100\nG81 X1 Z1 R1\nG10 L2 P6 X1\nG10 L2 P7 X1\n"
     "G59.1\nM6 T1\nG28.1\nG61\nG64\nG93 G1 F1 X2\nG40\nG41 D1\nG4 P1\n#1=2\no1 sub\nM98 P1\n"
     "G33 Z1 K1\nG5 X1 I1 J1 P1 Q1\nG2 X1 R5 F1\nG91.1\nG90.1\nG53 G0 X1\n",
     "1 rapid X1; 2 rapid; !3:1 unsupported G 38.2/0; 5 out M7 Z-1 tool Z1; 6 out S100;"
     " 6 out M3 S100; !7:1 other-base G 81/7; !9:8 number-range P 7/6;"
     " !10:1 other-base G 59.1/17; !11:1 other-base M 6/7; !14:1 other-base G 64/7;"
     " 15 line X2 F1 exact P0 Q0 inverse; !17:1 other-base G 41/7; 18 dwell for 1;"
     " !19:1 other-base 0/7; !20:1 other-base 0/1; !21:1 other-base M 98/7;"
     " !22:1 other-base G 33/23; !23:1 other-base G 5/23;"
     " 24 arc X1 G17 about 1.5 4.97494 by -11.4783; !26:1 other-base G 90.1/1; 27 rapid"},
};

static void grbl_has_fewer_words(check_t *check) {
    told_begin(&self, NCK_DIALECT_GRBL);
    TOLD(check, &self, grbl_rows);
}

static const told_row_t marlin_rows[] = {
    {"G0 X1 Y2\nG1 E5 F300\nX2 E6\nM83\nE1\nG92 E0\nE2\nM82\nE3\nG91 X1 E1\nG90 X1 E1\n"
     "M104 S200\nM109 S200\nM109 R150\nM140 S60\nM190 R60\nM141 S30\nM191 S30\nM106\n"
     "M106 S128\nM107\nM220 S50\nM221 S95\nM17\nM84\nM117 hello G0 X5\nM118 text ; G0\nM400\n"
     "M201 X100\nM205 J1\nM1\nM0\nG4 S1.5\nG4 P250\nG28\nG28 X0 Y0\nG28 Z\nG29\nM900 K1\n",
     "1 rapid X1 Y2; 2 line U5 F300; 3 line X2 U6; 5 line U7; 7 line U9; 9 line U10;"
     " 10 line X3 U11; 11 line X1 U8; 12 out M104=200; 13 wait M109=200; 14 wait M109=150;"
     " 15 out M140=60; 16 wait M190=60; 17 out M141=30; 18 wait M191=30; 19 out M106=255;"
     " 20 out M106=128; 21 out M107; 22 out M220=50; 23 out M221=95; 24 out M17; 25 out M84;"
     " 26 out M117; 27 out M118; 28 dwell for 0; ?29:0 limits-stay; 29 out M201; 30 out M205;"
     " 31 wait M1; 32 wait M0; 33 dwell for 1.5; 34 dwell for 0.25; 35 rapid;"
     " 35 rapid X0 Y0 U0; 36 rapid; 36 rapid; 37 rapid; 37 rapid; ?38:1 mode-stays G 29/0;"
     " 39 out M900"},
    {"M104\nM104 S-1\nM104 S1000001\nM104 S1000000\nM104 S200 G0 X1\nM104 S200 M106\n"
     "G1 X1 E1 U1 F60\nG4\nG4 S-1\nE2000000\nM82 M83\nM117\nM18 X\nM110 N5\nE1\n",
     "!1:1 word-missing S 104/0; !2:6 number-range S -1/1000000; !3:6 number-range S"
     " 1000001/1000000; 4 out M104=1000000; !5:1 modal-group M 104/0; !6:11 modal-group M"
     " 106/0; !7:10 word-twice U; 8 dwell for 0; !9:4 number-range S -1/1000000; !10:1"
     " number-range E 2000000/1000000; !11:5 modal-group M 83/0; 12 out M117; 13 out M18; 14"
     " out M110; 15 rapid U1"},
    {"M0 S5\nM0 P2500\nM1 S2 hello P9\nM0 P500 S3\nM0S.5\nM0S4\nM0 S\nM1 P x\nM0 hello S5\n"
     "G4 P100 S2\nG4 S1 P700\nM0 S9999999\nG27 P2\nG12 P1 S1\nM125 L5\nM25\nM410\n",
     "1 dwell for 5; 2 dwell for 2.5; 3 dwell for 2; 4 dwell for 3; 5 wait M0; 6 dwell for 4; 7"
     " wait M0; 8 wait M1; 9 wait M0; 10 dwell for 2; 11 dwell for 1; 12 dwell for 1000000;"
     " ?13:1 mode-stays G 27/0; ?14:1 mode-stays G 12/0; 15 wait M125; 16 wait M25; 17 out M410"},
    {"G1 X1 F60\nX2 F0\nG0 X3 F-5\nG1 X4\nX5 F1\nX6 F0\n",
     "1 line X1 F60; ?2:4 feed-kept F; 2 line X2; 3 rapid X3 F60; 4 line X4; 5 line X5 F1;"
     " 6 line X6"},
};

static void printers_have_words_of_their_own(check_t *check) {
    told_begin(&self, NCK_DIALECT_MARLIN);
    told_extruder(&self);
    TOLD(check, &self, marlin_rows);
}

static const told_row_t from_3_rows[] = {
    {"T1 M6\nS500 M3 M8\nG0 X10 Y20\nZ5 F100\nG1 Z-1\nX40\nG2 X50 Y30 I0 J10\nG4 P1\nG1 X60\n"
     "M5\nY9\n",
     "3 entry 0 stop P0 Q0; 3 out T1 smooth P0.01 Q0.01 S500; 3 out M5; 3 wait M6;"
     " 3 entry 1 stop P0 Q0 S0; 3 out S500 smooth P0.01 Q0.01 S500; 3 out M3; 3 out M8;"
     " 3 entry 2 F100 stop P0 Q0; 3 rapid X10 Y20 smooth P0.01 Q0.01; 4 rapid Z5; 5 line Z-1;"
     " 6 line X40; 7 arc X50 Y30 G17 about 40 30 by -270; 8 dwell for 1; 9 line X60;"
     " 10 out M5 S0; 11 line Y9"},
};

static void a_program_begins_at_line_3(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 3;
    TOLD(check, &self, from_3_rows);
}

static const told_row_t from_6_rows[] = {
    {"T1 M6\nS500 M3 M8\nG0 X10 Y20\nZ5 F100\nG1 Z-1\nX40\nG2 X50 Y30 I0 J10\nG4 P1\nG1 X60\n"
     "M5\nY9\n",
     "3 rapid X10 Y20 S500; 4 rapid Z5; 5 line Z-1 F100; 6 entry 0 stop P0 Q0 S0;"
     " 6 out T1 smooth P0.01 Q0.01 S500; 6 out M5; 6 wait M6; 6 entry 1 stop P0 Q0 S0;"
     " 6 out S500 smooth P0.01 Q0.01 S500; 6 out M3; 6 out M8; 6 entry 2 stop P0 Q0;"
     " 6 line X40 smooth P0.01 Q0.01; 7 arc X50 Y30 G17 about 40 30 by -270; 8 dwell for 1;"
     " 9 line X60; 10 out M5 S0; 11 line Y9"},
};

static void a_program_begins_at_line_6(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 6;
    TOLD(check, &self, from_6_rows);
}

static const told_row_t from_8_rows[] = {
    {"T1 M6\nS500 M3 M8\nG0 X10 Y20\nZ5 F100\nG1 Z-1\nX40\nG2 X50 Y30 I0 J10\nG4 P1\nG1 X60\n"
     "M5\nY9\n",
     "3 rapid X10 Y20 S500; 4 rapid Z5; 5 line Z-1 F100; 6 line X40;"
     " 7 arc X50 Y30 G17 about 40 30 by -270; 8 entry 0 stop P0 Q0 S0;"
     " 8 out T1 smooth P0.01 Q0.01 S500; 8 out M5; 8 wait M6; 8 entry 1 stop P0 Q0 S0;"
     " 8 out S500 smooth P0.01 Q0.01 S500; 8 out M3; 8 out M8; 8 entry 2 stop P0 Q0;"
     " 8 dwell for 1 smooth P0.01 Q0.01; 9 line X60; 10 out M5 S0; 11 line Y9"},
};

static void a_program_begins_at_line_8(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 8;
    TOLD(check, &self, from_8_rows);
}

static const told_row_t from_11_rows[] = {
    {"T1 M6\nS500 M3 M8\nG0 X10 Y20\nZ5 F100\nG1 Z-1\nX40\nG2 X50 Y30 I0 J10\nG4 P1\nG1 X60\n"
     "M5\nY9\n",
     "3 rapid X10 Y20 S500; 4 rapid Z5; 5 line Z-1 F100; 6 line X40;"
     " 7 arc X50 Y30 G17 about 40 30 by -270; 9 line X60; 11 entry 0 stop P0 Q0 S0;"
     " 11 out T1 smooth P0.01 Q0.01; 11 out M5; 11 wait M6; 11 entry 1 stop P0 Q0;"
     " 11 out S500 smooth P0.01 Q0.01; 11 out M8; 11 entry 2 stop P0 Q0;"
     " 11 line Y9 smooth P0.01 Q0.01"},
};

static void a_program_begins_at_line_11(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 11;
    TOLD(check, &self, from_11_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, nothing_leaves_the_travel);
    CHECK_RUN(&check, tools_have_offsets_and_radii);
    CHECK_RUN(&check, a_nose_points_where_it_says);
    CHECK_RUN(&check, ports_are_handed_over);
    CHECK_RUN(&check, grbl_has_fewer_words);
    CHECK_RUN(&check, printers_have_words_of_their_own);
    CHECK_RUN(&check, a_program_begins_at_line_3);
    CHECK_RUN(&check, a_program_begins_at_line_6);
    CHECK_RUN(&check, a_program_begins_at_line_8);
    CHECK_RUN(&check, a_program_begins_at_line_11);
    return check_end(&check);
}
