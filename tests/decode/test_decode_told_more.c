// SPDX-License-Identifier: MIT
// Room 1: turning and threads, states that are kept, cycles that follow each other.
#include "told_check.h"

static told_t self;

static const told_row_t lathe2_rows[] = {
    {"T101 M6\nT0100\nG0 X10. Z5.\nT0102\nT0808\nT1\nT2.\nT200\nT-1\nT109\n",
     "1 wait T1 Z-10 tool Z10 per-rev; 1 out M5; 1 wait M6; 3 rapid X5 Z5 tool Z0; 5 wait T8;"
     " 6 out T1; 7 out T2; 8 wait T2; !9:1 number-range T -1/1e+09; !10:1 tool-unknown T 9/0"},
    {"G98 G1 X10. F100.\nG99 X20. F.2 S100 M3\nG20 X1. F.01\nG21 X10.\nG0 U5. W1. V1.\n"
     "G18 G2 X30. Z-5. R10.\nG17\nG40 G41\nG4 U1.\nG4 P500\nG4 X.5\nG32 X20. F1. E1.\n"
     "G34 Z1. F1. K1.\nG92 X5.\nG90\nG91 X1.\nG28 U1. W1.\nG30 P2 U1.\n",
     "1 line X5 F100; 2 out S100 per-rev; 2 out M3 S100; 2 line X10 F0.2; ?3:0 feed-units;"
     " 3 line X12.7 F0.254; 4 line X5; !5:12 axis-unknown V;"
     " 6 arc X15 Z-5 G18 about 4.9162 13.7081 by -67.9757; !8:5 modal-group G 41/0;"
     " 9 dwell for 1; 10 dwell for 0.5; 11 dwell for 0.5; !12:14 word-unknown E;"
     " !13:1 unsupported G 34/0; !14:1 word-missing Z 92/0; !16:1 unsupported G 91/0;"
     " 17 rapid X15.5 Z-4; 17 rapid X0 Z0; 18 rapid X0.5; 18 rapid X0"},
    {"G0 X30. Z2. F.2 S500 M3\nG90 X28. Z-10. R2.\nX28. R-3.\nX28. Z2. R-1.\nG90 X28.\n"
     "G90 Z-1.\nG90 X28. Z-10. I-1.\nG90 X28. Z-10. I-1. R1.\nG94 X20. Z-2. K-1.\n"
     "G94 X20. Z-2. R-1.\nG94 X20. K-1. R-1. Z-2.\nG94 X30. Z-2. R1.\nG90\nG94 R1.\nG0 X40.\n"
     "G90 U-4. W-4.\nU-2.\nG93 X1.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:16 number-range R 2/1;"
     " 3 rapid~ X11; 3 line~ X14 Z-10 F0.2; 3 line~ X15; 3 rapid~ Z2;"
     " !4:10 number-range R -1/1; !5:0 number-range R -1/1; 6 rapid~ X13; 6 line~ X14 Z-1;"
     " 6 line~ X15; 6 rapid~ Z2; 7 rapid~ X13; 7 line~ X14 Z-10; 7 line~ X15; 7 rapid~ Z2;"
     " !8:16 word-shared I; 9 rapid~ Z-3; 9 line~ X10 Z-2; 9 line~ Z2; 9 rapid~ X15;"
     " 10 rapid~ Z-3; 10 line~ X10 Z-2; 10 line~ Z2; 10 rapid~ X15; !11:10 word-shared K;"
     " !12:15 number-range R 1/4; !14:1 word-missing X 94/0; 15 rapid X20; 16 rapid~ X18;"
     " 16 line~ Z-2; 16 line~ X20; 16 rapid~ Z2; 17 rapid~ X19; 17 line~ Z-2; 17 line~ X20;"
     " 17 rapid~ Z2; !18:0 unsupported G 93/0"},
    {"G0 X30. Z2. F.2 S500 M3\nG74 Z-6. P2. Q3. X26.\nG74 Z-6. K3.\nG74 Z-6. K3. Q3.\n"
     "G74 Z-6.\nG74 X20. Q1.\nG74 R-1.\nG74 R.2\nG74 Z-6. Q0\nG74 X26. Z-6. Q9.\n"
     "G74 X26. Z-6. Q9. I1.\nG74 Z-6. Q3. R0\nG75 X26. I1.\nG75 X26. P1. R1.\n"
     "G75 X26. Z-2. P5. K3.\nG75 Z-2. P5.\nG74 U-4. W-4. P1. Q2.\nG74\nG98 G74 Z-6. Q3.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 2 line~ Z-1 F0.2; 2 rapid~ Z-0.5;"
     " 2 line~ Z-4; 2 rapid~ Z-3.5; 2 line~ Z-6; 2 rapid~ Z2; 2 rapid~ X13; 2 line~ Z-1;"
     " 2 rapid~ Z-0.5; 2 line~ Z-4; 2 rapid~ Z-3.5; 2 line~ Z-6; 2 rapid~ Z2; 2 rapid~ X15;"
     " 3 line~ Z-1; 3 rapid~ Z-0.5; 3 line~ Z-4; 3 rapid~ Z-3.5; 3 line~ Z-6; 3 rapid~ Z2;"
     " !4:10 word-shared K; !5:1 word-missing Q 74/0; !6:1 word-missing Z 74/0;"
     " !7:5 number-range R -1/0; !9:10 number-range Q; !10:1 word-missing P 74/0; 11 line~ Z-6;"
     " 11 rapid~ Z2; 11 rapid~ X14; 11 line~ Z-6; 11 rapid~ Z2; 11 rapid~ X13; 11 line~ Z-6;"
     " 11 rapid~ Z2; 11 rapid~ X15; 12 line~ Z-1; 12 rapid~ Z-0.8; 12 line~ Z-4;"
     " 12 rapid~ Z-3.8; 12 line~ Z-6; 12 rapid~ Z2; 13 line~ X14; 13 rapid~ X14.2;"
     " 13 line~ X13; 13 rapid~ X15; !14:14 unsupported G 75/0; 15 line~ X13; 15 rapid~ X15;"
     " 15 rapid~ Z-1; 15 line~ X13; 15 rapid~ X15; 15 rapid~ Z-2; 15 line~ X13; 15 rapid~ X15;"
     " 15 rapid~ Z2; !16:1 word-missing X 75/0; 17 line~ Z0; 17 rapid~ Z0.2; 17 line~ Z-2;"
     " 17 rapid~ Z2; 17 rapid~ X14; 17 line~ Z0; 17 rapid~ Z0.2; 17 line~ Z-2; 17 rapid~ Z2;"
     " 17 rapid~ X13; 17 line~ Z0; 17 rapid~ Z0.2; 17 line~ Z-2; 17 rapid~ Z2; 17 rapid~ X15;"
     " !18:1 word-missing R 74/0; !19:0 feed-missing F"},
    {"G0 X30. Z2. S500 M3\nG92 X28. Z-10.\nG92 X28. Z-10. F1. I-1.\n"
     "G92 X28. Z-10. F1. I-1. R1.\nG92 X28. Z-10. F1. Q90000\nG92 X28. Z-10. F1. Q90.\n"
     "G92 X28. Z-10. F1. Q400000\nG92 Z-5. F1.\nG92 X27. F1.\nX26.\nZ-4.\nG92 F1.\n"
     "G92 X28. Z-10. F0\nG92 X28. Z-10. F1001.\nM5\nG92 X28. Z-10. F1.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing F 92/0;"
     " 3 rapid~ X13; 3 thread X14 Z-10 of 12 lead 1 for 1.562; 3 rapid~ X15; 3 rapid~ Z2;"
     " !4:20 word-shared I; 5 rapid~ X14; 5 thread Z-10 of 12 lead 1 at 0.25 for 1.562;"
     " 5 rapid~ X15; 5 rapid~ Z2; 6 rapid~ X14;"
     " 6 thread Z-10 of 12 lead 1 at 0.00025 for 1.562; 6 rapid~ X15; 6 rapid~ Z2;"
     " !7:20 number-range Q 400000/360000; !8:1 word-missing X 92/0; !9:1 word-missing Z 92/0;"
     " !12:1 word-missing X 92/0; !13:16 number-range F 0/1000000; 14 rapid~ X14;"
     " !14:1 thread-speed F 8341.66667/95.2380952; 15 out M5 Z-10 S0; !16:1 thread-speed S"},
    {"G0 X30. Z2. S500 M3\nG76 P020060 Q100\nG76 P999999 Q1 R.1\nG76 P9A\nG76 P-1\n"
     "G76 P1000000\nG76 P010200\nG76 P010060 Q-1\nG76 P010060 Q0 R-1.\nG76 P010060 Q0 R0.\n"
     "G76 X26. Z-20. P2000 Q0 F2.\nG76 X26. Z-20. P2000 F2.\nG76 X26. Z-20. Q1000 F2.\n"
     "G76 X26. P2000 Q1000 F2.\nG76 Z-20. P2000 Q1000 F2.\nG76 X26. Z-20. P-1 Q1000 F2.\n"
     "G76 X26. Z-20. P2000 Q1000\nG76 X26. Z-20. P2000 Q3000 F2.\n"
     "G76 X34. Z-20. P2000 Q1500 F2.\nG76 X26. Z20. P2000 Q1500 F2.\n"
     "G76 U-4. W-5. P2. Q2. F2.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !3:5 number-range P 999999/999999;"
     " !4:7 number A; !5:5 number-range P -1/999999; !6:5 number-range P 1000000/999999;"
     " !8:13 number-range Q -1/1e+09; !9:16 number-range R -1/0; !11:22 number-range Q 0/2;"
     " !12:1 word-missing Q 76/0; !13:1 word-missing P 76/0; !14:1 word-missing Z 76/0;"
     " !15:1 word-missing X 76/0; !16:16 number-range P -1/1e+09; 17 rapid~ Z1.42265;"
     " 17 rapid~ X14; 17 thread Z-19.42265 of 20.8453 lead 2 for 1.399; 17 rapid~ X15;"
     " 17 rapid~ Z1.183503; 17 rapid~ X13.585786;"
     " 17 thread Z-19.661796 of 20.845299 lead 2 for 1.399; 17 rapid~ X15; 17 rapid~ Z1;"
     " 17 rapid~ X13.267949; 17 thread Z-19.845299 of 20.845299 lead 2 for 1.399;"
     " 17 rapid~ X15; 17 rapid~ Z0.845299; 17 rapid~ X13;"
     " 17 thread Z-20 of 20.845299 lead 2 for 1.399; 17 rapid~ X15; 17 rapid~ Z0.845299;"
     " 17 rapid~ X13; 17 thread Z-20 of 20.845299 lead 2 for 1.399; 17 rapid~ X15;"
     " 17 rapid~ Z2; 18 rapid~ Z0.845299; 18 rapid~ X13;"
     " 18 thread Z-20 of 20.845299 lead 2 for 1.399; 18 rapid~ X15; 18 rapid~ Z0.845299;"
     " 18 rapid~ X13; 18 thread Z-20 of 20.845299 lead 2 for 1.399; 18 rapid~ X15;"
     " 18 rapid~ Z2; 19 rapid~ Z1.133975; 19 rapid~ X16.5;"
     " 19 thread Z-19.711325 of 20.8453 lead 2 for 1.399; 19 rapid~ X15; 19 rapid~ Z0.845299;"
     " 19 rapid~ X17; 19 thread Z-20 of 20.845299 lead 2 for 1.399; 19 rapid~ X15;"
     " 19 rapid~ Z0.845299; 19 rapid~ X17; 19 thread Z-20 of 20.845299 lead 2 for 1.399;"
     " 19 rapid~ X15; 19 rapid~ Z2; 20 rapid~ Z2.866025; 20 rapid~ X13.5;"
     " 20 thread Z19.711325 of 16.8453 lead 2 for 1.159; 20 rapid~ X15; 20 rapid~ Z3.154701;"
     " 20 rapid~ X13; 20 thread Z20 of 16.845299 lead 2 for 1.159; 20 rapid~ X15;"
     " 20 rapid~ Z3.154701; 20 rapid~ X13; 20 thread Z20 of 16.845299 lead 2 for 1.159;"
     " 20 rapid~ X15; 20 rapid~ Z2; 21 rapid~ Z1.998845; 21 rapid~ X13;"
     " 21 thread Z-3 of 4.998845 lead 2 for 0.4478; 21 rapid~ X15; 21 rapid~ Z1.998845;"
     " 21 rapid~ X13; 21 thread Z-3 of 4.998845 lead 2 for 0.4478; 21 rapid~ X15; 21 rapid~ Z2"},
    {"G96 S100 M3\nG50 S1000\nG96 S100\nG50 S-1\nG50 S0\nG50 X1. S500\nG0 X0\nG92 S100\n"
     "G97 S100\nM4 X1.\nG96 S50 M5\nG96 S200 X2. F.1\nG1 X3.\n",
     "!1:1 speed-limit S 96/0; 3 out surface 100000 per-rev; !4:5 number-range S -1/1e+09;"
     " !5:5 number-range S 0/1e+09; 7 rapid X-0.5; !8:1 word-missing X 92/0; 9 out S100;"
     " 10 out M4 S100 axis-0.5; 11 out surface 50000 S500 V50000; 11 out M5 S0 V0 axis0;"
     " 12 out surface 200000; !13:0 feed-missing S"},
};

