// SPDX-License-Identifier: MIT
// Room 1: every block of canned cycles, from the words of their lines.
#include "told_check.h"

static told_t self;

static const told_row_t cycles_rows[] = {
    {"G81 X1 Z-5 R2 F100\n",
     "1 rapid~ Z2; 1 rapid~ X1; 1 line~ Z-5 F100; 1 rapid~ Z2"},
    {"G0 Z10\nG81 X10 Y5 Z-5 R2 F100\nX20\nG91 X10 L3\nG90 G80\nX0\n",
     "1 rapid Z10; 2 rapid~ X10 Y5; 2 rapid~ Z2; 2 line~ Z-5 F100; 2 rapid~ Z2; 3 rapid~ X20;"
     " 3 line~ Z-5; 3 rapid~ Z2; 4 rapid~ Z12; 4 rapid~ X30; 4 line~ Z7; 4 rapid~ Z12;"
     " 4 rapid~ X40; 4 line~ Z7; 4 rapid~ Z12; 4 rapid~ X50; 4 line~ Z7; 4 rapid~ Z12;"
     " !6:1 no-motion X"},
    {"G0 Z10\nF100 G98 G82 X1 Z-2 R1 P.5\nX2 P.25\nG99 X3\nX4 Z-3\nR2 X5\nG80 G0 Z20\n",
     "1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z1; 2 line~ Z-2 F100; 2 dwell for 0.5; 2 rapid~ Z10;"
     " 3 rapid~ X2; 3 rapid~ Z1; 3 line~ Z-2; 3 dwell for 0.25; 3 rapid~ Z10; 4 rapid~ X3;"
     " 4 rapid~ Z1; 4 line~ Z-2; 4 dwell for 0.25; 4 rapid~ Z1; 5 rapid~ X4; 5 line~ Z-3;"
     " 5 dwell for 0.25; 5 rapid~ Z1; 6 rapid~ Z2; 6 rapid~ X5; 6 line~ Z-3; 6 dwell for 0.25;"
     " 6 rapid~ Z2; 7 rapid Z20"},
    {"G0 Z10 F100\nG83 X1 Z-10 R1 Q4\nX2 Q20\nG73 X3 Z-5 R1 Q2\nX4 Q6\n",
     "1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z1; 2 line~ Z-3 F100; 2 rapid~ Z1; 2 rapid~ Z-2.746;"
     " 2 line~ Z-7; 2 rapid~ Z1; 2 rapid~ Z-6.746; 2 line~ Z-10; 2 rapid~ Z1; 3 rapid~ X2;"
     " 3 line~ Z-10; 3 rapid~ Z1; 4 rapid~ X3; 4 line~ Z-1; 4 rapid~ Z-0.746; 4 line~ Z-3;"
     " 4 rapid~ Z-2.746; 4 line~ Z-5; 4 rapid~ Z1; 5 rapid~ X4; 5 line~ Z-5; 5 rapid~ Z1"},
    {"G0 Z10 F100 S500 M3\nG85 X1 Z-5 R1\nG86 X2 Z-5 R1 P1\nG89 X3 Z-5 R1 P2\nM5\n"
     "G86 X4 Z-5 R1 P1\n",
     "1 out S500; 1 out M3 S500; 1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z1; 2 line~ Z-5 F100;"
     " 2 line~ Z1; 3 rapid~ X2; 3 line~ Z-5; 3 dwell for 1; 3 out M5 S0; 3 rapid~ Z1;"
     " 3 out M3 S500; 4 rapid~ X3; 4 line~ Z-5; 4 dwell for 2; 4 line~ Z1; 5 out M5 S0;"
     " !6:1 word-missing M"},
    {"G0 Z10 S100 M3 F150\nG84 X1 Z-5 R2\nM4\nG74 X2 Z-5 R2 P.5\nM3\nG74 X3 Z-5 R2\n"
     "G84 X4 Z-5 R2 L2 G91\nS0\nX1\n",
     "1 out S100; 1 out M3 S100; 1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z2;"
     " 2 tap by 0 0 -7 lead 1.5 for 5.968; 3 out M4; 4 rapid~ X2;"
     " 4 tap by 0 0 -7 lead 1.5 dwell 0.5 for 6.468; 5 out M3; !6:1 word-missing M;"
     " 7 rapid~ Z4; 7 rapid~ X6; 7 tap by 0 0 -5 lead 1.5 for 4.368; 7 rapid~ X10;"
     " 7 tap by 0 0 -5 lead 1.5 for 4.368; 8 out S0 S0; !9:0 thread-speed S"},
    {"G0 Z10 S100 M3\nG95 F1.5\nG84 X1 Z-5 R2\nG94 F150 X2\nG93 F2 G81 X3 Z-5 R1\n",
     "1 out S100; 1 out M3 S100; 1 rapid Z10; 3 rapid~ X1 per-rev; 3 rapid~ Z2;"
     " 3 tap by 0 0 -7 lead 1.5 for 5.968; 4 rapid~ X2 per-min;"
     " 4 tap by 0 0 -7 lead 1.5 for 5.968; !5:0 unsupported G 93/0"},
    {"G0 Z10 F100\nG81 X1 Z-5\nG81 X1 R2\nG81 Z-5\nG81 X1 Z3 R2\nG83 X1 Z-5 R1\n"
     "G83 X1 Z-5 R1 Q0\nG83 X1 Z-5 R1 Q-1\nG82 X1 Z-5 R1\nG82 X1 Z-5 R1 P-1\nG81 X1 Z-5 R1 L0\n"
     "G81 X1 Z-5 R1 L1.5\nG81 X1 Z-5 R1 L1000001\nG81 X1 Z-5 R1 K2\nG81 X1 Z-5 R1 Q2\n"
     "G81 X1 Z-5 R1 A3\nG81\nG81 X1 Z-5 R1 I2\nG98\n",
     "1 rapid Z10; !2:1 word-missing R; !3:1 word-missing Z; !4:1 word-missing R;"
     " !5:11 number-range R 2/3; !6:1 word-missing Q; !7:15 number-range Q;"
     " !8:15 number-range Q -1/0; !9:1 word-missing P; !10:15 number-range P -1/1000000;"
     " !11:15 number-range L 0/1000000; !12:15 number-range L 1.5/1000000;"
     " !13:15 number-range L 1000001/1000000; !14:15 word-unused K; !15:15 word-unused Q;"
     " !16:15 axis-unknown A; !17:1 word-missing X; !18:15 word-unused I"},
    {"G0 Z10 F100\nG83 X1 Z-5 R1 Q0\nX2\nG83 X3 Z-5 R1 Q6\nX4 Q-1\nX5\nG73 X6 Z-5 R1 Q0\nX7 Z-6\n"
     "G83 X8 Z-5 R1 Q1000001\nX9\n",
     "1 rapid Z10; !2:15 number-range Q; 4 rapid~ X3; 4 rapid~ Z1; 4 line~ Z-5 F100; 4 rapid~ Z1;"
     " !5:4 number-range Q -1/0; !7:15 number-range Q;"
     " !9:15 number-range Q 1000001/1000000"},
    {"G91 G0 Z10 F60\nG81 X1 Y2 Z-5 R-2 L2\nX1 Z-6\nR-3 X1\nG99 X1 L3\nG90 X0 Z0 R1\n",
     "1 rapid Z10; 2 rapid~ X1 Y2; 2 rapid~ Z8; 2 line~ Z3 F60; 2 rapid~ Z8; 2 rapid~ X2 Y4;"
     " 2 line~ Z3; 2 rapid~ Z8; 3 rapid~ X3; 3 line~ Z2; 3 rapid~ Z8; 4 rapid~ X4; 4 rapid~ Z7;"
     " 4 line~ Z1; 4 rapid~ Z7; 5 rapid~ X5; 5 line~ Z1; 5 rapid~ Z7; 5 rapid~ X6; 5 line~ Z1;"
     " 5 rapid~ Z7; 5 rapid~ X7; 5 line~ Z1; 5 rapid~ Z7; 6 rapid~ X0; 6 rapid~ Z1; 6 line~ Z0;"
     " 6 rapid~ Z1"},
    {"G18 G0 Y10 F60\nG81 X1 Z2 Y-5 R1\nG19 G81 Y1 Z2 X-5 R1\nX-6 Y2\nG17\nG81 X0 Y0 Z-7 R3\n"
     "G18 X1\n",
     "1 rapid Y10; 2 rapid~ X1 Z2; 2 rapid~ Y1; 2 line~ Y-5 F60; 2 rapid~ Y1; 3 line~ X-5;"
     " 3 rapid~ X1; 4 rapid~ Y2; 4 line~ X-6; 4 rapid~ X1; 6 rapid~ Z3; 6 rapid~ X0 Y0;"
     " 6 line~ Z-7; 6 rapid~ Z3; !7:0 word-missing R"},
    {"G20 G0 Z1 F10\nG81 X1 Z-.5 R.1\nG83 X2 Z-.5 R.1 Q.25\nG73 X3 Z-.5 R.1 Q.25\n"
     "G21 X9 Z-3 R1 Q2\n",
     "?1:0 feed-units; 1 rapid Z25.4; 2 rapid~ X25.4; 2 rapid~ Z2.54; 2 line~ Z-12.7 F10;"
     " 2 rapid~ Z2.54; 3 rapid~ X50.8; 3 line~ Z-3.81; 3 rapid~ Z2.54; 3 rapid~ Z-3.556;"
     " 3 line~ Z-10.16; 3 rapid~ Z2.54; 3 rapid~ Z-9.906; 3 line~ Z-12.7; 3 rapid~ Z2.54;"
     " 4 rapid~ X76.2; 4 line~ Z-3.81; 4 rapid~ Z-3.556; 4 line~ Z-10.16; 4 rapid~ Z-9.906;"
     " 4 line~ Z-12.7; 4 rapid~ Z2.54; 5 rapid~ X9; 5 rapid~ Z1; 5 line~ Z-1; 5 rapid~ Z-0.746;"
     " 5 line~ Z-3; 5 rapid~ Z1"},
    {"G0 Z-5 F100\nG81 X1 Z-8 R2\nX2 Z-9\nG99 X3\nG80 G0 X0\n",
     "1 rapid Z-5; 2 rapid~ Z2; 2 rapid~ X1; 2 line~ Z-8 F100; 2 rapid~ Z2; 3 rapid~ X2;"
     " 3 line~ Z-9; 3 rapid~ Z2; 4 rapid~ X3; 4 line~ Z-9; 4 rapid~ Z2; 5 rapid X0"},
    {"G0 Z10 F100\nG81 X1 Z-5 R2\nG0 X9\nX10\nG81 X2\nG81 X2 Z-5 R3\n",
     "1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z2; 2 line~ Z-5 F100; 2 rapid~ Z2; 3 rapid X9;"
     " 4 rapid X10; !5:1 word-missing R; 6 rapid~ Z3; 6 rapid~ X2; 6 line~ Z-5; 6 rapid~ Z3"},
    {"G0 Z10\nG81 X1 Z-5 R2\nF100\nX2\nX3\n",
     "1 rapid Z10; !2:0 feed-missing F; 4 rapid~ X2 Z2; 4 line~ Z-5 F100; 4 rapid~ Z2;"
     " 5 rapid~ X3; 5 line~ Z-5; 5 rapid~ Z2"},
    {"G64 P.05 G0 Z10 F100\nG81 X1 Z-5 R2\nG61 X2\nG61.1 X3\nG64 P0 X4\nG9 X5\n",
     "1 rapid Z10 P0.05 Q0.05; 2 rapid~ X1; 2 rapid~ Z2; 2 line~ Z-5 F100; 2 rapid~ Z2;"
     " 3 rapid X2 exact P0 Q0; 3 line Z-5; 3 rapid Z2; 4 rapid X3 stop; 4 line Z-5; 4 rapid Z2;"
     " ?5:5 no-tolerance P; 5 rapid X4 exact; 5 line Z-5; 5 rapid Z2; 6 rapid X5 stop;"
     " 6 line Z-5; 6 rapid Z2"},
    {"G10 L2 P1 X100 Z50\nG43.1 Z7\nG0 Z10 F100\nG81 X1 Z-5 R2\nG52 X1 Z1\nX2\nG92 X0\nX3\n",
     "3 rapid Z60 tool Z7; 4 rapid~ X101; 4 rapid~ Z52; 4 line~ Z45 F100; 4 rapid~ Z52;"
     " 6 rapid~ Z53; 6 rapid~ X103; 6 line~ Z46; 6 rapid~ Z53; 8 rapid~ X106; 8 line~ Z46;"
     " 8 rapid~ Z53"},
    {"G0 Z10 F100\nG81 G28 X1\nX2 Z-5 R1\nG80 X1\n",
     "1 rapid Z10; !2:5 modal-group G 28/0; !3:8 word-unused R; !4:5 word-unused X"},
    {"G91 F100 G81 X500000 Z-1 R-1 L3\nG90 G81 X1 Z-1000000 R1\nG81 X1 Z-1000001 R1\n"
     "G81 X1000000 Z-1 R1\n",
     "!1:14 number-range X 500000/333333.333; 2 rapid~ Z1; 2 rapid~ X1; 2 line~ Z-1000000 F100;"
     " 2 rapid~ Z1; !3:8 number-range Z -1000001/1000000; 4 rapid~ X1000000; 4 line~ Z-1;"
     " 4 rapid~ Z1"},
    {"G0 X1 F100 G81 Z-1 R1\nG0 Z5 G82 X1 P1 R1\nG4 P1 G82 X1 Z-1 R1\n",
     "!1:12 modal-group G 81/0; !2:7 modal-group G 82/0; !3:4 word-shared P"},
};

