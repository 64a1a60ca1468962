// SPDX-License-Identifier: MIT
// Room 1: lines of lathes, and all that they are told to do.
#include "told_check.h"

static told_t self;

static const told_row_t lathe_rows[] = {
    {"G7 G0 X10 Z5\nG1 X4 F100\nG8 X4\nG7 G91 X2\nG2 X10 Z0 I1 K2\nG90 G3 X20 Z-5 R5\n",
     "1 rapid X5 Z5; 2 line X2 F100; 3 line X4; 4 line X5;"
     " !5:1 arc-radius 4.47213595/2.23606798; 6 arc X10 Z-5 G18 about 0 10 by 180"},
    {"G18 G0 X10 Z5 S300 M3\nG33 Z-5 K1.5\nG33 X12 K1\nG33 X10 Z5 K2\nG33 Z0\nG33 Z-5 K0\n"
     "G33 K1\nS0\nG33 Z-9 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X10 Z5; 2 thread Z-5 of 10 lead 1.5 for 1.492;"
     " 3 thread X12 of 2 lead 1 for 0.5481; 4 thread X10 Z5 of 10.198039 lead 2 for 1.188;"
     " !5:1 word-missing K 33/0; !6:9 number-range K 0/1000000; 8 out S0 S0;"
     " !9:1 thread-speed S"},
    {"G0 X10 Z5\nG33 Z-5 K1\nM3\nG33 Z-5 K1\nS100\nG33 Z-10 K1\nG33 Z10 K1 X100\n"
     "G96 S100 D500\nG33 Z1 K1\n",
     "1 rapid X10 Z5; !2:1 thread-speed S; 3 out M3; !4:1 thread-speed S; 5 out S100 S100;"
     " 6 thread Z-10 of 15 lead 1 for 9.328; 7 thread X100 Z10 of 92.1954446 lead 1 for 55.65;"
     " 8 out surface 100000 S500 V100000; !9:1 thread-speed G 96/0"},
    {"G0 X10 Z5 S300 M3\nG33.1 Z-5 K1.5\nG33.1 X5 K1\nG33.1 K1\nM5\nG33.1 Z-6 K1\nM4\n"
     "G33.1 Z-6 K2\n",
     "1 out S300; 1 out M3 S300; 1 rapid X10 Z5; 2 tap by 0 0 -10 lead 1.5 for 2.885;"
     " 3 tap by -5 0 0 lead 1 for 2.196; !4:1 word-missing Z 33.1/0; 5 out M5 S0;"
     " !6:1 thread-speed S; 7 out M4 S300; 8 tap by 0 0 -11 lead 2 for 2.436"},
    {"G0 X20 Z5 S300 M3\nG76 P1.5 Z-20 I-2 J.4 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Z5; 2 rapid~ X17.6;"
     " 2 thread Z-20 of 25 lead 1.5 for 3.492; 2 rapid~ X20; 2 rapid~ Z5; 2 rapid~ X17.2;"
     " 2 thread Z-20 of 25 lead 1.5 for 3.492; 2 rapid~ X20; 2 rapid~ Z5; 2 rapid~ X17;"
     " 2 thread Z-20 of 25 lead 1.5 for 3.492; 2 rapid~ X20"},
    {"G0 X20 Z5 S300 M3\nG76 P1.5 Z-20 I-2 J.5 K1 H2 Q30 R2\nG0 Z5\n"
     "G76 P1.5 Z-20 I-2 J1 K1 L1 E2\nG0 Z5\nG76 P1.5 Z-20 I-2 J1 K1 L2 E2\nG0 Z5\n"
     "G76 P1.5 Z-20 I-2 J1 K1 L3 E2\nG0 Z5\nG7 G76 P1.5 Z-20 I-4 J2 K2\nG0 Z5\n"
     "G8 G76 P1 Z20 I2 J1 K1 Q20\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Z5; 2 rapid~ Z4.711325; 2 rapid~ X17.5;"
     " 2 thread Z-19.711325 of 24.42265 lead 1.5 for 3.415; 2 rapid~ X20; 2 rapid~ Z4.591752;"
     " 2 rapid~ X17.292893; 2 thread Z-19.830898 of 24.42265 lead 1.5 for 3.415; 2 rapid~ X20;"
     " 2 rapid~ Z4.5; 2 rapid~ X17.133975; 2 thread Z-19.92265 of 24.42265 lead 1.5 for 3.415;"
     " 2 rapid~ X20; 2 rapid~ Z4.42265; 2 rapid~ X17;"
     " 2 thread Z-20 of 24.42265 lead 1.5 for 3.415; 2 rapid~ X20; 2 rapid~ Z4.42265;"
     " 2 rapid~ X17; 2 thread Z-20 of 24.42265 lead 1.5 for 3.415; 2 rapid~ X20;"
     " 2 rapid~ Z4.42265; 2 rapid~ X17; 2 thread Z-20 of 24.42265 lead 1.5 for 3.415;"
     " 2 rapid~ X20; 3 rapid Z5; 4 rapid~ X18;"
     " 4 thread X17 Z-20 of 25 lead 1.5 in -1 over 2 for 3.492; 4 rapid~ X20; 5 rapid Z5;"
     " 6 rapid~ X17; 6 thread X20 Z-20 of 25 lead 1.5 out 3 over 2 for 3.492; 7 rapid Z5;"
     " 8 rapid~ X18; 8 thread X20 Z-20 of 25 lead 1.5 in -1 over 2 out 3 over 2 for 3.492;"
     " 9 rapid Z5; 10 rapid~ X17; 10 thread Z-20 of 25 lead 1.5 for 3.492; 10 rapid~ X20;"
     " 11 rapid Z5; 12 rapid~ Z5.36397; 12 rapid~ X23;"
     " 12 thread Z20 of 14.63603 lead 1 for 3.075; 12 rapid~ X20"},
    {"G0 X20 Z5 S300 M3\nG76 P1.5 Z-20 I-2 J.4\nG76 P1.5 Z-20 I-2 K1\nG76 P1.5 Z-20 J.4 K1\n"
     "G76 P1.5 I-2 J.4 K1\nG76 Z-20 I-2 J.4 K1\nG76 P0 Z-20 I-2 J.4 K1\n"
     "G76 P1.5 Z-20 I-2 J0 K1\nG76 P1.5 Z-20 I-2 J.4 K-1\nG76 P1.5 Z-20 I-2 J.4 K1 R.5\n"
     "G76 P1.5 Z-20 I-2 J.4 K1 Q81\nG76 P1.5 Z-20 I-2 J.4 K1 Q-1\nG76 P1.5 Z-20 I-2 J.4 K1 L4\n"
     "G76 P1.5 Z-20 I-2 J.4 K1 L1\nG76 P1.5 Z-20 I-2 J.4 K1 L1 E0\n"
     "G76 P1.5 Z-20 I-2 J.4 K1 H-1\nG76 P1.5 Z-20 I-2 J.4 K1 H1.5\n"
     "G76 P1.5 Z-20 I1000001 J.4 K1\nG76 P1.5 Z-20 I-2 J.0001 K100\n"
     "G93 G76 P1.5 Z-20 I-2 J.4 K1\n",
     "1 out S300; 1 out M3 S300; 1 rapid X20 Z5; !2:1 word-missing K 76/0;"
     " !3:1 word-missing J 76/0; !4:1 word-missing I 76/0; !5:1 word-missing Z 76/0;"
     " !6:1 word-missing P 76/0; !7:5 number-range P 0/1000000; !8:19 number-range J;"
     " !9:23 number-range K -1/0; !10:26 number-range R 0.5/1; !11:26 number-range Q 81/80;"
     " !12:26 number-range Q -1/80; !13:26 number-range L 4/3; !14:1 word-missing E 76/0;"
     " !15:29 number-range E; !16:26 number-range H -1/1000; !17:26 number-range H 1.5/1000;"
     " !18:15 number-range I 1000001/1000000; !19:19 number-range J 0.0001/100;"
     " !20:0 unsupported G 93/0"},
    {"G96 S100 M3 G0 X20\nG96 S100 D2000 M3\nG0 X10\nG97 S500 X20\nG96 S200 D1000 G7 X10\n"
     "G20 S100 X1\nG96 D500 S10\nG96 D-1 S10\nG96 D1 S-10\nG96 S1e6\nG96 S1000000 D9\nG97\n"
     "G97 S200\n",
     "!1:1 speed-limit D 96/0; 2 out surface 100000; 2 out M3 S2000 V100000; 3 rapid X10;"
     " 4 out S500 S500 V0; 4 rapid X20; 5 out surface 200000 S1000 V200000; 5 rapid X5;"
     " 6 out surface 30480 V30480; 6 rapid X12.7; 7 out surface 3048 S500 V3048;"
     " !8:5 number-range D -1/1e+09; !9:8 number-range S -10/3280839.9; !10:7 word-unknown E;"
     " 11 out surface 304800000 S9 V304800000; 12 out S9 V0; 13 out S200 S200"},
    {"G95 F.2 S300 M3 G1 X10\nZ-5 F.1\nG96 S100 D1000\nX20\nG20 F.01 X1\nG94 X2 F5\n",
     "1 out S300 per-rev; 1 out M3 S300; 1 line X10 F0.2; 2 line Z-5 F0.1;"
     " 3 out surface 100000 S1000 V100000; 4 line X20; ?5:0 feed-units; 5 line X25.4 F0.01;"
     " 6 line X50.8 F127 per-min"},
    {"O1 sub\nG0 X10\nG1 Z-10 F1\nX14\nZ-20\nO1 endsub\nG0 X20 Z2\n"
     "G71 Q1 X20 Z2 D2 I.5 R.5 F100\nG70 Q1 X20 Z2 F50\n",
     "7 rapid X20 Z2; 8 rapid~ X19.5; 8 line~ Z-20 F100; 8 rapid~ X20 Z-19.5; 8 rapid~ Z2;"
     " 8 rapid~ X19; 8 line~ Z-20; 8 rapid~ X19.5 Z-19.5; 8 rapid~ Z2; 8 rapid~ X18.5;"
     " 8 line~ Z-20; 8 rapid~ X19 Z-19.5; 8 rapid~ Z2; 8 rapid~ X18; 8 line~ Z-20;"
     " 8 rapid~ X18.5 Z-19.5; 8 rapid~ Z2; 8 rapid~ X17.5; 8 line~ Z-20; 8 rapid~ X18 Z-19.5;"
     " 8 rapid~ Z2; 8 rapid~ X17; 8 line~ Z-20; 8 rapid~ X17.5 Z-19.5; 8 rapid~ Z2;"
     " 8 rapid~ X16.5; 8 line~ Z-20; 8 rapid~ X17 Z-19.5; 8 rapid~ Z2; 8 rapid~ X16;"
     " 8 line~ Z-20; 8 rapid~ X16.5 Z-19.5; 8 rapid~ Z2; 8 rapid~ X15.5; 8 line~ Z-8.677124;"
     " 8 rapid~ X16 Z-8.177124; 8 rapid~ Z2; 8 rapid~ X15; 8 line~ Z-8.267949;"
     " 8 rapid~ X15.5 Z-7.767949; 8 rapid~ Z2; 8 rapid~ X14.5; 8 line~ Z-8.063508;"
     " 8 rapid~ X15 Z-7.563508; 8 rapid~ Z2; 8 rapid~ X14; 8 line~ Z-8; 8 rapid~ X14.5 Z-7.5;"
     " 8 rapid~ Z2; 8 rapid~ X13.5; 8 line~ Z-8; 8 rapid~ X14 Z-7.5; 8 rapid~ Z2; 8 rapid~ X13;"
     " 8 line~ Z-8; 8 rapid~ X13.5 Z-7.5; 8 rapid~ Z2; 8 rapid~ X12.5; 8 line~ Z-8;"
     " 8 rapid~ X13 Z-7.5; 8 rapid~ Z2; 8 rapid~ X12; 8 line~ Z-8; 8 rapid~ X12.5 Z-7.5;"
     " 8 rapid~ Z6.1; 8 line X14.1; 8 comp G18 -2 nose 0 0; 8 line X10; 8 line Z2; 8 line Z-10;"
     " 8 line X14; 8 line Z-20; 8 comp G18 0 nose 0 0; 8 rapid~ X20; 8 rapid~ Z2; 9 rapid~ X10;"
     " 9 line Z-10 F50; 9 line X14; 9 line Z-20; 9 rapid~ X20; 9 rapid~ Z2"},
    {"O1 sub\nG0 Z-10\nG1 X10 F1\nZ2\nO1 endsub\nG0 X20 Z2\nG72 Q1 X20 Z2 D4 I.5 R.5 F100\n",
     "6 rapid X20 Z2; 7 rapid~ Z1.5; 7 line~ X14 F100; 7 rapid~ X14.5 Z2; 7 rapid~ X20;"
     " 7 rapid~ Z1; 7 line~ X14; 7 rapid~ X14.5 Z1.5; 7 rapid~ X20; 7 rapid~ Z0.5; 7 line~ X14;"
     " 7 rapid~ X14.5 Z1; 7 rapid~ X20; 7 rapid~ Z0; 7 line~ X14; 7 rapid~ X14.5 Z0.5;"
     " 7 rapid~ X20; 7 rapid~ Z-0.5; 7 line~ X14; 7 rapid~ X14.5 Z0; 7 rapid~ X20;"
     " 7 rapid~ Z-1; 7 line~ X14; 7 rapid~ X14.5 Z-0.5; 7 rapid~ X20; 7 rapid~ Z-1.5;"
     " 7 line~ X14; 7 rapid~ X14.5 Z-1; 7 rapid~ X20; 7 rapid~ Z-2; 7 line~ X14;"
     " 7 rapid~ X14.5 Z-1.5; 7 rapid~ X20; 7 rapid~ Z-2.5; 7 line~ X14; 7 rapid~ X14.5 Z-2;"
     " 7 rapid~ X20; 7 rapid~ Z-3; 7 line~ X14; 7 rapid~ X14.5 Z-2.5; 7 rapid~ X20;"
     " 7 rapid~ Z-3.5; 7 line~ X14; 7 rapid~ X14.5 Z-3; 7 rapid~ X20; 7 rapid~ Z-4;"
     " 7 line~ X14; 7 rapid~ X14.5 Z-3.5; 7 rapid~ X20; 7 rapid~ Z-4.5; 7 line~ X14;"
     " 7 rapid~ X14.5 Z-4; 7 rapid~ X20; 7 rapid~ Z-5; 7 line~ X14; 7 rapid~ X14.5 Z-4.5;"
     " 7 rapid~ X20; 7 rapid~ Z-5.5; 7 line~ X14; 7 rapid~ X14.5 Z-5; 7 rapid~ X20;"
     " 7 rapid~ Z-6; 7 line~ X14; 7 rapid~ X14.5 Z-5.5; 7 rapid~ X28.2; 7 line Z-1.8;"
     " 7 comp G18 4 nose 0 0; 7 line Z-10; 7 line X20; 7 line X10; 7 line Z2;"
     " 7 comp G18 0 nose 0 0; 7 rapid~ X14; 7 rapid~ X20"},
};