static void turning_pecking_threading_by_every_word(check_t *check) {
    told_turning(&self);
    told_tools(&self);
    TOLD(check, &self, lathe2_rows);
}

static const told_row_t bits_rows[] = {
    {"S100 M3\nM70\nG96 S50 D500\nM72\nG96 S50 D500\nM70\nG97 S200 M4\nM72\nG0 X1\n",
     "1 out S100; 1 out M3 S100; 3 out surface 50000 S500 V50000; 4 out S100 S100 V0;"
     " 5 out surface 50000 S500 V50000; 7 out S200 S200 V0; 7 out M4;"
     " 8 out surface 50000 S500 V50000; 8 out M3; 9 rapid X1"},
    {"S50\nM70\nM3\nM72\nM70\nM8 M7\nM72\nM8\nM70\nM7\nM72\nM7 M8\nM70\nM9\nM72\nM9\nM70\nM8\n"
     "M72\n",
     "1 out S50; 3 out M3 S50; 4 out M5 S0; 6 out M7; 6 out M8; 7 out M9; 8 out M8; 10 out M7;"
     " 11 out M9; 11 out M8; 12 out M7; 12 out M8; 14 out M9; 15 out M7; 15 out M8; 16 out M9;"
     " 18 out M8; 19 out M9"},
    {"M70\nG20 G18 G91 G64 P.1 Q.2 F5 G95\nM72\nG0 X1\nG1 Y1 F9\nM70\nG93\nM72\nY2\nM71\nM72\n",
     "?2:0 feed-units; 4 rapid X1; 5 line Y1 F9; 9 line Y2; !11:1 flow M 72/0"},
    {"o1 sub\nM73\nS9 M3\no2 call\nG0 X1\no1 endsub\no2 sub\nM70\nS8\nM72\nS7\no2 endsub\n"
     "o1 call\nX2\n",
     "3 out S9; 3 out M3 S9; 9 out S8 S8; 10 out S9 S9; 11 out S7 S7; 5 rapid X1; 6 out M5 S0;"
     " 14 rapid X2"},
    {"o1 sub\nM70\no1 if [#1 GT 0]\no1 call [#1-1]\no1 endif\no1 endsub\no1 call [5]\n",
     "!2:1 call-depth M 4/4; ?4:0 called-from; ?4:0 called-from; ?4:0 called-from;"
     " ?4:0 called-from; ?7:0 called-from"},
    {"M70\nG10 L2 P2 X5\nG55 G0 X1\nM72\nX1\nM70\nG43.1 Z4\nM72\nZ1\nM70\nT5 M6\nM72\nM6\nM70\n"
     "G99\nM72\nM70\nG7 G90.1\nM72\nX3\n",
     "3 rapid X6; 5 rapid X1; 9 rapid Z1; 11 out T5; 11 out M5; 11 wait M6; 13 out M5;"
     " 13 wait M6; 20 rapid X3"},
    {"M70\nG41.1 D4 F9\nM72\nG40\nM72\n",
     "2 comp G17 2 nose 0 0; !3:1 comp-on M 72/0; 4 comp G17 0 nose 0 0"},
    {"M70\nM70\nM71\nM72\n",
     "!4:1 flow M 72/0"},
};