// Fanuc's lathes, G-code system A.
static const told_row_t lathe_rows[] = {
    {"S500 M3\nG0 X0. Z5.\nG83 Z-9. R-2. Q4. P200 F.1\nG80\nG0 X40.\nG85 X30. Z-4. R-1. P500\n"
     "X20. K2\n",
     "1 out S500 per-rev; 1 out M3 S500; 2 rapid Z5; ?3:0 assumed-peck; 3 rapid~ Z3; 3 line~ Z-1"
     " F0.1; 3 rapid~ Z-0.746; 3 line~ Z-5; 3 rapid~ Z-4.746; 3 line~ Z-9; 3 dwell for 0.2; 3"
     " rapid~ Z5; 5 rapid X20; 6 rapid~ X15; 6 rapid~ Z4; 6 line~ Z-4; 6 dwell for 0.5; 6 line~"
     " Z4 F0.2; 6 rapid~ Z5; 7 rapid~ X10; 7 rapid~ Z4; 7 line~ Z-4 F0.1; 7 dwell for 0.5; 7"
     " line~ Z4 F0.2; 7 rapid~ Z5; 7 rapid~ Z4; 7 line~ Z-4 F0.1; 7 dwell for 0.5; 7 line~ Z4"
     " F0.2; 7 rapid~ Z5"},
    {"S500 M3\nG0 X40. Z5.\nG87 X30. R-2. Q2. F.1\nZ-9.\nG89 X32. P100\nG83 Z-12. X20.\n"
     "G88 X30. R-4. F1.\nG84 Z-20. R-3. X10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 2 rapid X20 Z5; ?3:0 assumed-peck; 3 rapid~ X18; 3"
     " line~ X16 F0.1; 3 rapid~ X16.254; 3 line~ X15; 3 rapid~ X20; 4 rapid~ Z-9; 4 rapid~ X18; 4"
     " line~ X16; 4 rapid~ X16.254; 4 line~ X15; 4 rapid~ X20; 5 rapid~ X18; 5 line~ X16; 5 dwell"
     " for 0.1; 5 line~ X18 F0.2; 5 rapid~ X20; 6 rapid~ X10; 6 line~ Z-12 F0.1; 6 rapid~ Z-9;"
     " !7:10 number-range R 12/30; 8 rapid~ X5; 8 rapid~ Z-12; 8 tap by 0 0 -8 lead 1 for 2.104;"
     " 8 rapid~ Z-9"},
    {"S500 M3\nG0 X40. Z5.\nG83 X30. Z-9. F.1\nG83 Z-9. R2.\nG83 W-9. R-2.\nW-9.\nG85 R-2.\n"
     "G83 Z9. R-2.\nG85 Z-9. Q1.\nG83 Z-9. Q5\nG81 Z-9. R-2.\nG80 U2. W2.\n",
     "1 out S500 per-rev; 1 out M3 S500; 2 rapid X20 Z5; 3 rapid~ X15; 3 line~ Z-9 F0.1; 3"
     " rapid~ Z5; !4:10 number-range R 2/0; !5:5 incremental W; !6:1 incremental W; 7 rapid~ Z3;"
     " 7 line~ Z-9; 7 line~ Z3 F0.2; 7 rapid~ Z5; !8:9 number-range R 3/9; !9:10 word-unused Q;"
     " ?10:0 assumed-peck; 10 rapid~ Z3; 10 line~ Z-2 F0.1; 10 rapid~ Z-1.746; 10 line~ Z-7; 10"
     " rapid~ Z-6.746; 10 line~ Z-9; 10 rapid~ Z5; !11:1 unsupported G 81/0; !12:5 word-unused U"},
};

static void a_lathe_drills_along_z_and_x(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, lathe_rows);
}

static void a_cycle_drills_where_its_words_say(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, cycles_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_cycle_drills_where_its_words_say);
    CHECK_RUN(&check, a_lathe_drills_along_z_and_x);
    return check_end(&check);
}