static void a_lathe_does_what_it_is_told(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_lathe(&self);
    TOLD(check, &self, lathe_rows);
}

static const told_row_t fla_rows[] = {
    {"S500 M3\nG0 X10. Z5.\nG1 U2. W-1. F.1\nX20. Z0.\nU-2.\nG98 Z-1. F100\nG99 Z-2. F.2\n"
     "G2 X30. Z-5. R5.\nG3 X20. I-5. K0.\n",
     "1 out S500 per-rev; 1 out M3 S500; 2 rapid X5 Z5; 3 line X6 Z4 F0.1; 4 line X10 Z0;"
     " 5 line X9; 6 line Z-1 F100 per-min; 7 line Z-2 F0.2 per-rev;"
     " 8 arc X15 Z-5 G18 about -0.18338 13.65831 by -84.2608; !9:1 arc-radius 0/5"},
    {"G0 X30. Z2. F.2 S500 M3\nG90 X28. Z-10.\nX26.\nU-6. W-8.\nR-1. X24.\nG94 X20. Z-2.\n"
     "Z-4.\nR1. Z-6.\nG0 X50.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 2 rapid~ X14; 2 line~ Z-10 F0.2;"
     " 2 line~ X15; 2 rapid~ Z2; 3 rapid~ X13; 3 line~ Z-10; 3 line~ X15; 3 rapid~ Z2;"
     " 4 rapid~ X12; 4 line~ Z-6; 4 line~ X15; 4 rapid~ Z2; 5 rapid~ X11; 5 line~ X12 Z-6;"
     " 5 line~ X15; 5 rapid~ Z2; 6 rapid~ Z-2; 6 line~ X10; 6 line~ Z2; 6 rapid~ X15;"
     " 7 rapid~ Z-4; 7 line~ X10; 7 line~ Z2; 7 rapid~ X15; 8 rapid~ Z-5; 8 line~ X10 Z-6;"
     " 8 line~ Z2; 8 rapid~ X15; 9 rapid X25"},
    {"G0 X30. Z2. S500 M3\nG92 X28. Z-10. F1.5\nX27.\nX26. R-1.\nU-8.\nG0 X40.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 2 rapid~ X14;"
     " 2 thread Z-10 of 12 lead 1.5 for 1.096; 2 rapid~ X15; 2 rapid~ Z2; 3 rapid~ X13.5;"
     " 3 thread Z-10 of 12 lead 1.5 for 1.096; 3 rapid~ X15; 3 rapid~ Z2; 4 rapid~ X12;"
     " 4 thread X13 Z-10 of 12 lead 1.5 for 1.096; 4 rapid~ X15; 4 rapid~ Z2; 5 rapid~ X10;"
     " 5 thread X11 Z-10 of 12 lead 1.5 for 1.096; 5 rapid~ X15; 5 rapid~ Z2; 6 rapid X20"},
    {"G0 X30. Z2. S500 M3\nG32 Z-10. F1.5\nG32 X34. Z-20. F2.\nG32 U4.\nG32 Z-1. F1. Q90000\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2;"
     " 2 thread Z-10 of 12 lead 1.5 for 1.096; 3 thread X17 Z-20 of 10 lead 2 for 0.7487;"
     " 4 thread X19 of 2 lead 2 for 0.2678; 5 thread Z-1 of 19 lead 1 at 0.25 for 2.402"},
    {"G0 X30. Z2. S500 M3\nG76 P020060 Q100 R.05\nG76 X26. Z-20. P2000 Q1000 F2.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ Z1.42265; 3 rapid~ X14;"
     " 3 thread Z-19.42265 of 20.8453 lead 2 for 1.399; 3 rapid~ X15; 3 rapid~ Z1.183503;"
     " 3 rapid~ X13.585786; 3 thread Z-19.661796 of 20.845299 lead 2 for 1.399; 3 rapid~ X15;"
     " 3 rapid~ Z1; 3 rapid~ X13.267949; 3 thread Z-19.845299 of 20.845299 lead 2 for 1.399;"
     " 3 rapid~ X15; 3 rapid~ Z0.874167; 3 rapid~ X13.05;"
     " 3 thread Z-19.971132 of 20.845299 lead 2 for 1.399; 3 rapid~ X15; 3 rapid~ Z0.845299;"
     " 3 rapid~ X13; 3 thread Z-20 of 20.845299 lead 2 for 1.399; 3 rapid~ X15;"
     " 3 rapid~ Z0.845299; 3 rapid~ X13; 3 thread Z-20 of 20.845299 lead 2 for 1.399;"
     " 3 rapid~ X15; 3 rapid~ Z2"},
    {"G0 X30. Z2. S500 M3\nG76 P011029 Q100 R.05\nG76 X26. Z-20. R-1. P1500 Q800 F1.5\n"
     "G76 P010060 Q300\nG76 X26. Z-20. P2000 Q900\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ Z1.793106; 3 rapid~ X12.7;"
     " 3 thread X15 Z-19.818968 of 21.612074 lead 1.5 out 1.3 over 1.5 for 1.92;"
     " 3 rapid~ Z1.707408; 3 rapid~ X12.368629;"
     " 3 thread X15 Z-19.904666 of 21.612074 lead 1.5 out 1.631371 over 1.5 for 1.937;"
     " 3 rapid~ Z1.641649; 3 rapid~ X12.114359;"
     " 3 thread X15 Z-19.970425 of 21.612074 lead 1.5 out 1.885641 over 1.5 for 1.948;"
     " 3 rapid~ Z1.625005; 3 rapid~ X12.05;"
     " 3 thread X15 Z-19.987069 of 21.612074 lead 1.5 out 1.95 over 1.5 for 1.951;"
     " 3 rapid~ Z1.612074; 3 rapid~ X12;"
     " 3 thread X15 Z-20 of 21.612074 lead 1.5 out 2 over 1.5 for 1.953; 3 rapid~ Z2;"
     " 5 rapid~ Z1.480385; 5 rapid~ X14.1; 5 thread Z-19.364915 of 20.8453 lead 1.5 for 1.804;"
     " 5 rapid~ X15; 5 rapid~ Z1.265153; 5 rapid~ X13.727208;"
     " 5 thread Z-19.580146 of 20.845299 lead 1.5 for 1.804; 5 rapid~ X15; 5 rapid~ Z1.091948;"
     " 5 rapid~ X13.427208; 5 thread Z-19.753351 of 20.845299 lead 1.5 for 1.804; 5 rapid~ X15;"
     " 5 rapid~ Z0.918743; 5 rapid~ X13.127208;"
     " 5 thread Z-19.926557 of 20.8453 lead 1.5 for 1.804; 5 rapid~ X15; 5 rapid~ Z0.874167;"
     " 5 rapid~ X13.05; 5 thread Z-19.971132 of 20.845299 lead 1.5 for 1.804; 5 rapid~ X15;"
     " 5 rapid~ Z0.845299; 5 rapid~ X13; 5 thread Z-20 of 20.845299 lead 1.5 for 1.804;"
     " 5 rapid~ X15; 5 rapid~ Z2"},
    {"G0 X30. Z2. S500 M3\nG76 X26. Z-20. K2. D1. F2. A60\nG76 X26. Z-20. I-1. K2. D1.0 F2.\n"
     "G76 X26. Z-20. K2. D1.5 F2. A55\nG76 X26. Z-20. K2. D2.0 F2. A121\n"
     "G76 X26. Z-20. K0 D2.0 F2.\nG76 X26. K2. D2.0 F2.\nG76 Z-20. K2. D2.0 F2.\n"
     "G76 X26. Z-20. K2. F2.\nG76 X26. Z-20. K2. D2.0\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:20 number-range D 1/0;"
     " 3 rapid~ X13; 3 thread X14 Z-20 of 22 lead 2 for 1.468; 3 rapid~ X15; 3 rapid~ Z2;"
     " 3 rapid~ X12.585786; 3 thread X13.585786 Z-20 of 22 lead 2 for 1.468; 3 rapid~ X15;"
     " 3 rapid~ Z2; 3 rapid~ X12.267949; 3 thread X13.267949 Z-20 of 22 lead 2 for 1.468;"
     " 3 rapid~ X15; 3 rapid~ Z2; 3 rapid~ X12; 3 thread X13 Z-20 of 22 lead 2 for 1.468;"
     " 3 rapid~ X15; 3 rapid~ Z2; 4 rapid~ Z1.219149; 4 rapid~ X13.5;"
     " 4 thread Z-19.739716 of 20.958865 lead 2 for 1.405; 4 rapid~ X15; 4 rapid~ Z0.958866;"
     " 4 rapid~ X13; 4 thread Z-20 of 20.958866 lead 2 for 1.405; 4 rapid~ X15; 4 rapid~ Z2;"
     " !5:29 number-range A 121/120; !6:16 number-range K; !7:1 word-missing Z 76/0;"
     " !8:1 word-missing X 76/0; !9:1 word-missing D 76/0; 10 rapid~ X13;"
     " 10 thread Z-20 of 22 lead 2 for 1.468; 10 rapid~ X15; 10 rapid~ Z2"},
    {"G0 X30. Z2. F.2 S500 M3\nG74 R1.\nG74 Z-10. Q4000\nG74 X26. Z-5. P1000 Q3000 R.5\n"
     "G75 R.5\nG75 X20. P2000\nG75 X24. Z-3. P2000 Q2000 R0\nG74 Z-10. Q-1\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 line~ Z-2 F0.2; 3 rapid~ Z-1;"
     " 3 line~ Z-6; 3 rapid~ Z-5; 3 line~ Z-10; 3 rapid~ Z2; !4:27 unsupported G 74/0;"
     " 6 line~ X13; 6 rapid~ X13.5; 6 line~ X11; 6 rapid~ X11.5; 6 line~ X10; 6 rapid~ X15;"
     " 7 line~ X13; 7 rapid~ X13.5; 7 line~ X12; 7 rapid~ X15; 7 rapid~ Z0; 7 line~ X13;"
     " 7 rapid~ X13.5; 7 line~ X12; 7 rapid~ X15; 7 rapid~ Z-2; 7 line~ X13; 7 rapid~ X13.5;"
     " 7 line~ X12; 7 rapid~ X15; 7 rapid~ Z-3; 7 line~ X13; 7 rapid~ X13.5; 7 line~ X12;"
     " 7 rapid~ X15; 7 rapid~ Z2; !8:11 number-range Q -1/0"},
    {"G50 S2000\nG96 S100 M3\nG0 X20.\nG97 S300\nG50 X10. Z5.\nX10.\nG0 X12. Z6.\nG28 U0 W0\n"
     "G28 X30.\nG30 U0\n",
     "2 out surface 100000 per-rev; 2 out M3 S2000 V100000; 3 rapid X10; 4 out S300 S300 V0;"
     " 6 rapid axis5; 7 rapid X11 Z1; 8 rapid; 8 rapid X0 Z0; 9 rapid X20; 9 rapid X0;"
     " 10 rapid; 10 rapid"},
    {"G0 X30. Z2. S500 M3\nG71 U2. R1.\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X10. \nG1 Z-10. F.1\n"
     "X14.\nN20 Z-20.\nG70 P10 Q20\nG0 X50.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ X13; 3 line~ Z-19.9 F0.2;"
     " 3 rapid~ X14 Z-18.9; 3 rapid~ Z2; 3 rapid~ X11; 3 line~ Z-19.9; 3 rapid~ X12 Z-18.9;"
     " 3 rapid~ Z2; 3 rapid~ X9; 3 line~ Z-19.9; 3 rapid~ X10 Z-18.9; 3 rapid~ Z2; 3 rapid~ X7;"
     " 3 line~ Z-9.9; 3 rapid~ X8 Z-8.9; 3 rapid~ Z2; 3 rapid~ X5.2; 3 line~ Z-9.9;"
     " 3 rapid~ X6.2 Z-8.9; 3 rapid~ Z2.1; 3 line X5.2; 3 line Z-9.9; 3 line X7.2;"
     " 3 line Z-19.9; 3 rapid~ X15; 3 rapid~ Z2; 4 rapid X5; 5 line Z-10 F0.1; 6 line X7;"
     " 7 line Z-20; 8 rapid~ X15 Z2; 9 rapid X25"},
    {"G0 X30. Z2. S500 M3\nG72 W2. R1.\nG72 P10 Q20 U.4 W.1 F.2\nN10 G0 Z-8.\nG1 X20. F.1\n"
     "X10. Z0.\nN20 Z2.\nG70 P10 Q20\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ Z0; 3 line~ X5.2625 F0.2;"
     " 3 rapid~ X6.2625 Z1; 3 rapid~ X15; 3 rapid~ Z-2; 3 line~ X6.5125; 3 rapid~ X7.5125 Z-1;"
     " 3 rapid~ X15; 3 rapid~ Z-4; 3 line~ X7.7625; 3 rapid~ X8.7625 Z-3; 3 rapid~ X15;"
     " 3 rapid~ Z-6; 3 line~ X9.0125; 3 rapid~ X10.0125 Z-5; 3 rapid~ X15; 3 rapid~ Z-7.9;"
     " 3 line~ X10.2; 3 rapid~ X11.2 Z-6.9; 3 rapid~ X15.2; 3 line Z-7.9; 3 line X10.2;"
     " 3 line X5.2 Z0.1; 3 line Z2.1; 3 rapid~ X15; 3 rapid~ Z2; 4 rapid Z-8; 5 line X10 F0.1;"
     " 6 line X5 Z0; 7 line Z2; 8 rapid~ X15"},
    {"G0 X30. Z2. S500 M3\nG73 U4. W1. R3\nG73 P10 Q20 U.4 W.1 F.2\nN10 G0 X10. \nG1 Z-5. F.1\n"
     "G3 X20. Z-10. R5.\nN20 G1 X26.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ X19.2 Z3.1; 3 rapid~ X9.2;"
     " 3 line Z-3.9 F0.2; 3 arc X14.2 Z-8.9 G18 about -8.9 9.2 by 90; 3 line X17.2;"
     " 3 rapid~ Z2.6; 3 rapid~ X7.2; 3 line Z-4.4; 3 arc X12.2 Z-9.4 G18 about -9.4 7.2 by 90;"
     " 3 line X15.2; 3 rapid~ Z2.1; 3 rapid~ X5.2; 3 line Z-4.9;"
     " 3 arc X10.2 Z-9.9 G18 about -9.9 5.2 by 90; 3 line X13.2; 3 rapid~ X15 Z2"},
    {"G0 X30. Z2. F.1 S500 M3\nG71 P10 Q20 \nG71 U0 R1.\nG71 U2. R-1.\nG71 P10 Q30 U.4\n"
     "N10 G0 X10.\nN20 X20.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:1 word-missing U;"
     " !3:5 number-range U; !4:9 number-range R -1/0; !8:1 contour M 2/0;"
     " !5:0 label-missing 30/100"},
    {"G0 X20. Z0 S500 M3\nG1 X30. ,R2. F.1\nZ-10. ,C1.\nX40.\nX50. K-2.\nZ-30.\nZ-40. I1.\n"
     "X70.\nZ-50. R2.\nX90.\nX95. R-2.\nZ-45.\nX100. K2. I2.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X10; 2 line X13 F0.1;"
     " 2 arc X15 Z-2 G18 about -2 13 by 90; 3 line Z-9; 3 line X16 Z-10; 4 line X20;"
     " 5 line X23; 5 line X25 Z-12; 6 line Z-30; 7 line Z-39; 7 line X26 Z-40; 8 line X35;"
     " 9 line Z-48; 9 arc X37 Z-50 G18 about -48 37 by -90; 10 line X45; !11:6 corner R -2/0;"
     " !13:7 word-unused K"},
};

static void a_lathe_of_fanucs_does_what_it_is_told(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, fla_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_lathe_does_what_it_is_told);
    CHECK_RUN(&check, a_lathe_of_fanucs_does_what_it_is_told);
    return check_end(&check);
}