static void a_state_comes_back_as_it_was(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, bits_rows);
}

static const told_row_t cyc2_rows[] = {
    {"G0 Z10 F60 S60 M3\nG81 X1 Z-5 R2 L3\nG98 L2 X2\nG91 G99 X1 Y1 L2\n"
     "G90 G83 X0 Z-6 R2 Q2.5 L2\nG80\nG73 X1 Z0 R1 Q.254\nG73 X1 Z0 R1 Q.253\nG0 Z0\n"
     "G83 X1 Z0 R1 Q.1\nG82 X2 Z0 R1 P1 L2\nG85 X3 Z0 R1 L2\nG86 X4 Z0 R1 P0 L2\n"
     "G89 X5 Z0 R1 P1 L2\n",
     "1 out S60; 1 out M3 S60; 1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z2; 2 line~ Z-5 F60;"
     " 2 rapid~ Z2; 2 line~ Z-5; 2 rapid~ Z2; 2 line~ Z-5; 2 rapid~ Z2; 3 rapid~ X2;"
     " 3 line~ Z-5; 3 rapid~ Z10; 3 rapid~ Z2; 3 line~ Z-5; 3 rapid~ Z10; 4 rapid~ Z12;"
     " 4 rapid~ X3 Y1; 4 line~ Z7; 4 rapid~ Z12; 4 rapid~ X4 Y2; 4 line~ Z7; 4 rapid~ Z12;"
     " 5 rapid~ X0; 5 rapid~ Z2; 5 line~ Z-0.5; 5 rapid~ Z2; 5 rapid~ Z-0.246; 5 line~ Z-3;"
     " 5 rapid~ Z2; 5 rapid~ Z-2.746; 5 line~ Z-5.5; 5 rapid~ Z2; 5 rapid~ Z-5.246;"
     " 5 line~ Z-6; 5 rapid~ Z2; 5 line~ Z-0.5; 5 rapid~ Z2; 5 rapid~ Z-0.246; 5 line~ Z-3;"
     " 5 rapid~ Z2; 5 rapid~ Z-2.746; 5 line~ Z-5.5; 5 rapid~ Z2; 5 rapid~ Z-5.246;"
     " 5 line~ Z-6; 5 rapid~ Z2; 7 rapid~ X1; 7 rapid~ Z1; 7 line~ Z0.746; 7 rapid~ Z1;"
     " 7 line~ Z0.492; 7 rapid~ Z0.746; 7 line~ Z0.238; 7 rapid~ Z0.492; 7 line~ Z0;"
     " 7 rapid~ Z1; 8 line~ Z0.747; 8 rapid~ Z1; 8 line~ Z0.494; 8 rapid~ Z0.748;"
     " 8 line~ Z0.241; 8 rapid~ Z0.495; 8 line~ Z0; 8 rapid~ Z1; 9 rapid Z0; 10 rapid~ Z1;"
     " 10 line~ Z0.9; 10 rapid~ Z1; 10 line~ Z0.8; 10 rapid~ Z1; 10 line~ Z0.7; 10 rapid~ Z1;"
     " 10 rapid~ Z0.954; 10 line~ Z0.6; 10 rapid~ Z1; 10 rapid~ Z0.854; 10 line~ Z0.5;"
     " 10 rapid~ Z1; 10 rapid~ Z0.754; 10 line~ Z0.4; 10 rapid~ Z1; 10 rapid~ Z0.654;"
     " 10 line~ Z0.3; 10 rapid~ Z1; 10 rapid~ Z0.554; 10 line~ Z0.2; 10 rapid~ Z1;"
     " 10 rapid~ Z0.454; 10 line~ Z0.1; 10 rapid~ Z1; 10 rapid~ Z0.354; 10 line~ Z0;"
     " 10 rapid~ Z1; 11 rapid~ X2; 11 line~ Z0; 11 dwell for 1; 11 rapid~ Z1; 11 line~ Z0;"
     " 11 dwell for 1; 11 rapid~ Z1; 12 rapid~ X3; 12 line~ Z0; 12 line~ Z1; 12 line~ Z0;"
     " 12 line~ Z1; 13 rapid~ X4; 13 line~ Z0; 13 out M5 S0; 13 rapid~ Z1; 13 out M3 S60;"
     " 13 line~ Z0; 13 out M5 S0; 13 rapid~ Z1; 13 out M3 S60; 14 rapid~ X5; 14 line~ Z0;"
     " 14 dwell for 1; 14 line~ Z1; 14 line~ Z0; 14 dwell for 1; 14 line~ Z1"},
    {"G17 G0 Z5 F60 S60 M4\nG18 G81 X1 Z1 Y-1 R1\nG98 G82 X1 Z1 Y-1 R1 P1\nG19 G0 X5 G80\n"
     "G99 G85 Y1 Z1 X-1 R1\nG98 X-2 Y3\nG17 G98\nG86 X1 Y1 Z-1 R1 P1\nM5 G89 X1 Z-1 R1 P1\n",
     "1 out S60; 1 out M4 S60; 1 rapid Z5; 2 rapid~ Y1; 2 rapid~ X1 Z1; 2 line~ Y-1 F60;"
     " 2 rapid~ Y1; 3 line~ Y-1; 3 dwell for 1; 3 rapid~ Y1; 4 rapid X5; 5 rapid~ X1;"
     " 5 line~ X-1; 5 line~ X1; 6 rapid~ Y3; 6 line~ X-2; 6 line~ X1; 6 rapid~ X5;"
     " 8 rapid~ X1 Y1; 8 line~ Z-1; 8 dwell for 1; 8 out M5 S0; 8 rapid~ Z1; 8 out M4 S60;"
     " 9 out M5 S0; 9 line~ Z-1; 9 dwell for 1; 9 line~ Z1"},
    {"G95 F.1 S60 M3 G0 Z5\nG81 X1 Z-1 R1\nM5\nX2\nM3 X3\n",
     "1 out S60 per-rev; 1 out M3 S60; 1 rapid Z5; 2 rapid~ X1; 2 rapid~ Z1; 2 line~ Z-1 F0.1;"
     " 2 rapid~ Z1; 3 out M5 S0; !4:0 feed-missing S; 5 out M3 X2 S60; 5 rapid~ X3;"
     " 5 line~ Z-1; 5 rapid~ Z1"},
    {"G10 L2 P1 Z10\nG0 Z5 F60\nG98 G81 X1 Z-1 R1\nG10 L2 P1 Z20\nX2\nG92 Z0\nX3\nG92.1\nX4\n"
     "G54 X5\n",
     "2 rapid Z15; 3 rapid~ X1; 3 rapid~ Z11; 3 line~ Z9 F60; 3 rapid~ Z15; 5 rapid~ Z21;"
     " 5 rapid~ X2; 5 line~ Z19; 5 rapid~ Z25; 7 rapid~ Z26; 7 rapid~ X3; 7 line~ Z24;"
     " 7 rapid~ Z30; 9 rapid~ X4; 9 rapid~ Z21; 9 line~ Z19; 9 rapid~ Z25; 10 rapid~ X5;"
     " 10 rapid~ Z21; 10 line~ Z19; 10 rapid~ Z25"},
    {"G0 Z5 F60\nG81 X1 Z-1 R1 G53\nG81 X1 Z-1 R1 P1\nG82 X1 Z-1 R1 P1 Q1\nG81 X1 Z-1 R1 H1\n"
     "G81 X1 Z-1 R1 J1\nG85 X1 Z-1 R1 P1\nG84 X1 Z-1 R1\nS0 M3\nG84 X1 Z-1 R1\nS60 M4\n"
     "G84 X1 Z-1 R1\nG74 X1 Z-1 R1 P1\nG74 X2 Z-1 R1 P-1\nG64 G81 X3 Z-1 R1 P1\nG41.1 D2\n"
     "G81 X1 Z-1 R1\nG40\n",
     "1 rapid Z5; !2:15 word-missing G 53/0; !3:15 word-unused P; !4:18 word-unused Q;"
     " !5:15 word-unused H; !6:15 word-unused J; !7:15 word-unused P; !8:1 word-missing M;"
     " 9 out S0; 9 out M3; !10:1 thread-speed S; 11 out S60 S60; 11 out M4;"
     " !12:1 word-missing M; 13 rapid~ X1; 13 rapid~ Z1;"
     " 13 tap by 0 0 -2 lead 1 dwell 1 for 5.543; !14:15 number-range P -1/1000000;"
     " 15 rapid~ X3; 15 line~ Z-1 F60; 15 rapid~ Z1; 16 comp G17 1 nose 0 0 P1 Q1;"
     " !17:0 comp-on G 81/0; 18 comp G17 0 nose 0 0"},
};

static void cycles_follow_each_other(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, cyc2_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, turning_pecking_threading_by_every_word);
    CHECK_RUN(&check, a_state_comes_back_as_it_was);
    CHECK_RUN(&check, cycles_follow_each_other);
    return check_end(&check);
}
